// Unit expressions: grammar, and errors at the exact character.
#include "check/expressions/unit_expression.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen {
namespace {

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
  for (const Diagnostic& diagnostic : report.sorted()) {
    reading.error = std::to_string(diagnostic.span.begin + 1) + " " + diagnostic.message +
                    (diagnostic.hint.empty() ? "" : " | " + diagnostic.hint);
  }
  return reading;
}

TEST_CASE("products, quotients and powers are read from left to right") {
  const test::Rows rows{
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

TEST_CASE("errors point at the character") {
  const test::Rows rows{
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
      {"m kg", "3 unexpected `k` in the unit `m kg`"},
  };
  for (const auto& [text, error] : rows) {
    INFO(text);
    const Reading reading = read(text);
    CHECK_FALSE(reading.unit);
    CHECK(reading.error == error);
  }
}

TEST_CASE("every spelling of a unit is read back") {
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

TEST_CASE("deep brackets are refused, not followed") {
  CHECK_FALSE(read(std::string(100'000, '(')).unit);
}

}  // namespace
}  // namespace elgen
