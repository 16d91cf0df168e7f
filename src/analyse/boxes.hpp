// Boxes: all solutions of equations in a box, by interval arithmetic and Krawczyk's test.
//
//     K(X) = m - Y f(m) + (1 - Y J(X)) (X - m),    m the middle of X,  Y about J(m)^-1
//
// A box where an equation cannot be 0, or that K(X) does not meet, holds no solution; where K(X) is
// inside of X it holds exactly one, which is a simple zero. Other boxes are halved until they are
// smaller than the resolution, or all that may be looked at are used up.
//
// Source: R. Krawczyk, Computing 4 (1969) 187; R. E. Moore, SIAM J. Numer. Anal. 14 (1977) 611.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/evaluate.hpp"
#include "elgen/program.hpp"
#include "numbers/enclosure.hpp"

namespace elgen {

/// As many equations as unknowns, or more: entries of the only field of `function`, over unknown
/// coordinates; all other leaves are known.
struct BoxedEquations {
  const Program& program;
  const Function& function;
  std::vector<std::uint32_t> unknowns = {};  ///< coordinates
  LeafValues<Enclosure> leaves = {};
};

/// One enclosure for each unknown.
using Box = std::vector<Enclosure>;

struct BoxSearch {
  std::vector<Box> single = {};     ///< one simple solution in each; neighbours may share theirs
  std::vector<Box> undecided = {};  ///< smaller than the resolution
  std::vector<Box> left = {};       ///< not decided when the limit was reached
  std::uint64_t looked_at = 0;
};

/// A box is undecided where its sides are shorter than this part of those of the domain.
inline constexpr double box_resolution = 1e-7;

/// `most`: the boxes that may be looked at. Cost of each: one evaluation of f and one of its slopes
/// for every unknown.
[[nodiscard]] BoxSearch search_boxes(const BoxedEquations& equations, const Box& domain,
                                     std::uint64_t most);

/// The values of all equations on a box.
[[nodiscard]] std::vector<Enclosure> values_on(const BoxedEquations& equations, const Box& box);

}  // namespace elgen
