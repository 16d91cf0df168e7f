// The table of cancelling differences: every row is an identity and matches its own text.
#include "forms/write/digit_rows.hpp"

#include <catch2/catch.hpp>
#include <regex>

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"
#include "numbers/random.hpp"
#include "program/expression_leaves.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Random values of the letters a to e, at most `most` in magnitude.
Arguments<Real> letters(Random& random, const Real& most) {
  Arguments<Real> point;
  for (int k = 0; k < 5; ++k) point.q.push_back(Real(random.rational()) * most);
  return point;
}

/// Checks that `to` equals `from` at all letters at which `from` has a value. The letters have both
/// signs and several magnitudes. Returns the number of comparisons.
int equal_values(const Expressions& from, const Expressions& to) {
  int compared = 0;
  Random random(7);
  for (const long scale : {1L, 1000L, 1000000L}) {
    for (int i = 0; i < 32; ++i) {
      const Arguments<Real> point = letters(random, Real(cln::cl_RA(1) / scale));
      const Real x = value_of(from, point);
      if (!x.is_defined()) continue;
      const Real y = value_of(to, point);
      REQUIRE(y.is_defined());
      CHECK(is_near(x, y, 90));
      ++compared;
    }
  }
  return compared;
}

/// `row.from` with sums or products in place of a, b and c if the condition of the row needs them.
std::string text_for(const RewriteRule& row) {
  const std::string text(row.from);
  if (row.condition == RuleCondition::anchored) {
    return std::regex_replace(text, std::regex("\\b([abc])\\b"), "(2 + $1)");
  }
  if (row.condition == RuleCondition::computed) {
    return std::regex_replace(text, std::regex("\\b([abc])\\b"), "($1*d)");
  }
  return text;
}

}  // namespace

TEST_CASE("both sides of every row are equal in 100 digits") {
  for (const RewriteRule& row : rewrite_rules()) {
    INFO(row.from);
    const auto from = expressions_of({std::string(row.from)});
    const auto to = expressions_of({std::string(row.to)});
    const int compared = with_digits(50, [&] { return equal_values(from, to); });
    CHECK(compared >= 8);
  }
}

TEST_CASE("every row matches its own text, also with a common factor in its terms") {
  for (const RewriteRule& row : rewrite_rules()) {
    for (const bool is_scaled : {false, true}) {
      INFO(row.from << (is_scaled ? ", times d e^2" : ""));
      Expressions from = expressions_of({text_for(row)});
      if (is_scaled) {
        const SignedNode factor = value_of(from.graph, "d*e^2");
        from.values[0] =
            GraphTermBuilder(from.graph).sum({from.graph.product({{factor}, {from.values[0]}})});
      }
      const auto after = rewrite_to_keep_digits(from, SquareHandling::factored).rewriting;
      REQUIRE(after);
      CHECK(texts_of(*after) != texts_of(from));
      const int compared = with_digits(50, [&] { return equal_values(from, *after); });
      CHECK(compared >= 8);
    }
  }
}

TEST_CASE("rewritten differences keep their digits near 0 in double") {
  struct NearZero {
    const char* text;
    const char* reference;
  };
  const auto row = GENERATE(
      NearZero{"2*d - d*cos(a) - d*cos(b)", "2*d*(sin(a/2)^2 + sin(b/2)^2)"},
      NearZero{"a - sin(a)", "a^3*stumpff(a, 3)"},
      NearZero{"cosh(a) - 1 - a^2/2", "a^4*stumpff(a, -4)"},
      NearZero{"exp(a) - 1 - a", "a^2*(stumpff(a, -2) + a*stumpff(a, -3))"},
      NearZero{"sqrt((2 + a)^2 + b^2) - 2", "(a*(4 + a) + b^2)/(sqrt((2 + a)^2 + b^2) + 2)"},
      NearZero{"a - log1p(a)",
               "log1p(a)*sqrt(1 + a)*(log1p(a)^2/4*stumpff(log1p(a)/2, -3) - expm1(-log1p(a)/2))"},
      NearZero{"(1 + a)*log1p(a) + (1 - a)*log1p(-a)", "a*(log1p(a) - log1p(-a)) + log1p(-a^2)"},
      NearZero{"log((1 + a)/(1 - a))", "log1p(a) - log1p(-a)"});
  INFO(row.text);
  const auto from = expressions_of({row.text});
  const auto after = rewrite_to_keep_digits(from, SquareHandling::unfactored).rewriting;
  REQUIRE(after);
  const auto reference = expressions_of({row.reference});
  const std::vector<double> point{1e-7, 3e-7, 2e-8, 0.5, 2};
  CHECK(value_in_double(*after, point) == Approx(value_in_double(reference, point)).epsilon(1e-14));
}

TEST_CASE(
    "exponentials minus their first terms keep their digits at large arguments of both signs") {
  const char* const text =
      GENERATE("exp(a) - 1 - a", "expm1(a) - a", "sinh(a) - a", "cosh(a) - 1 - a^2/2",
               "a*cosh(a) - sinh(a)", "1 - exp(a) + a*exp(a)", "log1p(exp(a)) - log(2) - a/2");
  INFO(text);
  const auto from = expressions_of({text});
  const auto after = rewrite_to_keep_digits(from, SquareHandling::unfactored).rewriting;
  REQUIRE(after);
  for (const double a : {-45.0, -8.0, -1.5, -1e-6, 1e-6, 1.5, 8.0, 45.0}) {
    INFO(a);
    Arguments<Real> point;
    point.q.assign(5, Real(exact_value(a)));
    const Real value(exact_value(value_in_double(*after, std::vector<double>(5, a))));
    CHECK(abs(value / value_of(from, point) - Real(1)) < Real(exact_value(0x1p-49)));
  }
}
