// Lacks: the reasons why a model cannot give an output.
#pragma once

#include <optional>
#include <string>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct Lack {
  Code code;
  std::string reason;
  std::optional<Span> related = {};  ///< the part of the model that prevents the output
  std::string related_message = {};
};

/// None if the model can give the output.
[[nodiscard]] std::optional<Lack> lack_of(const Model& model, const OutputRequest& request);

}  // namespace elgen
