// LeafNames: what the leaves of every later stage are called, as the model writes them.
#pragma once

#include <string>
#include <vector>

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

}  // namespace elgen
