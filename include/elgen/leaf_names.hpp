// LeafNames: what the leaves of every later stage are called, as the model writes them.
#pragma once

#include <string>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

struct LeafNames {
  std::vector<std::string> parameters = {};   ///< "m", "l[2]"
  std::vector<std::string> coordinates = {};  ///< "theta", "q[1]"
  std::vector<std::string> velocities = {};   ///< what dot() is written around, as above
  std::vector<std::string> inputs = {};
  bool uses_time = false;
};

[[nodiscard]] LeafNames leaf_names(const Model& model);

/// draw() for every leaf, in their order, t among them.
template <class Draw>
[[nodiscard]] auto draw_leaves(const LeafNames& leaves, const Draw& draw) {
  const auto list = [&draw](std::size_t count) {
    std::vector<decltype(draw())> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(draw());
    return values;
  };
  const std::size_t velocities = leaves.velocities.size();
  const PerLeaf<std::size_t, std::size_t> counts{leaves.parameters.size(),
                                                 leaves.coordinates.size(),
                                                 velocities,
                                                 velocities,
                                                 leaves.inputs.size(),
                                                 1};
  return map_kinds(
      list, [&draw](std::size_t) { return draw(); }, counts);
}

}  // namespace elgen
