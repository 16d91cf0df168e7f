// cancelling_places: where sums of a function vanish.
//
//     before    F*sqrt((x - a)^2 + y^2)
//     after     x near a and -a, x near 0, y near 0; together: x near a and y near 0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// A coordinate is near `factor` times another one, or near the number `factor`.
struct NearPlace {
  std::uint32_t coordinate = 0;
  double factor = 0;
  std::optional<std::uint32_t> other = {};
  friend bool operator==(const NearPlace&, const NearPlace&) = default;
};

using NearPlaces = std::vector<NearPlace>;

struct CancellingPlaces {
  NearPlaces of_coordinates = {};        ///< one coordinate each, taken from them in turn
  std::vector<NearPlaces> of_sums = {};  ///< all coordinates of one sum
};

/// 0, where two terms of a sum cancel, and right angles, at the values that the parameters have in
/// the first state of `domain`; and where a sum under a product, a root, a quotient or a function
/// vanishes with all of its terms. `most`: places of one coordinate. Cost: one walk over `text`.
[[nodiscard]] CancellingPlaces cancelling_places(const Program& program, const Function& text,
                                                 const Domain& domain, std::size_t most);

}  // namespace elgen
