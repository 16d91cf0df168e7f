// parameters: a parameter is emitted until the scene has fixed all of its elements.
#include "parameters.hpp"

#include <fmt/format.h>

#include <vector>

#include "evaluate/decimal.hpp"
#include "layout.hpp"

namespace elgen {

bool is_emitted(const ParameterArray& array, const Scene& scene) {
  for (std::uint32_t i = 0; i < array.count; ++i) {
    if (scene.specialisation.fixed.count(array.first + i) == 0) return true;
  }
  return false;
}

std::size_t emitted_parameter_count(const Model& model, const Scene& scene) {
  std::size_t count = 0;
  for (const ParameterArray& array : model.parameter_arrays) {
    if (is_emitted(array, scene)) count += array.count;
  }
  return count;
}

std::string parameter_doc(const ParameterArray& array) {
  std::vector<std::string> parts;
  if (!array.doc.empty()) parts.push_back(comment_text(array.doc));
  if (!array.unit_text.empty()) parts.push_back("[" + comment_text(array.unit_text) + "]");
  if (array.range) {
    parts.push_back(
        fmt::format("in [{}, {}]", exact_text(array.range->low), exact_text(array.range->high)));
  }
  return parts.empty() ? array.name : fmt::format("{}", fmt::join(parts, " "));
}

}  // namespace elgen
