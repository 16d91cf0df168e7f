// Domain: the ranges and typical states of the arguments of a program. Parameters have the values
// of the scene; states are inside the declared ranges of the model and the scene.
#pragma once

#include <vector>

#include "elgen/leaf_names.hpp"
#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The data that random states are drawn from: the ranges of a model, the parameter values of a
/// scene, and the leaves that functions take.
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
  /// Random states in the ranges (sample/states.hpp); parameters have the values of the scene. The
  /// states are the same on every machine.
  std::vector<LeafValues<double>> states = {};
  /// Coordinates q at which V of [energy] is stationary (find_potential_minima() of choose.hpp).
  std::vector<std::vector<double>> minima = {};
};

/// The ranges of `space`, and eight random states inside them; no minima. The result refers to
/// space.model.
[[nodiscard]] Domain domain_of(const StateSpace& space);

}  // namespace elgen
