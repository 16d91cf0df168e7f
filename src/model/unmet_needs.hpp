// unmet_needs: the reasons why a model cannot provide an output.
#pragma once

#include <optional>
#include <string>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct UnmetNeed {
  Code code;
  std::string reason;
  std::optional<Span> related = {};  ///< the entry or expression that prevents the output
  std::string related_message = {};
};

/// The first need of the output that the model does not meet; none if all needs are met.
[[nodiscard]] std::optional<UnmetNeed> find_unmet_need(const Model& model,
                                                       const OutputRequest& request);

}  // namespace elgen
