// Canonical sums in several rewritings, and the angle in a product of atoms.
#include "forms/write/real_terms.hpp"

#include <catch2/catch.hpp>

#include "forms/present/polynomial.hpp"
#include "program/expression_leaves.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

ClosedForms forms_of(const char* text) { return present(program_of(Texts{text})); }

std::vector<RealTerm> terms_of(const ClosedForms& forms, Trigonometry trigonometry) {
  const Fraction& form = *forms.functions[0].fields[0].entries[0];
  return *real_terms(forms.algebra, form.numerator, trigonometry, 100);
}

}  // namespace

TEST_CASE("one function in multiple angles, by sines and by cosines") {
  const ClosedForms forms = forms_of("sin(a)^2");
  CHECK(terms_of(forms, Trigonometry::multiple_angles).size() == 2);
  const auto by_sines = terms_of(forms, Trigonometry::directions_by_sines);
  REQUIRE(by_sines.size() == 1);
  CHECK(by_sines[0].coefficient == 1);
  REQUIRE(by_sines[0].circular.size() == 1);
  CHECK(by_sines[0].circular[0].sine == 2);
  CHECK(by_sines[0].circular[0].cosine == 0);
  const auto by_cosines = terms_of(forms, Trigonometry::units_by_cosines);
  REQUIRE(by_cosines.size() == 2);
  CHECK(by_cosines[0].coefficient + by_cosines[1].coefficient == 0);
}

TEST_CASE("exponentials of several angles share their products of sines and cosines") {
  const ClosedForms sum =
      forms_of("cos(a + b + c) + cos(a + b - c) + cos(a - b + c) + cos(a - b - c)");
  const auto one = terms_of(sum, Trigonometry::units_by_cosines);
  REQUIRE(one.size() == 1);
  CHECK(one[0].coefficient == 4);
  REQUIRE(one[0].circular.size() == 3);
  for (const CircularPower& power : one[0].circular) CHECK(power.cosine == 1);
  const ClosedForms single = forms_of("sin(a + b + c)*(d + e)");
  const auto terms = terms_of(single, Trigonometry::units_by_sines);
  REQUIRE(terms.size() == 8);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(terms[i].circular == terms[i + 4].circular);
    CHECK(terms[i].coefficient == terms[i + 4].coefficient);
    CHECK(terms[i].powers != terms[i + 4].powers);
  }
}

TEST_CASE("a high multiple of an angle is not expanded") {
  const ClosedForms forms = forms_of("cos(2000*a) + cos(a)");
  const Polynomial& sum = forms.functions[0].fields[0].entries[0]->numerator;
  CHECK_FALSE(real_terms(forms.algebra, sum, Trigonometry::units_by_cosines, 10'000));
  CHECK_FALSE(real_terms(forms.algebra, sum, Trigonometry::directions_by_sines, 10'000));
  const auto shortest = shortest_terms(forms.algebra, sum, 100);
  REQUIRE(shortest);
  CHECK(shortest->size() == 2);
}

TEST_CASE("the shortest rewriting is chosen") {
  const ClosedForms forms = forms_of("sin(a)^2");
  const Fraction& form = *forms.functions[0].fields[0].entries[0];
  const auto shortest = shortest_terms(forms.algebra, form.numerator, 100);
  REQUIRE(shortest);
  CHECK(shortest->size() == 1);
  for (const Trigonometry rewriting : trigonometries) {
    CHECK(written_length(forms.algebra, *shortest) <=
          written_length(forms.algebra, terms_of(forms, rewriting)));
  }
}

TEST_CASE("circular atoms form the angle of a monomial, other atoms its powers") {
  Algebra algebra;
  algebra.atoms = {{.kind = AtomKind::leaf}, {.kind = AtomKind::circular}};
  const auto [powers, angle] = split_monomial(algebra, {{0, 2}, {1, -6}});
  CHECK(powers == Monomial{{0, 2}});
  CHECK(angle == Monomial{{1, -6}});
}

TEST_CASE("a direction has no common divisor, and its first component is positive") {
  CHECK(common_divisor({{1, -6}, {2, 4}}) == 2);
  CHECK(common_divisor({}) == 0);
  CHECK(primitive_angle({{1, -6}, {2, 4}}) == Monomial{{1, 3}, {2, -2}});
}

TEST_CASE("(c + i s)(c - i s) = c^2 + s^2") {
  const CircularPolynomial one{{{0, 0}, GaussianRational{1, 0}}};
  const CircularPolynomial square = multiply_by_exponential(multiply_by_exponential(one, 1), -1);
  REQUIRE(square.size() == 2);
  CHECK(square.at({2, 0}).real == 1);
  CHECK(square.at({0, 2}).real == 1);
}
