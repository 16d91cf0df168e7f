// Units: arithmetic laws, the spelling of units of mechanics, and parsing of every spelling.
#include "elgen/units.hpp"

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

namespace elgen::test {
namespace {

Unit unit(std::string_view name) {
  const auto found = find_unit(name);
  REQUIRE(found);
  return *found;
}

TEST_CASE("derived units are products of base units") {
  CHECK(unit("N") == unit("kg") * unit("m") / power(unit("s"), {2, 1}));
  CHECK(unit("J") == unit("N") * unit("m"));
  CHECK(unit("W") == unit("J") / unit("s"));
  CHECK(unit("Pa") == unit("N") / power(unit("m"), {2, 1}));
  CHECK(unit("V") == unit("W") / unit("A"));
  CHECK(unit("ohm") == unit("V") / unit("A"));
  CHECK(unit("C") == unit("A") * unit("s"));
  CHECK(unit("T") == unit("V") * unit("s") / power(unit("m"), {2, 1}));
  CHECK(unit("Hz") == Unit{} / unit("s"));
  CHECK(unit("rad") == Unit{});
  CHECK(unit("1") == Unit{});
  CHECK_FALSE(find_unit("cm"));
}

TEST_CASE("powers are rational and in lowest terms") {
  const Unit area = power(unit("m"), {2, 1});
  CHECK(power(area, {1, 2}) == unit("m"));
  CHECK(power(area, {0, 1}) == Unit{});
  CHECK(power(unit("m"), {2, 4}) == power(unit("m"), {1, 2}));
  CHECK(power(unit("J"), {-1, 2}) * power(unit("J"), {1, 2}) == Unit{});
}

TEST_CASE("exponents saturate instead of overflowing") {
  Unit grown = unit("m");
  Unit shrunk = unit("m");
  for (int i = 0; i < 20; ++i) {
    grown = power(grown, {64, 1});
    shrunk = power(shrunk, {1, 63});
  }
  CHECK(grown.powers[0].numerator == 1'000'000);
  CHECK(shrunk.powers[0].denominator == 1'000'000);
}

TEST_CASE("units are spelled as usual in mechanics") {
  const Unit second = unit("s");
  const std::vector<std::pair<Unit, std::string>> rows{
      {Unit{}, "1"},
      {unit("m"), "m"},
      {unit("m") / second, "m/s"},
      {unit("m") / power(second, {2, 1}), "m/s^2"},
      {unit("Hz"), "1/s"},
      {unit("N"), "N"},
      {unit("J"), "J"},
      {unit("C"), "C"},
      {unit("kg") * power(unit("m"), {2, 1}), "kg*m^2"},
      {unit("J") * second, "kg*m^2/s"},
      {unit("N") * second / unit("m"), "kg/s"},
      {unit("J") / unit("A"), "Wb"},
      {Unit{} / (unit("m") * second), "1/(m*s)"},
      {power(unit("m"), {1, 2}), "m^(1/2)"},
      {unit("J") * unit("m"), "J*m"},
      {unit("W") / second, "W/s"},
      {power(unit("N") * second, {2, 1}), "kg^2*m^2/s^2"},
      {power(unit("J") * unit("m"), {2, 1}), "kg^2*m^6/s^4"},
  };
  for (const auto& [value, spelling] : rows) {
    CHECK(to_string(value) == spelling);
  }
}

TEST_CASE("a generalised force with the unit of energy is printed as a torque") {
  CHECK(force_unit_text(unit("J")) == "N*m");
  CHECK(force_unit_text(unit("N")) == "N");
  CHECK(force_unit_text(unit("J") * unit("s")) == to_string(unit("J") * unit("s")));
}

TEST_CASE("every unit of the table is found by its name") {
  for (const UnitRow& row : unit_table()) {
    CHECK(find_unit(row.name) == row.unit);
    CHECK_FALSE(row.doc.empty());
  }
}

}  // namespace
}  // namespace elgen::test
