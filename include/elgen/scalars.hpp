// The built-in scalar types for which code is emitted, compiled and run.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class ScalarKind : std::uint8_t { single_precision, double_precision, long_double };

struct ScalarRow {
  ScalarKind kind;
  std::string_view name;  ///< name of the type in C++, C and scenes
  int digits;             ///< decimal digits, rounded: the most that a value can lose
};

inline constexpr std::array scalar_table{ScalarRow{ScalarKind::single_precision, "float", 7},
                                         ScalarRow{ScalarKind::double_precision, "double", 16},
                                         ScalarRow{ScalarKind::long_double, "long double", 19}};

[[nodiscard]] constexpr std::string_view name_of(ScalarKind kind) {
  return scalar_table[static_cast<std::size_t>(kind)].name;
}

[[nodiscard]] constexpr int decimal_digits(ScalarKind kind) {
  return scalar_table[static_cast<std::size_t>(kind)].digits;
}

/// The scalar of computations inside functions whose arguments and results are double.
/// single_precision applies only to the accelerations that a `step` calls.
enum class InnerScalar : std::uint8_t { same, long_double, double_double, single_precision };

struct InnerScalarRow {
  InnerScalar kind;
  std::string_view name;  ///< name of the type in scenes
  std::string_view type;  ///< C++ type in templates/cpp/wide.hpp.mustache
  double roundoff;        ///< u: relative rounding error of one operation
};

inline constexpr std::array inner_scalar_table{
    InnerScalarRow{InnerScalar::same, "double", "double", 0x1p-53},
    InnerScalarRow{InnerScalar::long_double, "long double", "long double", 0x1p-64},
    InnerScalarRow{InnerScalar::double_double, "double-double", "detail::DoubleDouble", 0x1p-102},
    InnerScalarRow{InnerScalar::single_precision, "float", "float", 0x1p-24}};

[[nodiscard]] constexpr const InnerScalarRow& inner_scalar_row(InnerScalar kind) {
  return inner_scalar_table[static_cast<std::size_t>(kind)];
}

/// log10 of `loss`, an error in units of u: at least 0, at most decimal_digits(kind).
[[nodiscard]] inline double digits_lost(double loss, ScalarKind kind) {
  return loss > 1 ? std::min<double>(std::log10(loss), decimal_digits(kind)) : 0;
}

/// The ScalarKind of `Scalar`: long_double unless `Scalar` is float or double.
template <std::floating_point Scalar>
inline constexpr ScalarKind scalar_kind = ScalarKind::long_double;
template <>
inline constexpr ScalarKind scalar_kind<double> = ScalarKind::double_precision;
template <>
inline constexpr ScalarKind scalar_kind<float> = ScalarKind::single_precision;

}  // namespace elgen
