// The functions of the model language (functions.def), and the table of their laws.
#pragma once

#include <cln/rational.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace elgen {

enum class FunctionId : std::uint8_t {
#define ELGEN_FUNCTION(name, arity) name,
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

enum class FunctionUse : std::uint8_t { anywhere, forces };

enum class Parity : std::uint8_t { none, even, odd };

/// See src/base/functions.cpp, as for the other laws.
enum class Smoothness : std::uint8_t { everywhere, positive, poles, real, half_plane, branches };

enum class FunctionDomain : std::uint8_t { all, up_to_one, above_zero, above_minus_one };

enum class FunctionUnits : std::uint8_t { pure, kept, shared, ratio, ignored };

/// The limits far to the left and to the right, which may be infinite.
struct FarValues {
  double left;
  double right;
};

struct FunctionRow {
  FunctionUse use;
  Parity parity;
  Smoothness smoothness;
  FunctionDomain domain;
  FunctionUnits units;
  std::uint32_t roundings;    ///< of a value, in u
  std::string_view own_name;  ///< "sign_of": in emitted code, which defines it itself
  std::string_view latex;     ///< "\\sin"
  int exact_at;
  int exact_value;
  std::optional<FarValues> far_values;
  FunctionId id = {};
  std::string_view name = {};
  std::size_t arity = 0;
};

[[nodiscard]] std::span<const FunctionRow> function_table();
[[nodiscard]] const FunctionRow& function_row(FunctionId id);

/// Null where no function has that name.
[[nodiscard]] const FunctionRow* find_function(std::string_view name);

/// Whether it has no derivative somewhere, so that forces alone may call it.
[[nodiscard]] inline bool is_kinked(FunctionId id) {
  return function_row(id).use == FunctionUse::forces;
}

/// Sine or cosine: bounded with all derivatives, and computed as a pair.
[[nodiscard]] constexpr bool is_circular(FunctionId id) {
  return id == FunctionId::sin || id == FunctionId::cos;
}

/// exp, and the functions that are quotients of sums of its powers.
[[nodiscard]] constexpr bool has_exponential_form(FunctionId id) {
  return id == FunctionId::exp || id == FunctionId::sinh || id == FunctionId::cosh ||
         id == FunctionId::tanh;
}

/// The function that one is like far out: stumpff(x, k) of k < 0 is like cosh(x).
[[nodiscard]] constexpr FunctionId far_out(FunctionId id, bool has_negative_order) {
  return id == FunctionId::stumpff && has_negative_order ? FunctionId::cosh : id;
}

/// The name of stumpff(x, k) where k has one of its own.
[[nodiscard]] inline std::string_view name_of_order(const cln::cl_RA& k) {
  return k == 1 ? "sinc" : k == 2 ? "cosc" : "";
}

}  // namespace elgen
