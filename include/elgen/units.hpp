// Units: products of rational powers of m, kg, s, A, K. rad is the unit 1.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

/// A rational exponent in lowest terms, denominator positive.
struct Exponent {
  std::int32_t numerator = 0;
  std::int32_t denominator = 1;
  friend bool operator==(const Exponent&, const Exponent&) = default;
};

/// The exponents of m, kg, s, A, K, in this order.
struct Unit {
  std::array<Exponent, 5> powers{};
  friend bool operator==(const Unit&, const Unit&) = default;
};

/// One row of the unit table: "N" = kg m s^-2.
struct UnitRow {
  std::string_view name;
  Unit unit;
  std::string_view doc;
};

[[nodiscard]] const std::vector<UnitRow>& unit_table();

/// A unit outside the language, as a multiple of a unit of the language: 1 mm is 0.001 m.
struct UnitMultipleRow {
  std::string_view name;
  std::string_view factor;
  std::string_view unit;
};

[[nodiscard]] Unit operator*(const Unit& a, const Unit& b);
[[nodiscard]] Unit operator/(const Unit& a, const Unit& b);
[[nodiscard]] Unit power(const Unit& base, Exponent exponent);
[[nodiscard]] std::optional<Unit> find_unit(std::string_view name);
/// The row of a unit outside the language; null for other names.
[[nodiscard]] const UnitMultipleRow* find_unit_multiple(std::string_view name);

/// The shortest known spelling, for messages and documentation: "N*m", "kg*m^2/s", "1".
[[nodiscard]] std::string to_string(const Unit& unit);

/// to_string() for a force: J is written N*m, the unit of a generalised force on an angle.
[[nodiscard]] std::string force_unit_text(const Unit& unit);

}  // namespace elgen
