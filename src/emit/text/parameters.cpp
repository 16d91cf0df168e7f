// parameters: a leaf is known by its name.
#include "emit/text/parameters.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

#include "emit/text/layout.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

std::string member_text(const Model& model, const Parameter& parameter) {
  const ParameterArray& array = model.parameter_arrays[parameter.array];
  return array.is_array ? fmt::format("{}[{}]", array.name, parameter.element) : array.name;
}

}  // namespace

std::vector<std::string> parameter_members(const Model& model, const LeafNames& leaves) {
  std::unordered_map<std::string_view, const Parameter*> known;
  for (const Parameter& parameter : model.parameters) known.emplace(parameter.name, &parameter);
  std::vector<std::string> members;
  for (const std::string& leaf : leaves.parameters) {
    const auto found = known.find(leaf);
    members.push_back(found == known.end() ? leaf : member_text(model, *found->second));
  }
  return members;
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
