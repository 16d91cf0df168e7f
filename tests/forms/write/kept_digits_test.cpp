// Differences of nearly equal values, rewritten without cancellation.
#include "forms/write/kept_digits.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "elgen/evaluate.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"
#include "program/expression_leaves.hpp"
#include "program/graph/factor.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string kept(const std::string& text) {
  const Expressions before = expressions_of({text});
  const auto better = rewrite_to_keep_digits(before, SquareHandling::unfactored).rewriting;
  if (better) return texts_of(*better).at(0);
  const auto apart = rewrite_to_keep_digits(before, SquareHandling::factored).rewriting;
  return apart ? texts_of(*apart).at(0) : "none";
}

}  // namespace

TEST_CASE("each cancelling difference has its rewriting") {
  struct KeptRow {
    const char* before;
    const char* after;
  };
  const auto row = GENERATE(
      KeptRow{"sqrt(4 + b^2) - 2", "b^2/(2 + sqrt(4 + b^2))"},
      KeptRow{"2 - sqrt(4 + b^2)", "-b^2/(2 + sqrt(4 + b^2))"},
      KeptRow{"c*exp(a) - c", "c*expm1(a)"},
      KeptRow{"exp(a + b) - exp(b)", "tanh(1/2*a)*(exp(b) + exp(a + b))"},
      KeptRow{"log(1 + a)", "log1p(a)"},
      KeptRow{"log(a + b) - log(b)", "2*asinh(1/2*a/(sqrt(b)*sqrt(a + b)))"},
      KeptRow{"1 - cos(a)", "2*sin(1/2*a)^2"}, KeptRow{"cosh(a) - 1", "2*sinh(1/2*a)^2"},
      KeptRow{"1 - tanh(a)", "2*(1/(1 + exp(2*a)))"},
      KeptRow{"1 + tanh(a)", "2*(1/(1 + exp(-2*a)))"}, KeptRow{"1/(a - b) - 1/a", "b/(a*(a - b))"},
      KeptRow{"a^2 - b^2", "(a + b)*(a - b)"}, KeptRow{"c*a^2 - c", "-c*(1 + a)*(1 - a)"},
      KeptRow{"sqrt(1 + a) - sqrt(1 + b)", "(a - b)/(sqrt(1 + a) + sqrt(1 + b))"},
      KeptRow{"atan(a + b) - atan(a)", "atan2(b, 1 + a^2 + a*b)"},
      KeptRow{"sin(a + b) - sin(a)", "2*sin(1/2*b)*cos(1/2*(b + 2*a))"},
      KeptRow{"sin(a) - sin(b)", "2*sin(1/2*(a - b))*cos(1/2*(a + b))"},
      KeptRow{"log(a) - log(b)", "2*asinh(1/2*(a - b)/(sqrt(a)*sqrt(b)))"},
      KeptRow{"log(1 + a) - log(1 + b)", "2*asinh(1/2*(a - b)/(sqrt(1 + a)*sqrt(1 + b)))"},
      KeptRow{"log(a/b)", "2*asinh(1/2*(1/b)*(a - b)/sqrt(a*(1/b)))"},
      KeptRow{"log(cosh(a))", "log1p(2*sinh(1/2*a)^2)"}, KeptRow{"a - sin(a)", "a^3*stumpff(a, 3)"},
      KeptRow{"sinh(a) - a", "a^3*stumpff(a, -3)"},
      KeptRow{"cosh(a) - 1 - a^2/2", "a^4*stumpff(a, -4)"},
      KeptRow{"sinh(a) - a - a^3/6", "a^5*stumpff(a, -5)"},
      KeptRow{"a^2 + b^2 - 2*a*b*cos(c)", "4*a*b*sin(1/2*c)^2 + (a - b)^2"},
      KeptRow{"1/sqrt(1 - a^2) - 1", "a^2/(sqrt(1 - a^2)*(1 + sqrt(1 - a^2)))"},
      KeptRow{"1 + cos(a)", "2*cos(1/2*a)^2"}, KeptRow{"1 - b/a", "(a - b)/a"});
  INFO(row.before);
  CHECK(kept(row.before) == row.after);
}

