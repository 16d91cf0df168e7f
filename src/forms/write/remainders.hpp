// remainders: sums that vanish at a place, without the terms that cancel there.
//
//     before    k/r - k/r0 + k*(r - r0)/r0^2     which vanishes at r = r0
//     after     k*(r - r0)^2/(r0^2*r)
//
// Each value is u = u0 + L d + R(u): u0 is the value at the place, d = q - q0, L the row of its
// derivatives there, and R(u) the remainder, a sum of terms of second order.
// With D(u) = u - u0:
//
//     R(u v) = u0 R(v) + v0 R(u) + D(u) D(v)          R(1/u) = (D(u)^2/u - R(u))/u0^2
//     R(s) = (R(u) - D(s)^2)/(2 s0), s = sqrt(u)      R(e^u) = e^u0 (R(u) + e^D(u) - 1 - D(u))
//
// A sum with u0 = 0 is replaced by D(u), or by R(u) if also L = 0, as for V at a minimum.
#pragma once

#include <cln/rational.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/leaf_names.hpp"
#include "program/graph/rebuild.hpp"

namespace elgen {

/// scale times a parameter.
struct ScaledParameter {
  std::uint32_t index = 0;
  cln::cl_RA scale = 1;
};

/// number + half_turns pi + the sum of the parameters.
struct ExactValue {
  cln::cl_RA number = 0;
  cln::cl_RA half_turns = 0;
  std::vector<ScaledParameter> parameters = {};
};

/// The value of each coordinate; none for a coordinate with any value.
using ExactPlace = std::vector<std::optional<ExactValue>>;

/// How u - v is written for u0 = v0:
///
///     plain    D(u) - D(v)
///     ratio    (u + v) tanh((log(u/u0) - log(v/v0))/2), without loss if u and v decay; undefined
///              if a coordinate or a factor of u or v has another sign than at the place
enum class DifferenceForm : std::uint8_t { plain, ratio };

/// Rewrites all sums that vanish at `place` for all values of the parameters. The rewriting has the
/// value of the sum if both are defined. It is undefined if a value u0 in a divisor is 0, or if a
/// root or a logarithm is undefined at the place. It may overflow far from the place: the caller
/// compares it with the sum at the states that matter. Roots of squares of parameters need the
/// assumptions of `leaves`. None if no sum vanishes, or if DifferenceForm::ratio changes nothing.
[[nodiscard]] std::optional<Expressions> rewrite_at_place(const Expressions& expressions,
                                                          const ExactPlace& place,
                                                          const LeafNames& leaves,
                                                          DifferenceForm difference);

}  // namespace elgen
