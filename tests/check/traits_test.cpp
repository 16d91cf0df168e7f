// Traits of expressions: degrees, ingredients, and the keys that allow an ingredient.
#include "check/expressions/traits.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check_testing.hpp"

namespace elgen::test {

namespace {

/// Traits of an expression over coordinates x and y, an input u, a parameter m and time t.
ExpressionTraits traits_of(const std::string& text) {
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
      ValueReader(context, IndexScope(context.sizes)).read_root(*expression, RootRequest{});
  REQUIRE(context.report.error_count() == 0);
  return find_traits(context.model)[id];
}

const std::string entries = R"toml([[input]]
name = "u"
unit = "N"
[define]
speed = "dot(x)"
drive = "u*x"
[parameters.T0]
value = 1
unit = "kg*s^2"
)toml";

}  // namespace

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

TEST_CASE("a refused ingredient is reported at its position, also inside a definition") {
  const Rows rows{
      {"V = \"k*x^2 + u*x\"\n",
       "E319 12:14 `u` is an input, but V takes none | an input acts by its key `on`, or in a "
       "`[[force]]`\n"},
      {"V = \"drive\"\n",
       "E319 12:6 `drive` contains an input, but V takes none | an input acts by its key `on`, or "
       "in a `[[force]]`\n"},
      {"V = \"T0*dot(dot(x))^2\"\n",
       "E502 12:9 `dot(dot(x))` is a second derivative, but V takes none\n"},
      {"V = \"T0*dot(speed)^2\"\n",
       "E502 12:9 `dot(speed)` is a second derivative, but V takes none\n"},
      {"V = \"k*max(x, 0)^2\"\n",
       "E315 12:8 `max(x, 0)` is a function with a kink, but V takes none | a smooth approximation "
       "is tanh(x/width)\n"},
      {"V = \"u*x + u*x\"\n",
       "E319 12:6 `u` is an input, but V takes none | an input acts by its key `on`, or in a "
       "`[[force]]`\n"
       "E319 12:12 `u` is an input, but V takes none | an input acts by its key `on`, or in a "
       "`[[force]]`\n"},
  };
  check_rows(rows, [&](const std::string& energy) { return messages(block(energy + entries)); });
}

TEST_CASE("definitions refuse accelerations, and closed forms allow them") {
  CHECK(messages(block(entries + "[[expect]]\ninverse_dynamics = [\"m*dot(dot(x))\"]\n")).empty());
  CHECK(messages(block("[define]\na = \"m*dot(dot(x))\"\n")) ==
        "E502 13:8 `dot(dot(x))` is a second derivative, but a definition takes none\n");
}

TEST_CASE("a function with a kink may be allowed although its rate is not") {
  const std::string force = "[[force]]\non = \"x\"\nvalue = \"";
  const std::string refused = " is the rate of a function with a kink | " +
                              std::string("a smooth approximation is tanh(x/width)\n");
  CHECK(messages(block(force + "k*abs(x)\"\n")).empty());
  CHECK(messages(block(force + "c*dot(abs(x))\"\n[parameters.c]\nvalue = 1\nunit = \"kg/s\"\n")) ==
        "E315 14:12 `dot(abs(x))`" + refused);
  CHECK(messages(block(force + "c*dot(spread)\"\n[parameters.c]\nvalue = 1\nunit = \"kg/s\"\n"
                               "[define]\nspread = \"2*abs(x)\"\n")) ==
        "E315 14:12 `dot(spread)`" + refused);
  // The rate of a constant is 0.
  CHECK(
      messages(block(force + "k*x + c*dot(abs(k))\"\n[parameters.c]\nvalue = 1\nunit = \"m*s\"\n"))
          .empty());
}

TEST_CASE("energies, spins and forces may contain rates, other keys may not") {
  CHECK(messages(block("D = \"0.5*T0*speed^2/x^2*dot(x)*0\"\n" + entries)).empty());
  CHECK(mentions(
      messages(block("[[prescribed]]\nname = \"w\"\nvalue = \"sin(t)\"\n[[point]]\nname = \"p\"\n"
                     "at = [\"x\", \"0\"]\nmass = \"m*w\"\n")),
      "`w` contains time, but a mass takes none"));
  CHECK(messages(block(entries + "[[point]]\nname = \"p\"\nat = [\"speed*0\", \"0\"]\n")) ==
        "E319 23:8 `speed` contains a rate, but a position takes none\n");
}

}  // namespace elgen::test
