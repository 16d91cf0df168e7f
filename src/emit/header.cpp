// header: fills the holes of the picture, section by section, in the order of the file.
#include "header.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cpp_constant.hpp"
#include "cpp_declarations.hpp"
#include "cpp_function.hpp"
#include "cpp_names.hpp"
#include "cpp_spelling.hpp"
#include "embedded_templates.hpp"
#include "evaluate/decimal.hpp"
#include "function_docs.hpp"
#include "introduction.hpp"
#include "layout.hpp"
#include "render.hpp"
#include "stamp.hpp"

namespace elgen {
namespace {

using List = TemplateData::type;

/// A template that stands on a line of its own in another one, which ends the line.
std::string partial(std::string_view path) {
  std::string text(embedded_template(path));
  if (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// The functions that hold constants too long to stand in an equation, in order of the program.
TemplateData numbers(const Program& program) {
  TemplateData list(List::list);
  std::set<std::string> written;
  for (const Constant& constant : program.constants) {
    const std::string name = constant_name(constant);
    if (is_short_constant(constant.value) || !written.insert(name).second) continue;
    TemplateData item;
    const cln::cl_R magnitude = cln::abs(constant.value);
    item.set("text", is_rational(magnitude) ? exact_text(magnitude) : constant.text);
    item.set("name", name);
    const Wrapping wrapping{line_width - 10, std::string(6, ' ')};
    item.set("value",
             fmt::format(
                 "{}", fmt::join(wrap_expression(cpp_magnitude(constant.value), wrapping), "\n")));
    list.push_back(item);
  }
  return list;
}

bool has_kinks(const Program& program) {
  return std::any_of(program.functions.begin(), program.functions.end(), [](const Function& f) {
    const std::set<FunctionId> calls = called_functions(f);
    return calls.count(FunctionId::sign) + calls.count(FunctionId::min) +
               calls.count(FunctionId::max) >
           0;
  });
}

TemplateData struct_data(const FunctionText& text) {
  std::vector<Member> members;
  for (const Field& field : text.function.fields) {
    const std::string type = field_type(kind_of_field(text.program, text.function, field), field);
    members.push_back({fmt::format("{} {};", type, field.name), field_summary(text, field)});
  }
  TemplateData data;
  data.set("name", struct_name(text.function));
  data.set("doc", fmt::format("What {} returns.", text.function.name));
  data.set("members", lines_data(documented_members(members)));
  return data;
}

TemplateData parts_data(const Function& function, const CppFunction& definition) {
  TemplateData list(List::list);
  for (const auto& [signature, body] : definition.parts) {
    TemplateData part;
    part.set("signature", signature);
    part.set("body", body);
    list.push_back(part);
  }
  TemplateData data;
  data.set("function", function.name);
  data.set("workspace", workspace_name(function));
  data.set("values", lines_data(definition.workspace));
  data.set("part", list);
  return data;
}

TemplateData function_data(const EmissionInput& input, std::size_t index) {
  const Function& function = input.program.functions[index];
  const FunctionText text{input.model, input.program, function, input.equations[index],
                          input.scene.base_name + ".equations.json"};
  TemplateData data;
  data.set("struct", section_if(returns_struct(function),
                                returns_struct(function) ? struct_data(text) : TemplateData()));
  data.set("documentation", lines_data(function_docs(text)));
  const CppFunction definition = cpp_function(input.model, input.program, function);
  const bool has_parts = !definition.parts.empty();
  data.set("parts",
           section_if(has_parts, has_parts ? parts_data(function, definition) : TemplateData()));
  data.set("signature", definition.definition.signature);
  data.set("body", definition.definition.body);
  return data;
}

TemplateData functions(const EmissionInput& input) {
  TemplateData list(List::list);
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    list.push_back(function_data(input, i));
  }
  return list;
}

bool has_pivots(const Program& program) {
  return std::any_of(program.functions.begin(), program.functions.end(),
                     [](const Function& f) { return f.kind == OutputKind::forward_dynamics; });
}

void set_stamp(TemplateData& data, const EmissionInput& input) {
  data.set("generated", input.generated);
  data.set("model_hash", input.model_hash);
  data.set("scene_hash", input.scene_hash);
  data.set("body_hash", std::string(blank_hash()));
}

void set_counts(TemplateData& data, const EmissionInput& input) {
  const Dimensions size = dimensions(input.model);
  data.set("coordinate_count", std::to_string(size.coordinates));
  data.set("velocity_count", std::to_string(size.velocities));
  data.set("input_count", std::to_string(size.inputs));
  data.set("parameter_count", std::to_string(emitted_parameter_count(input.model, input.scene)));
}

}  // namespace

std::string cpp_header(const EmissionInput& input) {
  TemplateData data;
  set_stamp(data, input);
  set_counts(data, input);
  data.set("introduction", lines_data(introduction(input.model, input.scene, input.program)));
  data.set("operation_table", lines_data(operation_table(input.program)));
  data.set("namespace", cpp_namespace(input.scene));
  data.set("declared", declared_arrays(input.model));
  data.set("constant", partial("cpp/constant.hpp.mustache"));
  data.set("filled", section_if(has_filled_array(input.model, input.scene)));
  data.set("numbers", numbers(input.program));
  data.set("kinks", section_if(has_kinks(input.program)));
  data.set("kinked", partial("cpp/kinked.hpp.mustache"));
  data.set("parameters",
           lines_data(documented_members(parameter_members(input.model, input.scene))));
  data.set("functions", functions(input));
  data.set("parts_of_function", partial("cpp/parts.hpp.mustache"));
  data.set("regular", section_if(has_pivots(input.program)));
  return stamped(render("cpp/header.hpp.mustache", data));
}

}  // namespace elgen
