// units: arithmetic on rational powers of m, kg, s, A, K; the table of unit names; and the text of
// a unit.
//
// Exponents are fractions in lowest terms. They are clamped to `exponent_limit`, which no physical
// unit reaches.
#include "elgen/units.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace elgen {
namespace {

constexpr std::size_t base_unit_count = 5;
constexpr std::array<std::string_view, base_unit_count> base_names{"m", "kg", "s", "A", "K"};
constexpr std::int64_t exponent_limit = 1'000'000;

Exponent lowest_terms(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator);
  numerator /= divisor;
  denominator /= divisor;
  return {static_cast<std::int32_t>(std::clamp(numerator, -exponent_limit, exponent_limit)),
          static_cast<std::int32_t>(std::min(denominator, exponent_limit))};
}

Exponent add_exponents(const Exponent& a, const Exponent& b, std::int64_t sign) {
  const std::int64_t numerator =
      std::int64_t{a.numerator} * b.denominator + sign * std::int64_t{b.numerator} * a.denominator;
  return lowest_terms(numerator, std::int64_t{a.denominator} * b.denominator);
}

Unit combine_units(const Unit& a, const Unit& b, std::int64_t sign) {
  Unit result;
  for (std::size_t i = 0; i < base_unit_count; ++i) {
    result.powers[i] = add_exponents(a.powers[i], b.powers[i], sign);
  }
  return result;
}

Unit integer_unit(std::int32_t m, std::int32_t kg, std::int32_t s, std::int32_t ampere,
                  std::int32_t kelvin = 0) {
  return Unit{{{{m, 1}, {kg, 1}, {s, 1}, {ampere, 1}, {kelvin, 1}}}};
}

constexpr std::array<UnitMultipleRow, 16> unit_multiples{{{"deg", "pi/180", "rad"},
                                                          {"g", "0.001", "kg"},
                                                          {"lb", "0.45359237", "kg"},
                                                          {"mm", "0.001", "m"},
                                                          {"cm", "0.01", "m"},
                                                          {"km", "1000", "m"},
                                                          {"ms", "0.001", "s"},
                                                          {"min", "60", "s"},
                                                          {"h", "3600", "s"},
                                                          {"rpm", "pi/30", "rad/s"},
                                                          {"mN", "0.001", "N"},
                                                          {"kN", "1000", "N"},
                                                          {"kW", "1000", "W"},
                                                          {"mA", "0.001", "A"},
                                                          {"mH", "0.001", "H"},
                                                          {"uF", "1e-6", "F"}}};

/// A unit as a product of at most one derived unit (such as N) and of powers of base units.
struct UnitSpelling {
  std::string text;
  std::int64_t cost = 0;
};

std::string power_text(std::string_view name, std::int32_t numerator, std::int32_t denominator) {
  std::string text(name);
  if (denominator != 1) {
    text += "^(" + std::to_string(numerator) + "/" + std::to_string(denominator) + ")";
  } else if (numerator != 1) {
    text += "^" + std::to_string(numerator);
  }
  return text;
}

/// The unit derived * rest, with `derived` ("" for none) first in the numerator. kg precedes m, as
/// is usual.
UnitSpelling spell_unit(std::string_view derived, const Unit& rest) {
  // A derived unit is used only if it replaces more powers of base units than this number: m/s^2
  // stays, kg*m/s^2 becomes N.
  constexpr std::int64_t derived_cost = 3;
  constexpr std::array<std::size_t, base_unit_count> order{1, 0, 2, 3, 4};
  std::vector<std::string> above;
  std::vector<std::string> below;
  UnitSpelling result;
  if (!derived.empty()) {
    above.emplace_back(derived);
    result.cost = derived_cost;
  }
  for (const std::size_t i : order) {
    const auto [numerator, denominator] = rest.powers[i];
    if (numerator == 0) continue;
    auto& side = numerator > 0 ? above : below;
    side.push_back(power_text(base_names[i], std::abs(numerator), denominator));
    result.cost += std::abs(numerator);
  }
  result.text = above.empty() ? "1" : fmt::format("{}", fmt::join(above, "*"));
  if (!below.empty()) {
    result.text +=
        below.size() == 1 ? "/" + below.front() : fmt::format("/({})", fmt::join(below, "*"));
  }
  return result;
}

