// functions: the properties of each function, in the order of elgen/functions.def. The columns are:
//
// use         `anywhere`; `forces_only`: only in forces, for functions with kinks, which are never
//             differentiated
// parity      `even`: f(-x) = f(x), in each argument except the k of stumpff; `odd`: f(-x) = -f(x)
// smoothness  real arguments at which the function is analytic; see below
// domain      first arguments for which the function has a value; `up_to_one`: |x| <= 1
// units       `dimensionless`: arguments and value are pure numbers; `preserved`: the value has the
//             unit of the argument; `shared`: arguments and value have the same unit; `ratio`: the
//             arguments have the same unit, and the value is a pure number; `ignored`: the argument
//             has any unit, and the value is a pure number
// roundings   error bound of the library's value, in u; see below
// own_name    name in emitted code that defines the function, because the library may lack it
// latex       command before the arguments; empty if formulas have another notation
// exact_argument    for functions of one argument: an argument at which the value is rational
// exact_value the value at exact_argument
// limits_at_infinity  for exponential functions: their limits at -infinity and +infinity
//
// Smoothness: `entire`: everywhere; `entire_positive`: everywhere, and the values are positive;
// `meromorphic`: except at poles; `real_analytic`: everywhere, but with branch points at complex
// arguments; `half_plane`: if the last argument is positive; `branches`: on no connected domain.
//
// Roundings: the manual of glibc 2.36 lists 2 ulp, or 4 u, for the hyperbolic functions, and 1 ulp
// for log1p, expm1 and hypot; in the tests of glibc, the errors of all other functions are at most
// 0.6 ulp. Measured for stumpff: 4 u for 0 < k <= 20, 8 u at k = 44, 8 u for -7 <= k < 0, 17 u at
// k = -36.
#include "elgen/functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace elgen {
namespace laws {
namespace {

using enum FunctionUse;
using enum Parity;
using enum Smoothness;
using enum FunctionDomain;
using enum FunctionUnits;
using Row = FunctionRow;
using Far = LimitsAtInfinity;

constexpr double inf = std::numeric_limits<double>::infinity();

/// use, parity, smoothness, domain, units, roundings, own_name, latex, exact_argument, exact_value,
/// limits_at_infinity
constexpr Row sin{anywhere, odd, entire, all, dimensionless, 1, "", "\\sin", 0, 0, {}};
constexpr Row cos{anywhere, even, entire, all, dimensionless, 1, "", "\\cos", 0, 1, {}};
constexpr Row tan{anywhere, odd, meromorphic, all, dimensionless, 1, "", "\\tan", 0, 0, {}};
constexpr Row asin{anywhere, odd, branches, up_to_one, dimensionless, 1, "", "\\arcsin", 0, 0, {}};
constexpr Row acos{anywhere, none, branches, up_to_one, dimensionless, 1, "", "\\arccos", 1, 0, {}};
constexpr Row atan{anywhere, odd, real_analytic, all, dimensionless, 1, "", "\\arctan", 0, 0, {}};
constexpr Row atan2{anywhere, none, half_plane, all, ratio, 1, "", "\\mathrm{atan2}", 0, 0, {}};
constexpr Row sinh{anywhere, odd,      entire, all, dimensionless, 4,
                   "",       "\\sinh", 0,      0,   Far{-inf, inf}};
constexpr Row cosh{anywhere, even, entire_positive, all, dimensionless, 4, "", "\\cosh",
                   0,        1,    Far{inf, inf}};
constexpr Row tanh{anywhere, odd, entire, all, dimensionless, 4, "", "\\tanh", 0, 0, Far{-1, 1}};
constexpr Row asinh{anywhere, odd, real_analytic, all, dimensionless, 4, "", "\\mathrm{arsinh}", 0,
                    0,        {}};
constexpr Row exp{anywhere, none, entire_positive, all, dimensionless, 1, "", "\\exp",
                  0,        1,    Far{0, inf}};
constexpr Row log{anywhere, none, half_plane, above_zero, dimensionless, 1, "", "\\ln", 1, 0, {}};
constexpr Row log1p{anywhere, none, half_plane, above_minus_one, dimensionless, 2, "", "",
                    0,        0,    {}};
constexpr Row expm1{anywhere, none, entire, all, dimensionless, 2, "", "", 0, 0, Far{-1, inf}};
constexpr Row hypot{anywhere, even, half_plane, all, shared, 2, "", "", 0, 0, {}};
constexpr Row stumpff{
    anywhere, even, entire, all, dimensionless, 18, "stumpff", "\\mathrm{stumpff}", 0, 0, {}};
constexpr Row abs{forces_only, even, branches, all, preserved, 1, "", "", 0, 0, {}};
constexpr Row sign{forces_only,     odd, branches, all, ignored, 1, "sign_of",
                   "\\mathrm{sgn}", 0,   0,        {}};
constexpr Row min{forces_only, none, branches, all, shared, 1, "smaller", "\\min", 0, 0, {}};
constexpr Row max{forces_only, none, branches, all, shared, 1, "larger", "\\max", 0, 0, {}};

constexpr Row make_row(FunctionId id, std::string_view name, std::size_t arity, Row row) {
  row.id = id;
  row.name = name;
  row.arity = arity;
  return row;
}

constexpr std::array table{
#define ELGEN_FUNCTION(name, arity) make_row(FunctionId::name, #name, arity, name),
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

}  // namespace
}  // namespace laws

namespace {

constexpr std::array expanded_calls{
#define ELGEN_EXPANDED(name, rule, is_reserved, usage, doc) CallRow{#name, is_reserved, usage, doc},
#include "base/expanded_functions.def"
#undef ELGEN_EXPANDED
#define ELGEN_COMPOSITE(name, arity, definition, in_space, usage, doc) \
  CallRow{#name, true, usage, doc},
#include "base/composite_functions.def"
#undef ELGEN_COMPOSITE
};

/// Calls for functions of other languages that no near name hints at: `cot` is near `cos`.
constexpr auto foreign_calls =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"ln", "log({})"},
                                                                  {"cot", "1/tan({})"},
                                                                  {"sgn", "sign({})"},
                                                                  {"pow", "{}^{}"},
                                                                  {"ddot", "dot(dot({}))"}});

}  // namespace

std::span<const FunctionRow> function_table() { return laws::table; }

const FunctionRow& function_row(FunctionId id) { return laws::table[static_cast<std::size_t>(id)]; }

const FunctionRow* find_function(std::string_view name) {
  const auto* const row = std::ranges::find(laws::table, name, &FunctionRow::name);
  return row == laws::table.end() ? nullptr : row;
}

std::span<const CallRow> call_table() { return expanded_calls; }

const CallRow* find_call(std::string_view name) {
  const auto* const row = std::ranges::find(expanded_calls, name, &CallRow::name);
  return row == expanded_calls.end() ? nullptr : row;
}

std::string translate_call(std::string_view name, const std::vector<std::string>& arguments) {
  for (const auto& [function, pattern] : foreign_calls) {
    const auto arity = static_cast<std::size_t>(std::ranges::count(pattern, '{'));
    if (function == name && arity == arguments.size())
      return fmt::format(fmt::runtime(pattern), arguments.front(), arguments.back());
  }
  return {};
}

bool is_reserved_function(std::string_view name) {
  const CallRow* const call = find_call(name);
  return call == nullptr ? find_function(name) != nullptr : call->is_reserved;
}

}  // namespace elgen
