// The function table of the model language (functions.def), as an enumeration with its laws.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace elgen {

enum class FunctionId : std::uint8_t {
#define ELGEN_FUNCTION(name, arity, use, parity, smoothness, first, second) name,
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

enum class FunctionUse : std::uint8_t { anywhere, forces };

enum class Parity : std::uint8_t { none, even, odd };

/// See functions.def.
enum class Smoothness : std::uint8_t { everywhere, positive, poles, real, half_plane, branches };

struct FunctionRow {
  FunctionId id;
  std::string_view name;
  std::size_t arity;
  FunctionUse use;
  Parity parity;
  Smoothness smoothness;
};

inline constexpr std::array function_table{
#define ELGEN_FUNCTION(name, arity, use, parity, smoothness, first, second) \
  FunctionRow{FunctionId::name, #name,          arity,                      \
              FunctionUse::use, Parity::parity, Smoothness::smoothness},
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

[[nodiscard]] constexpr const FunctionRow& function_row(FunctionId id) {
  return function_table[static_cast<std::size_t>(id)];
}

/// Whether it has no derivative somewhere, so that forces alone may call it.
[[nodiscard]] constexpr bool is_kinked(FunctionId id) {
  return function_row(id).use == FunctionUse::forces;
}

/// Sine or cosine: bounded with all derivatives, and computed as a pair.
[[nodiscard]] constexpr bool is_circular(FunctionId id) {
  return id == FunctionId::sin || id == FunctionId::cos;
}

/// The name of stumpff(x, k) where k has one of its own.
[[nodiscard]] constexpr std::string_view name_of_order(std::string_view k) {
  return k == "1" ? "sinc" : k == "2" ? "cosc" : "";
}

/// Null where no function has that name.
[[nodiscard]] constexpr const FunctionRow* find_function(std::string_view name) {
  for (const FunctionRow& row : function_table) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace elgen
