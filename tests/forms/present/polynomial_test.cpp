#include "forms/present/polynomial.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace elgen;

namespace {

Polynomial term(Monomial monomial, int coefficient) {
  return {{std::move(monomial), GaussianRational{coefficient, 0}}};
}

const Polynomial one = constant_polynomial(1);
const Polynomial x = term({{0, 1}}, 1);
const Polynomial y = term({{1, 1}}, 1);

Polynomial minus(const Polynomial& a, const Polynomial& b) {
  return sum(a, multiply_by_term(b, {-1, 0}));
}

bool equal(const Polynomial& a, const Polynomial& b) { return minus(a, b).empty(); }

}  // namespace

TEST_CASE("the order of monomials is compatible with multiplication, also by negative powers") {
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

TEST_CASE("terms that cancel are removed") {
  CHECK(minus(x, x).empty());
  CHECK(constant_polynomial(0).empty());
  CHECK(product(x, term({{0, -1}}, 1)).begin()->first.empty());
}

TEST_CASE("a product divided by a factor is the other factor") {
  std::size_t work = 1000;
  const Polynomial a = sum(sum(x, y), constant_polynomial(3));
  const Polynomial b = minus(product(x, x), term({{1, -2}}, 2));
  const auto result = quotient(product(a, b), a, work);
  REQUIRE(result);
  CHECK(equal(*result, b));
  CHECK(work < 1000);
}

TEST_CASE("division without a quotient ends") {
  std::size_t work = 100'000;
  CHECK_FALSE(quotient(sum(product(x, x), one), sum(x, one), work));
  CHECK_FALSE(quotient(sum(x, one), sum(y, one), work));
  CHECK_FALSE(quotient(sum(x, term({{0, -1}}, 1)), sum(x, one), work));
  CHECK(work > 99'000);
}

TEST_CASE("division stops when the budget is exhausted") {
  std::size_t work = 3;
  const Polynomial a = sum(x, y);
  CHECK_FALSE(quotient(product(product(a, a), a), a, work));
}

TEST_CASE("coefficients are complex") {
  const Polynomial i{{Monomial{}, GaussianRational{0, 1}}};
  CHECK(equal(product(i, i), constant_polynomial(-1)));
  const GaussianRational inverse = reciprocal({3, 4});
  CHECK(inverse.real == cln::cl_RA(3) / 25);
  CHECK(inverse.imaginary == cln::cl_RA(-4) / 25);
}

TEST_CASE("rational_value recognises constants") {
  CHECK(rational_value(constant_polynomial(7)) == cln::cl_RA(7));
  CHECK(rational_value({}) == cln::cl_RA(0));
  CHECK_FALSE(rational_value(x));
}

TEST_CASE("monomials with many factors are compared, copied and ordered like short ones") {
  Monomial long_one;
  for (AtomId atom = 0; atom < 20; ++atom) long_one.push_back({atom, 2});
  const Monomial copy = long_one;
  CHECK(copy.size() == 20);
  CHECK(copy == long_one);
  const Monomial root = *square_root(copy);
  CHECK(product(root, root) == long_one);
  CHECK(product(long_one, power(copy, -1)).empty());
  CHECK(MonomialLess()(root, long_one));
  CHECK_FALSE(MonomialLess()(long_one, root));
  Monomial few = long_one;
  erase_if(few, [](const AtomPower& factor) { return factor.atom > 2; });
  CHECK(few == Monomial{{0, 2}, {1, 2}, {2, 2}});
}

TEST_CASE("terms are sorted, in whatever order they are added") {
  Polynomial all;
  for (int i = 0; i < 60; ++i) add_term(all, {{0, (i * 37) % 61 - 30}, {1, 1}}, {1 + i, 0});
  CHECK(all.size() == 60);
  const auto descends = [](const auto& a, const auto& b) {
    return !MonomialLess()(a.first, b.first);
  };
  CHECK(std::adjacent_find(all.begin(), all.end(), descends) == all.end());
  for (const auto& [monomial, coefficient] : all) CHECK(all.find(monomial)->second == coefficient);
  CHECK(all.find({{2, 1}}) == all.end());
}

TEST_CASE("products and quotients equal those computed term by term") {
  const Polynomial a = sum(sum(product(x, x), term({{1, -1}, {2, 1}}, -3)), term({{3, 2}}, 2));
  Polynomial b = constant_polynomial(5);
  for (std::int32_t i = 1; i < 12; ++i) {
    b = sum(b, term({{AtomId(i) % 4, i % 2 == 0 ? 2 : -1}, {4, i}}, 2 * i - 7));
  }
  Polynomial expected;
  for (const auto& [left, p] : a) {
    for (const auto& [right, q] : b) add_term(expected, product(left, right), product(p, q));
  }
  CHECK(product(a, b) == expected);
  CHECK(product(b, a) == expected);
  for (const Polynomial& divisor : {a, b}) {
    std::size_t work = 10'000;
    const auto result = quotient(expected, divisor, work);
    REQUIRE(result);
    CHECK(*result == (divisor == a ? b : a));
    CHECK(work == 10'000 - a.size() * b.size());
  }
  std::size_t work = 10'000;
  CHECK_FALSE(quotient(sum(expected, one), a, work));
}
