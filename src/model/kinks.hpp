// kinked_calls: the calls of abs, sign, min and max at which forces or laws have kinks.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A call with a kink, whose arguments change along a motion.
struct KinkedCall {
  ExpressionId call = 0;
  bool is_of_law = false;
  /// The velocity, if it is the only variable in the arguments; otherwise none.
  std::optional<std::size_t> rate = {};
};

/// The laws of inputs that have a law, in the order of the inputs.
[[nodiscard]] std::vector<ExpressionId> laws_of(const Model& model, const Scene& scene);

/// The calls in forces, then the calls in `laws`; calls in arguments of others come first.
[[nodiscard]] std::vector<KinkedCall> kinked_calls(const Model& model,
                                                   const std::vector<ExpressionId>& laws);

}  // namespace elgen