TEST_CASE("every rewriting has the value of the original") {
  Random random(1);
  for (const char* text : {"sqrt(4 + b^2) - 2",
                           "c*exp(a) - c",
                           "exp(a + b) - exp(b)",
                           "log(1 + a)",
                           "log(a + b) - log(b)",
                           "d*log1p(a + b) - d*log1p(a)",
                           "1 - cos(a)",
                           "cosh(a) - 1",
                           "1 - tanh(a)",
                           "1 + tanh(a)",
                           "1/(a - b) - 1/a",
                           "c*a^2 - c",
                           "sqrt(1 + a) - sqrt(1 + b)",
                           "atan(a + b) - atan(a)",
                           "atan(a + b) + atan(a)",
                           "sin(a + b) - sin(a)",
                           "sin(a) + sin(b - a)",
                           "cos(a + b) - cos(a)",
                           "sinh(a + b) - sinh(a)",
                           "cosh(a + b) - cosh(a)",
                           "tan(a + b) - tan(a)",
                           "a - sin(a)",
                           "exp(-a) - 1 + a",

                           "a^2 + b^2 - 2*a*b*cos(c)",
                           "a^2 + 4*b^2 + 4*a*b*cos(c)",
                           "1 - cos(a)*cos(b)",
                           "log(a/b)",
                           "log(cosh(a))",
                           "1/a - 1/b",
                           "1/sqrt(1 - a^2/4) - 1",
                           "d*(e*a + b*c) - d*e*a*cos(a) - d*b*c*cosh(b)",
                           "3 - 2*cos(a) - exp(b)",
                           "3 - 2*cos(a) + cos(b)",
                           "2 - 2*sin(a)",
                           "a*(a - 2*b*cos(c)) + b^2",
                           "d*(a*(a - 2*b*cos(c)) + b^2)",
                           "9/4 + b^2 - 3*b*cos(c)",
                           "sqrt((2 + a)^2 + b^2) - 2",
                           "sqrt((2 + a)^2 + b^2) - sqrt((2 - a)^2 + b^2)",
                           "e*(sqrt(2 + a^2) - sqrt(2))",
                           "sqrt(1 + a^2/9) - 1",
                           "a - 3*a/sqrt(9 + a^2)",
                           "d*a - d*a/sqrt(1 + a^2/9)",
                           "(2 + a)^2 - 4",
                           "1/4 - 1/(2 + a)^2",
                           "1/(3 - a) + 1/(3 + a) - 2/3",
                           "log((1 + a)/(1 - a))",
                           "acos(a/3)",
                           "acos(cos(a)*cos(b))",
                           "1 - cos(a)^3",
                           "a^6 - b^6",
                           "1 - sin(a)*sin(b) - cos(a)*cos(b)*cos(c)",
                           "a*(cos(b) - 1 + b^2/2)",
                           "b/3 - sin(3*b)/9",
                           "tan(a)/2 - a/2",
                           "sqrt(1 + a^2)*sqrt(1 + b^2) - 1",
                           "6 - 2*sqrt(1 + a^2)*sqrt(9 + b^2)",
                           "sqrt((2 + a)^2 + 9)*sqrt((2 - a)^2 + 9) + a^2 - 13",
                           "sqrt(1 + sqrt(1 + a)) - sqrt(2)",
                           "sqrt(2 + sqrt(4 + a)) - 2",
                           "a + b - 2*sqrt(a*b)",
                           "a - log1p(a)",
                           "3*e*log(1 + a/b) - 3*e*a/b",
                           "a - 1 - log(a)",
                           "a/b - 1 - log(a/b)",
                           "d*(a - b - b*log(a/b))",
                           "(1 + a)*log(1 + a) - a",
                           "a*log(a) - a + 1",
                           "d*(a*log(a/b) - a + b)",
                           "(b + a)*log(1 + a/b) - a + c",
                           "(1 + a/2)*log(1 + a/2) + (1 - a/2)*log(1 - a/2)",
                           "a*log(2*a/(a + b)) + b*log(2*b/(a + b))",
                           "a*log(a/b) + b*log(b/a)",
                           "log1p(a/2) + log1p(-a/2)",
                           "d*(a^2 - b^2) + e"}) {
    INFO(text);
    const Expressions before = expressions_of({text});
    const auto after = rewrite_to_keep_digits(before, SquareHandling::factored).rewriting;
    REQUIRE(after);
    for (int i = 0; i < 4; ++i) {
      Arguments<Real> point;
      for (int k = 0; k < 5; ++k) point.q.push_back(Real(cln::abs(random.rational())));
      const Real x = value_of(before, point);
      const Real y = value_of(*after, point);
      REQUIRE(x.is_defined() == y.is_defined());
      if (x.is_defined()) CHECK(abs(x - y).value() < 1e-40);
    }
  }
}

