// The functions of the model language (functions.def), and the table of their properties.
#pragma once

#include <cln/rational.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

enum class FunctionId : std::uint8_t {
#define ELGEN_FUNCTION(name, arity) name,
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

enum class FunctionUse : std::uint8_t { anywhere, forces_only };

enum class Parity : std::uint8_t { none, even, odd };

/// The arguments at which a function is analytic. src/base/functions.cpp explains the words of all
/// enumerations here, and the columns of FunctionRow.
enum class Smoothness : std::uint8_t {
  entire,
  entire_positive,
  meromorphic,
  real_analytic,
  half_plane,
  branches
};

enum class FunctionDomain : std::uint8_t { all, up_to_one, above_zero, above_minus_one };

enum class FunctionUnits : std::uint8_t { dimensionless, preserved, shared, ratio, ignored };

/// The limits of f(x) for x -> -infinity and x -> +infinity; they may be infinite.
struct LimitsAtInfinity {
  double left;
  double right;
};

struct FunctionRow {
  FunctionUse use;
  Parity parity;
  Smoothness smoothness;
  FunctionDomain domain;
  FunctionUnits units;
  std::uint32_t roundings;    ///< error bound of the library's value, in u = epsilon/2
  std::string_view own_name;  ///< name of a function that emitted code defines: "sign_of"; else ""
  std::string_view latex;     ///< "\\sin"
  int exact_argument;
  int exact_value;
  std::optional<LimitsAtInfinity> limits_at_infinity;
  FunctionId id = {};
  std::string_view name = {};
  std::size_t arity = 0;
};

[[nodiscard]] std::span<const FunctionRow> function_table();
[[nodiscard]] const FunctionRow& function_row(FunctionId id);

/// The row of the function `name`; null if no function has this name.
[[nodiscard]] const FunctionRow* find_function(std::string_view name);

/// A function of the language that no later stage knows, because `check` replaces its calls: a row
/// of src/base/expanded_functions.def or composite_functions.def.
struct CallRow {
  std::string_view name;
  bool is_reserved;        ///< false: a model may use the name, such as `x`
  std::string_view usage;  ///< "dot(e)"
  std::string_view doc;
};

[[nodiscard]] std::span<const CallRow> call_table();

/// The row of the call `name`; null if the table has no such row.
[[nodiscard]] const CallRow* find_call(std::string_view name);

/// The call in the language for a function of other languages: "log(x)" for ln(x), "x^2" for
/// pow(x, 2); "" for other names. Arguments that need brackets must have them.
[[nodiscard]] std::string translate_call(std::string_view name,
                                         const std::vector<std::string>& arguments);

/// True if `name` is a function of expressions and nothing else: `sin` and `dot`, but not `x`.
[[nodiscard]] bool is_reserved_function(std::string_view name);

/// True if the function has no derivative at some argument, so that only forces may call it.
[[nodiscard]] inline bool is_kinked(FunctionId id) {
  return function_row(id).use == FunctionUse::forces_only;
}

/// True for sin and cos. Their values and all derivatives are bounded; code computes them as a
/// pair.
[[nodiscard]] constexpr bool is_circular(FunctionId id) {
  return id == FunctionId::sin || id == FunctionId::cos;
}

/// True for functions that are quotients of sums of powers of exp.
[[nodiscard]] constexpr bool has_exponential_form(FunctionId id) {
  return id == FunctionId::exp || id == FunctionId::sinh || id == FunctionId::cosh ||
         id == FunctionId::tanh;
}

/// A function that grows like `id` for large |x|: cosh for stumpff(x, k) with k < 0, else `id`.
[[nodiscard]] constexpr FunctionId growth_function(FunctionId id, bool has_negative_order) {
  return id == FunctionId::stumpff && has_negative_order ? FunctionId::cosh : id;
}

/// The special name of stumpff(x, k); "" if it has no special name.
[[nodiscard]] inline std::string_view stumpff_name(const cln::cl_RA& k) {
  return k == 1 ? "sinc" : k == 2 ? "cosc" : "";
}

}  // namespace elgen