/// False for Hz, rad and 1. Hz is written 1/s, because a rate in rad/s is not a frequency.
bool is_written_by_name(const UnitRow& row) {
  return row.name != "Hz" && row.name != "rad" && row.name != "1";
}

/// True if `rest` is at most one factor or divisor, as in N/s or J*m, and does not contain kg,
/// which is part of the derived unit.
bool fits_derived_unit(const Unit& rest) {
  constexpr std::size_t kilogram = 1;
  std::int64_t count = 0;
  for (const Exponent& exponent : rest.powers) count += std::abs(exponent.numerator);
  return count <= 1 && rest.powers[kilogram].numerator == 0;
}

}  // namespace

const std::vector<UnitRow>& unit_table() {
  static const std::vector<UnitRow> table{
      {"m", integer_unit(1, 0, 0, 0), "metre"},
      {"kg", integer_unit(0, 1, 0, 0), "kilogram"},
      {"s", integer_unit(0, 0, 1, 0), "second"},
      {"A", integer_unit(0, 0, 0, 1), "ampere"},
      {"K", integer_unit(0, 0, 0, 0, 1), "kelvin"},
      {"N", integer_unit(1, 1, -2, 0), "newton, kg*m/s^2"},
      {"J", integer_unit(2, 1, -2, 0), "joule, N*m"},
      {"W", integer_unit(2, 1, -3, 0), "watt, J/s"},
      {"Pa", integer_unit(-1, 1, -2, 0), "pascal, N/m^2"},
      {"Hz", integer_unit(0, 0, -1, 0), "hertz, 1/s"},
      {"V", integer_unit(2, 1, -3, -1), "volt, W/A"},
      {"ohm", integer_unit(2, 1, -3, -2), "ohm, V/A"},
      {"C", integer_unit(0, 0, 1, 1), "coulomb, A*s"},
      {"T", integer_unit(0, 1, -2, -1), "tesla, kg/(s^2*A)"},
      {"H", integer_unit(2, 1, -2, -2), "henry, V*s/A"},
      {"F", integer_unit(-2, -1, 4, 2), "farad, A*s/V"},
      {"Wb", integer_unit(2, 1, -2, -1), "weber, V*s"},
      {"rad", Unit{}, "radian, 1"},
      {"1", Unit{}, "pure number"},
  };
  return table;
}

Unit operator*(const Unit& a, const Unit& b) { return combine_units(a, b, 1); }

Unit operator/(const Unit& a, const Unit& b) { return combine_units(a, b, -1); }

Unit power(const Unit& base, Exponent exponent) {
  Unit result;
  for (std::size_t i = 0; i < base_unit_count; ++i) {
    const Exponent& own = base.powers[i];
    result.powers[i] = lowest_terms(std::int64_t{own.numerator} * exponent.numerator,
                                    std::int64_t{own.denominator} * exponent.denominator);
  }
  return result;
}

std::optional<Unit> find_unit(std::string_view name) {
  const auto row = std::ranges::find(unit_table(), name, &UnitRow::name);
  return row == unit_table().end() ? std::nullopt : std::optional(row->unit);
}

const UnitMultipleRow* find_unit_multiple(std::string_view name) {
  const auto* const row = std::ranges::find(unit_multiples, name, &UnitMultipleRow::name);
  return row == unit_multiples.end() ? nullptr : row;
}

std::string to_string(const Unit& unit) {
  UnitSpelling best = spell_unit("", unit);
  for (const UnitRow& row : unit_table()) {
    const Unit rest = unit / row.unit;
    if (!is_written_by_name(row) || !fits_derived_unit(rest)) continue;
    if (rest == Unit{}) return std::string(row.name);
    UnitSpelling candidate = spell_unit(row.name, rest);
    if (candidate.cost < best.cost) best = std::move(candidate);
  }
  return best.text;
}

std::string force_unit_text(const Unit& unit) {
  return unit == *find_unit("J") ? "N*m" : to_string(unit);
}

}  // namespace elgen
