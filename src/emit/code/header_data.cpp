// header_data: fills the holes in the order of the file.
#include "emit/code/header_data.hpp"

#include <fmt/format.h>

#include "emit/code/definition.hpp"
#include "emit/code/function_docs.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/pages/introduction.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

using List = TemplateData::type;

TemplateData struct_data(const FunctionText& text, const Dialect& dialect) {
  std::vector<Member> members;
  for (const Field& field : text.function.fields) {
    const std::string declaration = dialect.member(text.function, field);
    if (!declaration.empty()) members.push_back({declaration, field_summary(text, field)});
  }
  TemplateData data;
  data.set("name", dialect.struct_name(text.function));
  data.set("doc", fmt::format("The results of {}.", text.function.name));
  data.set("members", lines_data(documented_members(members)));
  return data;
}

TemplateData parts_data(const Function& function, const Dialect& dialect,
                        const FunctionDefinition& definition) {
  TemplateData list(List::list);
  for (const auto& [signature, body] : definition.parts) {
    TemplateData part;
    part.set("signature", signature);
    part.set("body", body);
    list.push_back(part);
  }
  TemplateData data;
  data.set("function", function.name);
  data.set("workspace", dialect.workspace_name(function));
  data.set("values", lines_data(definition.workspace));
  data.set("part", list);
  return data;
}

TemplateData function_data(const EmissionInput& input, const Dialect& dialect, std::size_t index) {
  const Function& function = input.program.functions[index];
  const FunctionText text{input.model,
                          input.program,
                          function,
                          input.equations[index],
                          input.scene.base_name + ".equations.json",
                          input.scene.emission};
  TemplateData data;
  const bool has_struct = gives_struct(function);
  data.set("struct",
           section_if(has_struct, has_struct ? struct_data(text, dialect) : TemplateData()));
  data.set("summary", function_heading(text));
  data.set("documentation", lines_data(function_docs(text)));
  const FunctionDefinition written =
      definition(dialect, input.program, function, input.scene.emission.storage);
  const bool has_parts = !written.parts.empty();
  data.set("parts", section_if(has_parts, has_parts ? parts_data(function, dialect, written)
                                                    : TemplateData()));
  data.set("signature", written.whole.signature);
  data.set("body", written.whole.body);
  return data;
}

TemplateData functions(const EmissionInput& input, const Dialect& dialect) {
  TemplateData list(List::list);
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    list.push_back(function_data(input, dialect, i));
  }
  return list;
}

void set_counts(TemplateData& data, const EmissionInput& input) {
  data.set("coordinate_count", std::to_string(input.model.coordinates.size()));
  data.set("velocity_count", std::to_string(input.model.velocities.size()));
  data.set("input_count", std::to_string(input.model.inputs.size()));
  const std::size_t constraints = input.model.constraints.size();
  data.set("constraints", section_if(constraints > 0));
  data.set("constraint_count", std::to_string(constraints));
  data.set("pivots", std::string(pivot_count(input.model)));
  data.set("pivot_count", std::to_string(input.model.velocities.size() + constraints));
  data.set("what_is_regular",
           std::string(constraints > 0 ? "and A M^-1 A^T are regular" : "is regular"));
  const std::size_t open_values = input.model.open_values.size();
  data.set("open_values", section_if(open_values > 0));
  data.set("open_value_count", std::to_string(open_values));
  data.set("momenta", section_if(is_passed(input.program.leaves, Opcode::momentum)));
  data.set("parameter_count", std::to_string(emitted_parameter_count(input.model, input.program)));
}

/// kainjow leaves an empty line where a section on lines of its own is not rendered.
std::string without_repeated_blank_lines(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool repeats = c == '\n' && result.size() > 1 && result.back() == '\n' &&
                         result[result.size() - 2] == '\n';
    if (!repeats) result += c;
  }
  return result;
}

}  // namespace

TemplateData stamp_data(const EmissionInput& input) {
  TemplateData data;
  data.set("generated", input.generated);
  data.set("model_hash", input.model_hash);
  data.set("scene_hash", input.scene_hash);
  data.set("body_hash", std::string(blank_hash()));
  data.set("namespace", name_space(input.scene));
  data.set("storage", std::string(name_of(input.scene.emission.storage)));
  return data;
}

TemplateData header_data(const EmissionInput& input, const Dialect& dialect) {
  TemplateData data = stamp_data(input);
  set_counts(data, input);
  data.set("introduction", lines_data(introduction(input.model, input.scene, input.program)));
  data.set("operation_table", lines_data(operation_table(input.program)));
  const auto has = [&input](FunctionId function) { return calls(input.program, function); };
  const bool has_kinks = has(FunctionId::sign) || has(FunctionId::min) || has(FunctionId::max);
  data.set("kinks", section_if(has_kinks));
  data.set("stumpff", section_if(has(FunctionId::stumpff)));
  data.set("functions", functions(input, dialect));
  data.set("regular", section_if(gives_pivots(input.program)));
  return data;
}

std::string header_text(std::string_view path, const TemplateData& data) {
  return stamped(without_repeated_blank_lines(fill_template(path, data)));
}

}  // namespace elgen
