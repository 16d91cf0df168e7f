// Traits: degrees and ingredients, judged through a context built by hand.
#include "check/expressions/traits.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

/// Traits of an expression over a coordinate x and y, an input u, a parameter m and time t.
Traits traits_of(const std::string& text) {
  const Limits limits;
  Context context(limits);
  std::uint32_t index = 0;
  for (const char* name : {"x", "y"}) {
    append_coordinate(context.model, {});
    context.symbols.declare({name, {}, {}}, SymbolKind::coordinate, index++, context.report);
  }
  context.model.inputs.emplace_back();
  context.symbols.declare({"u", {}, {}}, SymbolKind::input, 0, context.report);
  context.model.parameters.emplace_back();
  context.symbols.declare({"m", {}, {}}, SymbolKind::parameter, 0, context.report);
  const SourcePointer source = make_source("m.toml", text);
  const auto expression = parse_expression(source, limits);
  REQUIRE(expression);
  const ExpressionId id =
      ValueReader(context, Scope(context.sizes)).root(*expression, RootRequest{});
  REQUIRE(context.report.errors() == 0);
  return find_traits(context.model)[id];
}

TEST_CASE("degree in the rates") {
  const std::vector<std::pair<std::string, int>> rows{
      {"m*x", 0},
      {"m*dot(x)", 1},
      {"dot(x) + x", 1},
      {"dot(x)*dot(y) + dot(x)", 2},
      {"dot(x)^2", 2},
      {"(dot(x) + dot(y))^2/m", 2},
      {"dot(x)^3", not_polynomial},
      {"dot(x)^2*dot(y)", not_polynomial},
      {"1/dot(x)", not_polynomial},
      {"sin(dot(x))", not_polynomial},
      {"sqrt(dot(x)^2)", not_polynomial},
      {"dot(x)^-1", not_polynomial},
      {"sin(x)*dot(x)", 1},
      {"dot(x*y)", 1},
      {"dot(sin(t))", 0},
      {"dot(x*y)^2", 2},
      {"dot(x)^0", 0},
  };
  for (const auto& [text, degree] : rows) {
    INFO(text);
    CHECK(traits_of(text).rate_degree == degree);
  }
}

TEST_CASE("lowest degree in the rates") {
  const std::vector<std::pair<std::string, int>> rows{
      {"m*x", 0},           {"m*dot(x)", 1},    {"dot(x) + x", 0},    {"dot(x)*dot(y) + dot(x)", 1},
      {"m*dot(x)^2/2", 2},  {"sin(dot(x))", 0}, {"sin(x)*dot(x)", 1}, {"dot(x*y)", 1},
      {"dot(x*t)", 0},      {"dot(x*y)^2", 2},  {"-dot(x)", 1},       {"(dot(x) + dot(y))^2", 2},
      {"(dot(x) + m)^2", 0}};
  for (const auto& [text, degree] : rows) {
    INFO(text);
    CHECK(traits_of(text).lowest_rate_degree == degree);
  }
}

TEST_CASE("degree in the inputs, and inputs times rates") {
  struct Row {
    std::string text;
    int degree;
    bool times_rate;
  };
  for (const Row& row : std::vector<Row>{{"m*x", 0, false},
                                         {"u", 1, false},
                                         {"u*cos(x) + dot(x)", 1, false},
                                         {"(u - m*dot(x))/m", 1, false},
                                         {"u*dot(x)", 1, true},
                                         {"(u + dot(x))*dot(y)", 1, true},
                                         {"(u + dot(x))*m", 1, false},
                                         {"u/dot(x)", 1, true},
                                         {"u^2", 2, false},
                                         {"u*u", 2, false},
                                         {"tanh(u)", not_polynomial, false},
                                         {"1/u", not_polynomial, false}}) {
    INFO(row.text);
    CHECK(traits_of(row.text).input_degree == row.degree);
    CHECK(traits_of(row.text).input_times_rate == row.times_rate);
  }
}

TEST_CASE("ingredients") {
  const std::vector<std::pair<std::string, unsigned>> rows{
      {"2*pi", 0},
      {"m*t", uses_parameter | uses_time},
      {"abs(x)", uses_coordinate | uses_kink},
      {"dot(x)", uses_rate},
      {"dot(dot(x))", uses_acceleration},
      {"dot(x^2)", uses_coordinate | uses_rate},
      {"dot(x*dot(x))", uses_coordinate | uses_rate | uses_acceleration},
      {"min(u, m)", uses_input | uses_parameter | uses_kink},
  };
  for (const auto& [text, ingredients] : rows) {
    INFO(text);
    CHECK(unsigned{traits_of(text).ingredients} == ingredients);
  }
}

}  // namespace
}  // namespace elgen
