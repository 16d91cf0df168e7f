// Domain: where the functions of a program are called, as far as a model and a scene say so: at the
// values of their parameters, and at states inside the declared ranges.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// An interval in double.
struct Range {
  double low = 0;
  double high = 0;
};

struct Domain {
  /// Drawn over the ranges (sample/states.hpp), parameters at their values. The same on every
  /// machine.
  std::vector<LeafValues<double>> states = {};
  LeafValues<std::optional<Range>> declared = {};
  std::vector<bool> is_alone = {};          ///< by coordinate: it is no component of a quaternion
  std::vector<std::uint32_t> unit_of = {};  ///< by parameter: equal numbers for equal units
};

/// The domain of functions that take these leaves. Cost: eight states.
[[nodiscard]] Domain domain_of(const Model& model, const Scene& scene, const Program& program);

}  // namespace elgen
