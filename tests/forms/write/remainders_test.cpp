// Sums that vanish at a place, written as differences and remainders.
#include "forms/write/remainders.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"
#include "program/expression_leaves.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The place a = 1, b = 0, c = 1/2; d and e have any value.
ExactPlace place_of_letters() {
  return {ExactValue{1}, ExactValue{0}, ExactValue{cln::cl_RA(1) / 2}, std::nullopt, std::nullopt};
}

std::optional<Expressions> at_place(const std::string& text, DifferenceForm form) {
  return rewrite_at_place(expressions_of({text}), place_of_letters(), {}, form);
}

/// Sums that vanish to second order at the place.
const char* const minima[]{
    "a^2 + 1/a^2 - 2",
    "1/a^12 - 2/a^6 + 1",
    "d*(exp(-2*(a - 1)) - 2*exp(1 - a) + 1)",
    "a - 1 - log(a)",
    "a*log(a) - a + 1",
    "3/4*exp(14*(1 - a)) - 7/4/a^6 + 1",
    "c*log(c) + (1 - c)*log(1 - c) + log(2)",
    "exp(b - 3) + exp(-b - 3) - 2*exp(-3)",
    "exp(2/5*log(1/(1 - b/4))) - 1 - b/10",
    "1/sqrt((2 - b)^2 + (a - 1)^2) - 1/2 - b/4",
    "a^2 + exp(b) + 1/a^2/exp(b)^2*exp(b) - 3",
    "sqrt(5 + 4*cosh(b)) - 3",
    "d*(a^2/2 - a*cos(b) + 1/2)",
    "1 - cos(b)*cos(a - 1)",
    "2*cosh(b) + 1/cosh(b) - 3",
    "log1p(b) - tan(b) + b^2/4",
    "tanh(b) - sin(b) + (a - 1)^2",
    "hypot(a, 2*b) - a + sinh(b)^2",
    "e*(a + 1/a) - 2*e + sinh(b)*(a - 1)",
};

/// Sums that vanish to first order at the place.
const char* const zeros[]{
    "a - 1/a^3",
    "1/a^7 - exp(14*(1 - a))",
    "log(a*c) + log(2)",
    "a/sqrt(a + b) - exp(b)",
    "cos(b) - 4*c^2",
    "sqrt(a^2 + b^2 + 3*a) - 2*a",
    "log(a)*d + b*e",
    "atan(a/d) - atan(1/d)",
    "expm1(b) - sin(b)*a + a - 1",
};

Arguments<Real> near_place(Random& random, const Real& distance) {
  Arguments<Real> point;
  for (const double at : {1.0, 0.0, 0.5, 0.7, 1.3}) {
    const Real away = Real(random.rational()) * distance;
    point.q.push_back(Real(exact_value(to_double((Real(exact_value(at)) + away).value()))));
  }
  return point;
}

std::vector<double> in_double(const Arguments<Real>& point) {
  std::vector<double> letters;
  for (const Real& x : point.q) letters.push_back(to_double(x.value()));
  return letters;
}

}  // namespace

TEST_CASE("sums that vanish at a place become differences and remainders") {
  struct PlaceRow {
    const char* before;
    const char* after;
  };
  const auto row =
      GENERATE(PlaceRow{"d/a - d + d*(a - 1)", "d*(1 - a)^2/a"},
               PlaceRow{"sqrt(a^2 + b^2) - 1", "(b^2 - (1 + a)*(1 - a))/(1 + sqrt(a^2 + b^2))"},
               PlaceRow{"a - 1/a", "-((1 - a)/a + (1 - a))"});
  INFO(row.before);
  const auto after = at_place(row.before, DifferenceForm::plain);
  REQUIRE(after);
  CHECK(texts_of(*after).at(0) == row.after);
}

TEST_CASE("rewritings at a place have the value of the sum, and keep its digits") {
  Random random(1);
  const auto check = [&](const char* text, DifferenceForm form) {
    INFO(text);
    const Expressions before = expressions_of({text});
    const auto after = at_place(text, form);
    if (!after && form == DifferenceForm::ratio) return;  // one of the terms is constant
    REQUIRE(after);
    for (const double distance : {0.25, 0x1p-10, 0x1p-27}) {
      const Arguments<Real> point = near_place(random, Real(exact_value(distance)));
      const Real exact = value_of(before, point);
      CHECK(abs(value_of(*after, point) - exact).value() < 1e-40);
      const double error = value_in_double(*after, in_double(point)) / to_double(exact.value()) - 1;
      CHECK(std::abs(error) < 64 * 0x1p-53);  // a few roundings, and sums of kernels of both signs
    }
  };
  for (const char* text : minima) check(text, DifferenceForm::plain);
  for (const char* text : zeros) {
    check(text, DifferenceForm::plain);
    check(text, DifferenceForm::ratio);
  }
}

TEST_CASE("far from the place, ratios keep the digits of decaying terms") {
  const auto after = at_place("1/a^7 - exp(14*(1 - a))", DifferenceForm::ratio);
  REQUIRE(after);
  const double x = value_in_double(*after, {8, 0, 0, 0, 0});
  CHECK(x == Approx(std::pow(8, -7) - std::exp(-98)).epsilon(1e-14));
}

TEST_CASE("sums that do not vanish at the place, or with unknown terms, stay") {
  for (const char* text : {"a + 1", "a - d", "b/a", "sin(b) + 1", "1/b - 1/sin(b)", "sqrt(b) - b",
                           "asin(a) - pi/2", "sqrt(a + d) - sqrt(1 + d) + e"}) {
    INFO(text);
    CHECK_FALSE(at_place(text, DifferenceForm::plain));
  }
}
