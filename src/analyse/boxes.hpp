// Boxes: all solutions of equations in a box, by interval arithmetic and Krawczyk's test.
//
//     K(X) = m - Y f(m) + (1 - Y J(X)) (X - m),    m the middle of X,  Y about J(m)^-1
//
// A box holds no solution if an equation cannot be 0 in it, or if K(X) does not meet X. It holds
// exactly one, a simple zero, if K(X) is inside of X. Other boxes are halved until they are smaller
// than the resolution or the limit of boxes is reached.
//
// Source: R. Krawczyk, Computing 4 (1969) 187; R. E. Moore, SIAM J. Numer. Anal. 14 (1977) 611.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"
#include "numbers/enclosure.hpp"

namespace elgen {

/// At least as many equations as unknown coordinates: entries of the only field of `function`. All
/// other leaves are known.
struct BoxedEquations {
  const Program& program;
  const Function& function;
  std::vector<std::uint32_t> unknowns = {};  ///< coordinates
  LeafValues<Enclosure> leaves = {};
};

/// One enclosure for each unknown.
using Box = std::vector<Enclosure>;

struct BoxSearch {
  std::vector<Box> single = {};     ///< one simple solution each, maybe a shared one
  std::vector<Box> undecided = {};  ///< smaller than the resolution
  std::vector<Box> left = {};       ///< undecided when the limit was reached
  std::uint64_t looked_at = 0;
};

/// A box is undecided if its sides are shorter than this fraction of the domain.
inline constexpr double box_resolution = 1e-7;

/// `most` limits the number of boxes. Cost per box: one evaluation of f, and one of its slopes per
/// unknown.
[[nodiscard]] BoxSearch search_boxes(const BoxedEquations& equations, const Box& domain,
                                     std::uint64_t most);

/// The values of all equations on a box.
[[nodiscard]] std::vector<Enclosure> values_on(const BoxedEquations& equations, const Box& box);

}  // namespace elgen