TEST_CASE("a sum with a repeated factor becomes a product") {
  struct FactorRow {
    const char* before;
    const char* after;
  };
  const auto row = GENERATE(FactorRow{"a^2 + b^2 - 2*a*b", "(a - b)^2"},
                            FactorRow{"a^4 - 2*a^2*b^2 + b^4", "(a^2 - b^2)^2"},
                            FactorRow{"d*a^2 - 2*d*a*b + d*b^2", "d*(a - b)^2"},
                            FactorRow{"1/a^2 - 2/(a*b) + 1/b^2", "1/(a^2*b^2)*(a - b)^2"},
                            FactorRow{"1 - 2*exp(a) + exp(a)^2", "expm1(a)^2"},
                            FactorRow{"exp(-2*a) - 2*exp(-a) + 1", "expm1(-a)^2"});
  INFO(row.before);
  CHECK(kept(row.before) == row.after);
}

TEST_CASE("a product with a repeated factor has the value of the sum") {
  for (const char* text :
       {"a^3 - 3*a + 2", "a^2 + 2/a - 3", "d*a^3 - 3*d*a*b^2 + 2*d*b^3", "a^5 - 2*a^4 + a^3",
        "c^2/(2*d*a^2) - e/a + d*e^2/(2*c^2)", "cos(c) + a^2 - 2*a + 1",
        "4*a^3*b - 12*a^2*b + 9*a*b", "d*exp(2*a/b) - 2*d*exp(a/b) + d", "exp(3*a) - 3*exp(a) + 2",
        "exp(-2*a*(b - c)) + 1 - 2*exp(-a*(b - c))"}) {
    INFO(text);
    const Expressions before = expressions_of({text});
    const auto after = rewrite_to_keep_digits(before, SquareHandling::factored).rewriting;
    REQUIRE(after);
    Arguments<Real> point;
    for (const int k : {3, 5, 7, 11, 13}) point.q.push_back(Real(cln::cl_RA(k) / 17));
    CHECK(is_near(value_of(before, point), value_of(*after, point)));
  }
}

TEST_CASE("sums without common factors stay") {
  for (const char* text : {"sqrt(a^2 + b^2) - c",
                           "sqrt(a^2 + b^2) + sqrt(a^2 + b^2)",
                           "a + b",
                           "log(2 + a)",
                           "exp(a) - 2",
                           "sqrt(a^2) + a",
                           "sqrt(a^2 + b^2) - a",
                           "sqrt(1 + a^2)*sqrt(1 + b^2) + 1",
                           "sin(tan(a)) + tan(a)",
                           "tan(a) + sin(tan(a))",
                           "sqrt(2*a^2 + 2*a*abs(a)) + 2*a",
                           "a^2 + b^2 - a*b",
                           "a^2 + b^2 - a*b*cos(c)",
                           "a^2 + 2*a + 2",
                           "1 + tanh(a)^2",
                           "sqrt(4 + b^2) + 2",
                           "a - 2*log1p(a)",
                           "log1p(a) - log1p(-a)",
                           "a*log1p(a) - a",
                           "a*log1p(a) + b*log1p(b)",
                           "sqrt(a) + sqrt(b) - 2*sqrt(c)",
                           "sqrt(2 + a) + sqrt(2 + 3*a) - 2*sqrt(2)",
                           "a + b - sqrt(a*b)",
                           "a + b + 2*sqrt(a*b)"}) {
    INFO(text);
    CHECK(kept(text) == "none");
  }
}

