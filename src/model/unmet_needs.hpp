// Lacks: the reasons why a model cannot give an output.
#pragma once

#include <optional>
#include <string>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct UnmetNeed {
  Code code;
  std::string reason;
  std::optional<Span> related = {};  ///< the part of the model that prevents the output
  std::string related_message = {};
};

/// None if the model can give the output.
[[nodiscard]] std::optional<UnmetNeed> find_unmet_need(const Model& model,
                                                       const OutputRequest& request);

}  // namespace elgen
