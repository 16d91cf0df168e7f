// Units: parsing, inference for expressions, comparisons, unchecked and unknown units, and hints.
#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "check/expressions/units.hpp"
#include "check_testing.hpp"

namespace elgen::test {

namespace {

/// The first diagnostic of the model `block` with V = `potential`.
Diagnostic unit_error(const std::string& potential) {
  const Result<CheckedModel> result = run_check(block("V = \"" + potential + "\"\n"));
  REQUIRE(!result.diagnostics.empty());
  return result.diagnostics.front();
}

const std::string post =
    "[[point]]\nname = \"p\"\nat = [\"x\", AT]\nmass = MASS\n[gravity]\nvector = [0, G]\n";

std::string post_of(const std::string& at, const std::string& mass, const std::string& gravity) {
  return replaced(replaced(replaced(post, "AT", at), "MASS", mass), "G]", gravity + "]");
}

struct Reading {
  std::optional<Unit> unit;
  std::string error;
};

Reading read(const std::string& text) {
  const SourcePointer source = make_source("m.toml", text);
  ValueSyntax value;
  value.text = text;
  value.span = {source.get(), 0, static_cast<std::uint32_t>(text.size())};
  Report report;
  Reading reading{read_unit(value, report), {}};
  for (const Diagnostic& diagnostic : report.sorted_diagnostics()) {
    reading.error = std::to_string(diagnostic.span.begin + 1) + " " + diagnostic.message +
                    (diagnostic.hint.empty() ? "" : " | " + diagnostic.hint);
  }
  return reading;
}

}  // namespace

TEST_CASE("units that agree") {
  for (const char* text :
       {"1/2*k*x^2", "0", "k*x^2 + 0", "k*x*sqrt(x^2)", "k*x^2*cos(2*pi*x/x)", "sqrt(k^2*x^4)",
        "k*x^2*exp(-x/x)", "k*x^2*atan2(x, 2*x)", "0*m + k*x^2", "k*x*hypot(x, 2*x)*cosc(x/x)",
        "(k*m)^(1/2)*x^2*(k/m)^(1/2)", "k*x^2 + 0*m", "k*x^2*t/t"}) {
    INFO(text);
    CHECK(potential_messages(text).empty());
  }
}

TEST_CASE("units that differ") {
  const Rows rows{
      {"k*x^2 + k*x", "E401 12:14 `k*x` is in N, but the sum is in J\n"},
      {"k*x^2 - x", "E401 12:14 `x` is in m, but the sum is in J\n"},
      {"k*x^2*(1 + x)",
       "E401 12:17 `x` is in m, but the sum is in 1 | `1` has no unit in an expression: give it a "
       "name and a unit in `[parameters]`\n"},
      {"k*x^2*sin(x)", "E404 12:16 `x` is in m, but `sin` takes a pure number\n"},
      {"k*x^2*exp(t)", "E404 12:16 `t` is in s, but `exp` takes a pure number\n"},
      {"k*x^2*atan2(x, m)", "E401 12:21 `m` is in kg, but the other argument is in m\n"},
      {"k*x^2*hypot(x, m)", "E401 12:21 `m` is in kg, but the other argument is in m\n"},
      {"k*x^2*sinc(x)", "E404 12:17 `x` is in m, but `sinc` takes a pure number\n"},
      {"k*x", "E403 12:6 `k*x` is in N, but V is in J\n"},
      {"k*x^2/t", "E403 12:6 `k*x^2/t` is in W, but V is in J\n"},
      {"sqrt(k*x^2)", "E403 12:6 `sqrt(k*x^2)` is in kg^(1/2)*m/s, but V is in J\n"},
      // One mistake gives one message: the unit of the inner sum then counts as unknown.
      {"2*(k*x^2 + m)", "E401 12:17 `m` is in kg, but the sum is in J\n"},
  };
  check_rows(rows, [&](const std::string& text) { return potential_messages(text); });
}

TEST_CASE("expressions with a name without unit are not checked, with one note") {
  const std::string model = block(
      "V = \"c*x + 1/2*k*x^2 + d\"\n[parameters.c]\nvalue = 1\n"
      "[parameters.d]\nvalue = 2\n[[input]]\nname = \"u\"\n");
  CHECK(messages(model) ==
        "E520 13:13 `c`, `d`, `u`: no unit, so expressions with it are not checked\n");
  // An error suppresses the note E520.
  CHECK(messages(block("V = \"c*x + k + m\"\n[parameters.c]\nvalue = 1\n")) ==
        "E401 12:16 `m` is in kg, but the sum is in kg/s^2\n");
}

TEST_CASE("a model without units is not checked, and unknown units stay unknown in functions") {
  const std::string free =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"q\"\n"
      "[[point]]\nname = \"p\"\nat = [\"cos(q)\", 1]\nmass = 1\n";
  CHECK(messages(free) == "E520 5:9 `q`: no unit, so expressions with it are not checked\n");
  // If one unit is declared, literals are checked, but expressions with q are not.
  CHECK(messages(free + "[parameters]\nm = { value = 1, unit = \"kg\" }\n") ==
        "E520 5:9 `q`: no unit, so expressions with it are not checked\n"
        "E405 8:17 `1` contains no name, so it is in m, the SI unit of its key; the same holds for "
        "1 other value\n");
}

TEST_CASE("units are not checked if all are 1") {
  const std::string pure =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"q\"\nunit = \"1\"\n"
      "[parameters]\nm = { value = 2, unit = \"1\" }\n[energy]\nT = \"1/2*m*dot(q)^2\"\n"
      "V = \"q*exp(t)\"\n[[input]]\nname = \"u\"\non = \"q\"\nunit = \"1\"\n";
  CHECK(messages(pure).empty());
}

TEST_CASE("rates, accelerations and derivatives include powers of seconds") {
  CHECK(messages(block("[[expect]]\nbias = [\"m*dot(dot(x))\"]\nmomentum = [\"m*dot(x)\"]\n"))
            .empty());
  CHECK(messages(block("[[expect]]\nbias = [\"m*dot(x)\"]\n")) ==
        "E403 13:10 `m*dot(x)` is in kg*m/s, but a closed form is in N\n");
  CHECK(messages(block("D = \"m*dot(x^2)*0 + k*dot(x*x)\"\n")).empty());
}

TEST_CASE("points are in metre, prescribed functions in their own unit") {
  const std::string entries =
      "[[point]]\nname = \"p\"\nat = [\"x\", \"x\"]\n"
      "[[prescribed]]\nname = \"h\"\nunit = \"m\"\nvalue = \"0\"\n";
  CHECK(messages(block("V = \"k*y(p)*h\"\n" + entries)).empty());
  CHECK(messages(block("V = \"k*(y(p) + h + t)^2\"\n" + entries)) ==
        "E401 12:20 `t` is in s, but the sum is in m\n");
}

TEST_CASE("an error of units points to the declaration of the first parameter") {
  const Diagnostic sum = unit_error("1/2*k*x^2 + x*k");
  CHECK(sum.related_message == "`k` is declared here, in N/m");
  REQUIRE(sum.related);
  CHECK(covered_text(*sum.related) == "k");
  CHECK(unit_error("1/2*k*x^2 + x").related_message == "`x` is declared here, in m");
  CHECK(unit_error("1/2*k*x^2 + dot(x)").related_message == "`x` is declared here, in m");
  CHECK(unit_error("1/2*k*x^2 + t").related_message.empty());
}

TEST_CASE("a number in an expression has no unit, except 0") {
  CHECK(unit_error("k*x^2*(x + 3*x/x)").hint ==
        "`3` has no unit in an expression: give it a name and a unit in `[parameters]`");
  CHECK(unit_error("k*x^2*(x + x/x)").hint.empty());
}

TEST_CASE("a value without names is in the unit of its key") {
  CHECK(messages(block(post_of("0.5", "0.1", "-9.81"))) ==
        "E405 14:12 `0.5` contains no name, so it is in m, the SI unit of its key; the same holds "
        "for 2 other values\n");
  CHECK(messages(block(post_of("0", "\"1/3 + sqrt(2)*pi\"", "0"))) ==
        "E405 15:9 `1/3 + sqrt(2)*pi` contains no name, so it is in kg, the SI unit of its key\n");
  CHECK(messages(block(post_of("0", "\"m\"", "0"))).empty());
  CHECK(messages(block(post_of("\"x + 0.5*sin(x/x)\"", "\"m\"", "0"))) ==
        "E401 14:17 `0.5*sin(x/x)` is in 1, but the sum is in m | `0.5` has no unit in an "
        "expression: give it a name and a unit in `[parameters]`\n");
  CHECK(messages(block(post_of("\"0.5*sin(x/x)\"", "\"m\"", "0"))) ==
        "E403 14:13 `0.5*sin(x/x)` is in 1, but a position is in m | `0.5` has no unit in an "
        "expression: give it a name and a unit in `[parameters]`\n");
}

TEST_CASE("a generalised force on an angle and its terms are in N*m") {
  const std::string turning = block(
      "[parameters.J]\nvalue = 1\nunit = \"kg*m^2\"\n[[coordinate]]\nname = \"q\"\n"
      "unit = \"rad\"\narmature = \"J\"\n");
  const std::string force = "[[force]]\non = \"q\"\nvalue = ";
  const std::string expected = "[[expect]]\n";
  const Rows rows{
      {force + "\"k*x\"\n", "E403 21:10 `k*x` is in N, but a force is in N*m\n"},
      {force + "\"k*x^2 + k*x\"\n", "E401 21:18 `k*x` is in N, but the sum is in N*m\n"},
      {force + "\"5\"\n",
       "E405 21:10 `5` contains no name, so it is in N*m, the SI unit of its key\n"},
      {expected + "gravity = [\"0\", \"k*x\"]\n",
       "E403 20:18 `k*x` is in N, but a closed form is in N*m\n"},
      {expected + "potential_energy = \"k*x\"\n",
       "E403 20:21 `k*x` is in N, but a closed form is in J\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(turning + entries); });
}

TEST_CASE("products, quotients and powers of units associate to the left") {
  const Rows rows{
      {"1", "1"},          {"rad", "1"},          {"kg*m^2/s^2", "J"},
      {"N/m/s", "kg/s^3"}, {"N/(m*s)", "kg/s^3"}, {"m^(1/2)", "m^(1/2)"},
      {" N * m ", "J"},    {"1/s", "1/s"},        {"(m/s)^2", "m^2/s^2"},
      {"s^-1", "1/s"},     {"V*A", "W"},          {"m^(2)", "m^2"},
      {"V*s/A", "H"},      {"A*s/V", "F"},        {"H*A", "Wb"},
  };
  for (const auto& [text, spelling] : rows) {
    INFO(text);
    const Reading reading = read(text);
    CHECK(reading.error.empty());
    REQUIRE(reading.unit);
    CHECK(to_string(*reading.unit) == spelling);
  }
}

TEST_CASE("errors point to the character") {
  const Rows rows{
      {"kg*ft", "4 unknown unit `ft`"},
      {"mm", "1 unknown unit `mm` | 1 mm is 0.001 m"},
      {"N*m/deg", "5 unknown unit `deg` | 1 deg is pi/180 rad"},
      {"Kg", "1 unknown unit `Kg` | did you mean `kg`?"},
      {"kgm", "1 unknown unit `kgm` | did you mean `kg*m`?"},
      {"Nms", "1 unknown unit `Nms`"},
      {"", "1 a unit is missing in the unit ``"},
      {"m*", "3 a unit is missing in the unit `m*`"},
      {"m^x", "3 an exponent is an integer, or `(p/q)` in the unit `m^x`"},
      {"m^99", "3 an exponent is an integer, or `(p/q)` in the unit `m^99`"},
      {"m^(1/0)", "3 an exponent is an integer, or `(p/q)` in the unit `m^(1/0)`"},
      {"(m", "3 missing `)` in the unit `(m`"},
      {"m)", "2 unexpected `)` in the unit `m)`"},
      {"m kg", "3 unexpected `k` in the unit `m kg` | write `m*kg`"},
      {"kg m^2/s (A)", "4 unexpected `m` in the unit `kg m^2/s (A)` | write `kg*m^2/s*(A)`"},
      {"m/s2", "3 unknown unit `s2` | write `m/s^2`"},
      {"m/s²", "4 unexpected `²` in the unit `m/s²` | write `m/s^2`"},
      {"kg·m²·s⁻¹", "3 unexpected `·` in the unit `kg·m²·s⁻¹` | write `kg*m^2*s^-1`"},
      {"kg m x", "4 unexpected `m` in the unit `kg m x`"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    const Reading reading = read(text);
    CHECK_FALSE(reading.unit);
    CHECK(reading.error == error);
  }
}

TEST_CASE("every printed unit is read back") {
  CHECK(rc::check("to_string, then read_unit", [] {
    Unit unit;
    for (Exponent& power : unit.powers) {
      power.numerator = *rc::gen::inRange(-4, 5);
      power.denominator = power.numerator % 2 == 0 ? 1 : *rc::gen::element(1, 2);
    }
    const Reading reading = read(to_string(unit));
    RC_ASSERT(reading.error.empty());
    RC_ASSERT(*reading.unit == unit);
  }));
}

TEST_CASE("deeply nested brackets are refused without recursion") {
  CHECK_FALSE(read(std::string(100'000, '(')).unit);
}

}  // namespace elgen::test