TEST_CASE("functions of one argument are computed from functions that keep digits") {
  const auto fewer = [](const std::string& text) {
    const auto better = replace_redundant_calls(expressions_of({text}));
    return better ? texts_of(*better).at(0) : "none";
  };
  CHECK(fewer("a*expm1(b) + exp(b)") == "a*expm1(b) + (1 + expm1(b))");
  CHECK(fewer("sin(1/2*a)*b + sin(a)") == "2*sin(1/2*a)*cos(1/2*a) + b*sin(1/2*a)");
  CHECK(fewer("sin(1/2*a)*b + cos(a)") == "b*sin(1/2*a) + (1 - 2*sin(1/2*a)^2)");
  CHECK(fewer("sin(1/2*a) + sin(b)") == "none");
}

TEST_CASE("rewritings have no NaN where the text is finite, and keep the digits of both ends") {
  struct FarRow {
    const char* text;
    double a;
    double b;
  };
  const auto row = GENERATE(
      FarRow{"log(a/b)", 1e-12, 3}, FarRow{"log(a/b)", 1e-17, 3}, FarRow{"log(a/b)", 3, 1e-300},
      FarRow{"log(a/b)", -2, -3}, FarRow{"log(a) - log(b)", 1e-150, 1e150},
      FarRow{"log(cos(a))", 1.5707963, 0}, FarRow{"log(cosh(a))", 700, 0},
      FarRow{"exp(a) - exp(b)", 1, -1500}, FarRow{"exp(a) - exp(b)", -1500, 700},
      FarRow{"tanh(a) - tanh(b)", 800, -800}, FarRow{"tanh(a) - tanh(b)", 20, 1});
  INFO(row.text << " at " << row.a << ", " << row.b);
  const auto from = expressions_of({row.text});
  const auto after = rewrite_to_keep_digits(from, SquareHandling::unfactored).rewriting;
  REQUIRE(after);
  const std::vector<double> point{row.a, row.b, 0, 0, 0};
  Arguments<Real> exact;
  for (const double x : point) exact.q.emplace_back(exact_value(x));
  const double truth = to_double(value_of(from, exact).value());
  CHECK(value_in_double(*after, point) == Approx(truth).epsilon(1e-14).margin(1e-300));
}

TEST_CASE("log(a/b) has no value if a and b have different signs") {
  const auto after =
      rewrite_to_keep_digits(expressions_of({"log(a/b)"}), SquareHandling::unfactored).rewriting;
  CHECK(std::isnan(value_in_double(*after, {2, -3, 0, 0, 0})));
}

TEST_CASE("quotients of calls that overflow become calls that do not") {
  const auto row = GENERATE(std::pair{"sinh(a)/cosh(a)", "tanh(a)"},
                            std::pair{"b*sinh(a)^2/cosh(a)^3", "b*tanh(a)^2/cosh(a)"},
                            std::pair{"cosh(a)/sinh(a)", "1/tanh(a)"},
                            std::pair{"exp(a)/(1 + exp(a))", "1/(1 + exp(-a))"},
                            std::pair{"exp(2*a)/(1 + exp(a))^2", "1/(1 + exp(-a))^2"});
  INFO(row.first);
  CHECK(texts_of(flatten(expressions_of({row.first}), FlattenedProducts::all_products)).at(0) ==
        row.second);
}
