// parameters: what a program reads, it reads by the names of its leaves.
#include "emit/text/parameters.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <unordered_map>

#include "base/number_text.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

std::string member_text(const Model& model, const Parameter& parameter) {
  const ParameterArray& array = model.parameter_arrays[parameter.array];
  return array.is_array ? fmt::format("{}[{}]", array.name, parameter.element) : array.name;
}

}  // namespace

std::vector<ParameterArray> emitted_parameters(const Model& model, const Program& program) {
  std::set<std::string> names;
  for (const Function& function : program.functions) {
    for (const Instruction& instruction : function.instructions) {
      const bool is_parameter = instruction.opcode == Opcode::parameter;
      if (is_parameter) names.insert(program.leaves.parameters[instruction.a]);
    }
  }
  std::vector<bool> is_read(model.parameter_arrays.size(), false);
  for (const Parameter& parameter : model.parameters) {
    if (names.count(parameter.name) > 0) is_read[parameter.array] = true;
  }
  std::vector<ParameterArray> result;
  for (std::size_t i = 0; i < is_read.size(); ++i) {
    if (is_read[i]) result.push_back(model.parameter_arrays[i]);
  }
  return result;
}

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

std::size_t emitted_parameter_count(const Model& model, const Program& program) {
  std::size_t count = 0;
  for (const ParameterArray& array : emitted_parameters(model, program)) count += array.count;
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
