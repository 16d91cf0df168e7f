#include "forms/present/polynomial.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

Polynomial term(Monomial monomial, int coefficient) {
  return {{std::move(monomial), Gaussian{coefficient, 0}}};
}

const Polynomial one = constant(1);
const Polynomial x = term({{0, 1}}, 1);
const Polynomial y = term({{1, 1}}, 1);

Polynomial minus(const Polynomial& a, const Polynomial& b) { return sum(a, scaled(b, {-1, 0})); }

bool equal(const Polynomial& a, const Polynomial& b) { return minus(a, b).empty(); }

}  // namespace

TEST_CASE("the order of monomials is that of a group") {
  const MonomialLess less;
  const std::vector<Monomial> ascending{{{0, -1}}, {{0, -1}, {1, 2}}, {{1, -3}}, {},
                                        {{1, 1}},  {{0, 1}, {1, -1}}, {{0, 1}},  {{0, 2}}};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t j = 0; j < ascending.size(); ++j) {
      CHECK(less(ascending[i], ascending[j]) == (i < j));
      for (const Monomial& m : ascending) {
        CHECK(less(product(ascending[i], m), product(ascending[j], m)) == (i < j));
      }
    }
  }
}

TEST_CASE("terms that cancel leave nothing") {
  CHECK(minus(x, x).empty());
  CHECK(constant(0).empty());
  CHECK(product(x, term({{0, -1}}, 1)).begin()->first.empty());
}

TEST_CASE("a product divided by a factor is the other factor") {
  std::size_t work = 1000;
  const Polynomial a = sum(sum(x, y), constant(3));
  const Polynomial b = minus(product(x, x), term({{1, -2}}, 2));
  const auto result = quotient(product(a, b), a, work);
  REQUIRE(result);
  CHECK(equal(*result, b));
  CHECK(work < 1000);
}

TEST_CASE("what does not divide has no quotient, and ends") {
  std::size_t work = 100'000;
  CHECK_FALSE(quotient(sum(product(x, x), one), sum(x, one), work));
  CHECK_FALSE(quotient(sum(x, one), sum(y, one), work));
  CHECK_FALSE(quotient(sum(x, term({{0, -1}}, 1)), sum(x, one), work));
  CHECK(work > 99'000);
}

TEST_CASE("division stops where the budget is used up") {
  std::size_t work = 3;
  const Polynomial a = sum(x, y);
  CHECK_FALSE(quotient(product(product(a, a), a), a, work));
}

TEST_CASE("coefficients are complex") {
  const Polynomial i{{Monomial{}, Gaussian{0, 1}}};
  CHECK(equal(product(i, i), constant(-1)));
  const Gaussian inverse = reciprocal({3, 4});
  CHECK(inverse.real == cln::cl_RA(3) / 25);
  CHECK(inverse.imaginary == cln::cl_RA(-4) / 25);
}

TEST_CASE("rational numbers are told from everything else") {
  CHECK(rational_value(constant(7)) == cln::cl_RA(7));
  CHECK(rational_value({}) == cln::cl_RA(0));
  CHECK_FALSE(rational_value(x));
}
