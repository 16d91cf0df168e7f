// Domain: where the functions of a program are called, as far as a model and a scene say so: at the
// values of their parameters, and at states inside the declared ranges.
#pragma once

#include <vector>

#include "elgen/leaf_names.hpp"
#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// States are drawn by the ranges of a model, the values that a scene gives to parameters, and the
/// leaves that functions take.
struct StateSpace {
  const Model& model;
  const Scene& scene;
  const LeafNames& leaves;
};

/// An interval in double.
struct Range {
  double low = 0;
  double high = 0;
};

struct Domain {
  const Model& model;
  LeafValues<Range> ranges = {};
  /// Drawn over the ranges (sample/states.hpp), parameters at their values. The same on every
  /// machine.
  std::vector<LeafValues<double>> states = {};
};

/// The model outlives it. Cost: eight states.
[[nodiscard]] Domain domain_of(const StateSpace& space);

}  // namespace elgen
