#include "choose/real_terms.hpp"

#include <catch2/catch.hpp>

#include "lower/read_program.hpp"

using namespace elgen;

namespace {

/// sin(x)^2, over the atoms x and e^(ix).
ClosedForms squared_sine() {
  return present(testing::read_program(
      "parameters m\ncoordinates x y\nfunction bias\n  0 = coordinate x\n  1 = sin 0\n"
      "  2 = multiply 1 1\n  result 1 1 = 2\n"));
}

std::vector<RealTerm> terms_of(const ClosedForms& forms, Trigonometry trigonometry) {
  const Fraction& form = *forms.functions[0].fields[0].entries[0];
  return *real_terms(forms.algebra, form.numerator, trigonometry, 100);
}

}  // namespace

TEST_CASE("one function in multiple angles, by sines and by cosines") {
  const ClosedForms forms = squared_sine();
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

TEST_CASE("a high multiple of an angle is not expanded") {
  const ClosedForms forms = present(testing::read_program(
      "parameters m\ncoordinates x y\nfunction bias\n  0 = coordinate x\n  1 = constant 2000\n"
      "  2 = multiply 1 0\n  3 = cos 2\n  4 = cos 0\n  5 = add 3 4\n  result 1 1 = 5\n"));
  const Polynomial& sum = forms.functions[0].fields[0].entries[0]->numerator;
  CHECK_FALSE(real_terms(forms.algebra, sum, Trigonometry::units_by_cosines, 10'000));
  CHECK_FALSE(real_terms(forms.algebra, sum, Trigonometry::directions_by_sines, 10'000));
  const auto shortest = shortest_terms(forms.algebra, sum, 100);
  REQUIRE(shortest);
  CHECK(shortest->size() == 2);
}

TEST_CASE("the shortest way is taken") {
  const ClosedForms forms = squared_sine();
  const Fraction& form = *forms.functions[0].fields[0].entries[0];
  const auto shortest = shortest_terms(forms.algebra, form.numerator, 100);
  REQUIRE(shortest);
  CHECK(shortest->size() == 1);
  for (const Trigonometry way : trigonometries) {
    CHECK(written_length(forms.algebra, *shortest) <=
          written_length(forms.algebra, terms_of(forms, way)));
  }
}
