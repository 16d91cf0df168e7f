// The built-in scalars that code is emitted, compiled and run for.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class ScalarKind : std::uint8_t { single_precision, double_precision, long_double };

struct ScalarRow {
  ScalarKind kind;
  std::string_view name;  ///< in C++, C and scenes
};

inline constexpr std::array scalar_table{ScalarRow{ScalarKind::single_precision, "float"},
                                         ScalarRow{ScalarKind::double_precision, "double"},
                                         ScalarRow{ScalarKind::long_double, "long double"}};

[[nodiscard]] constexpr std::string_view name_of(ScalarKind kind) {
  return scalar_table[static_cast<std::size_t>(kind)].name;
}

/// Of a type.
template <std::floating_point Scalar>
inline constexpr ScalarKind scalar_kind = ScalarKind::long_double;
template <>
inline constexpr ScalarKind scalar_kind<double> = ScalarKind::double_precision;
template <>
inline constexpr ScalarKind scalar_kind<float> = ScalarKind::single_precision;

}  // namespace elgen
