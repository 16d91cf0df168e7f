// The table of functions: the laws of each, in the order of elgen/functions.def.
//
// use: `anywhere`, or `forces` (kinks: no derivative is ever taken of them).
// parity: f(-x) = f(x) `even`, in each argument but the k of stumpff; f(-x) = -f(x) `odd`.
// smoothness: the real arguments at which it is analytic: `everywhere`; `positive`, everywhere and
// with positive values; `poles`, everywhere but at poles; `real`, everywhere, though it branches at
// complex arguments; `half_plane`, where the last argument is positive; `branches`, not on a
// connected domain.
// domain: the first arguments that have a value; `up_to_one`, in magnitude.
// units: `pure`, numbers alone; `kept`, the value has that of the argument; `shared`, the arguments
// and the value have one; `ratio`, the arguments have one, the value none; `ignored`, the argument
// has any, the value none.
// roundings: errors of u in a value of the mathematical library. The manual of glibc 2.36 lists 2
// ulp, which are 4 u, for the hyperbolic functions, and 1 ulp for log1p, expm1 and hypot; the
// others are off by 0.6 ulp in its tests. stumpff was off by 8 u at k = 44, by 4 u up to k = 20; by
// 17 u at k = -36, by 8 u from k = -7 on.
// own_name: the function that emitted code defines where its library has none.
// latex: the command in front of the arguments; empty where formulas are written otherwise.
// exact_at, exact_value: with one argument, the number at which the value is a rational one.
// far_values: of exponentials, whose values far out leave all ranges or have one limit.
#include "elgen/functions.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace elgen {
namespace laws {
namespace {

using enum FunctionUse;
using enum Parity;
using enum Smoothness;
using enum FunctionDomain;
using enum FunctionUnits;
using Row = FunctionRow;
using Far = FarValues;

constexpr double inf = std::numeric_limits<double>::infinity();

constexpr Row sin{anywhere, odd, everywhere, all, pure, 1, "", "\\sin", 0, 0, {}};
constexpr Row cos{anywhere, even, everywhere, all, pure, 1, "", "\\cos", 0, 1, {}};
constexpr Row tan{anywhere, odd, poles, all, pure, 1, "", "\\tan", 0, 0, {}};
constexpr Row asin{anywhere, odd, branches, up_to_one, pure, 1, "", "\\arcsin", 0, 0, {}};
constexpr Row acos{anywhere, none, branches, up_to_one, pure, 1, "", "\\arccos", 1, 0, {}};
constexpr Row atan{anywhere, odd, real, all, pure, 1, "", "\\arctan", 0, 0, {}};
constexpr Row atan2{anywhere, none, half_plane, all, ratio, 1, "", "\\mathrm{atan2}", 0, 0, {}};
constexpr Row sinh{anywhere, odd, everywhere, all, pure, 4, "", "\\sinh", 0, 0, Far{-inf, inf}};
constexpr Row cosh{anywhere, even, positive, all, pure, 4, "", "\\cosh", 0, 1, Far{inf, inf}};
constexpr Row tanh{anywhere, odd, everywhere, all, pure, 4, "", "\\tanh", 0, 0, Far{-1, 1}};
constexpr Row exp{anywhere, none, positive, all, pure, 1, "", "\\exp", 0, 1, Far{0, inf}};
constexpr Row log{anywhere, none, half_plane, above_zero, pure, 1, "", "\\ln", 1, 0, {}};
constexpr Row log1p{anywhere, none, half_plane, above_minus_one, pure, 2, "", "", 0, 0, {}};
constexpr Row expm1{anywhere, none, everywhere, all, pure, 2, "", "", 0, 0, Far{-1, inf}};
constexpr Row hypot{anywhere, even, half_plane, all, shared, 2, "", "", 0, 0, {}};
constexpr Row stumpff{anywhere, even, everywhere, all, pure, 18, "stumpff", "\\mathrm{stumpff}",
                      0,        0,    {}};
constexpr Row abs{forces, even, branches, all, kept, 1, "", "", 0, 0, {}};
constexpr Row sign{forces, odd, branches, all, ignored, 1, "sign_of", "\\mathrm{sgn}", 0, 0, {}};
constexpr Row min{forces, none, branches, all, shared, 1, "smaller", "\\min", 0, 0, {}};
constexpr Row max{forces, none, branches, all, shared, 1, "larger", "\\max", 0, 0, {}};

constexpr Row named(FunctionId id, std::string_view name, std::size_t arity, Row row) {
  row.id = id;
  row.name = name;
  row.arity = arity;
  return row;
}

constexpr std::array table{
#define ELGEN_FUNCTION(name, arity) named(FunctionId::name, #name, arity, name),
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
};

}  // namespace
}  // namespace laws

std::span<const FunctionRow> function_table() { return laws::table; }

const FunctionRow& function_row(FunctionId id) { return laws::table[static_cast<std::size_t>(id)]; }

const FunctionRow* find_function(std::string_view name) {
  const auto* const row = std::ranges::find(laws::table, name, &FunctionRow::name);
  return row == laws::table.end() ? nullptr : row;
}

}  // namespace elgen
