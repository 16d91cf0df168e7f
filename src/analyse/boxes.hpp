// Boxes: all solutions of equations in a box, by interval arithmetic and Krawczyk's test.
//
//     K(X) = m - Y f(m) + (1 - Y J(X)) (X - m),    m the middle of X,  Y an approximate J(m)^-1
//
// A box contains no solution if an equation cannot be 0 in it, or if K(X) does not intersect X. It
// contains exactly one solution, a simple zero, if K(X) is inside X. Other boxes are halved until
// they are smaller than the resolution, or until the limit of boxes is reached.
//
// Source: R. Krawczyk, Computing 4 (1969) 187; R. E. Moore, SIAM J. Numer. Anal. 14 (1977) 611.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"
#include "numbers/enclosure.hpp"

namespace elgen {

/// Equations f = 0, at least as many as unknown coordinates. `function` has the entries f; `leaves`
/// has the values of all known leaves.
struct IntervalEquations {
  const Program& program;
  const Function& function;
  std::vector<std::uint32_t> unknowns = {};  ///< coordinates
  LeafValues<Enclosure> leaves = {};
};

/// One enclosure for each unknown.
using Box = std::vector<Enclosure>;

struct BoxSearchResult {
  std::vector<Box> single = {};      ///< each contains one simple zero; two may share a zero
  std::vector<Box> undecided = {};   ///< smaller than the resolution
  std::vector<Box> open_boxes = {};  ///< not yet decided when the limit was reached
  std::uint64_t examined = 0;
};

/// A box is not halved again if each side is shorter than this fraction of the domain's side.
inline constexpr double box_resolution = 1e-7;

/// The boxes of `domain` that may contain solutions, after at most `max_boxes` boxes are examined.
/// Cost per box: up to two evaluations of f, and one evaluation of df/dq_k for each unknown q_k.
[[nodiscard]] BoxSearchResult search_boxes(const IntervalEquations& equations, const Box& domain,
                                           std::uint64_t max_boxes);

/// For each equation f = 0, an enclosure of the values of f on `box`.
[[nodiscard]] std::vector<Enclosure> enclose_values(const IntervalEquations& equations,
                                                    const Box& box);

}  // namespace elgen
