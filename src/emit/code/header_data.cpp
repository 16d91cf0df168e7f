// header_data: sets the variables of the templates, in the order of the lines of a header.
#include "emit/code/header_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "emit/code/function_docs.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/pages/introduction.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"
#include "numbers/scalar_literal.hpp"

namespace elgen {
namespace {

TemplateData struct_data(const FunctionText& text, const Dialect& dialect) {
  std::vector<Member> members;
  for (const Field& field : text.function.fields) {
    const std::string declaration = dialect.member(text.function, field);
    if (!declaration.empty()) members.push_back({declaration, field_summary(text, field)});
  }
  return TemplateRow{
      {"name", dialect.struct_name(text.function)},
      {"doc", fmt::format("Result type of {}.", text.function.name)},
      {"members", lines_data(documented_members(members, dialect.rules().comments))}};
}

TemplateData parts_data(const Function& function, const FunctionDefinition& definition) {
  const TemplateData parts = rows_data(definition.parts, [](const DefinitionText& part) {
    return TemplateRow{{"signature", part.signature}, {"body", part.body}};
  });
  return TemplateRow{{"function", function.name},
                     {"workspace", definition.workspace.name},
                     {"values", lines_data(definition.workspace.values)},
                     {"part", parts}};
}

TemplateData function_data(const EmissionInput& input, const Dialect& dialect, std::size_t index) {
  const Function& function = input.program.functions[index];
  const FunctionText text{input.model,
                          input.program,
                          function,
                          input.equations[index],
                          input.scene.base_name + ".equations.json",
                          input.scene.emission};
  const bool has_struct = returns_struct(function);
  const FunctionDefinition written = dialect.definition(function, input.scene.emission.storage);
  const bool has_parts = !written.parts.empty();
  return TemplateRow{
      {"struct", section_if(has_struct, has_struct ? struct_data(text, dialect) : TemplateData())},
      {"summary", function_heading(text)},
      {"documentation", lines_data(dialect.escape_docs(function_docs(text)))},
      {"parts", section_if(has_parts, has_parts ? parts_data(function, written) : TemplateData())},
      {"signature", written.whole.signature},
      {"body", written.whole.body}};
}

TemplateData functions(const EmissionInput& input, const Dialect& dialect) {
  TemplateData list(TemplateData::type::list);
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
  const std::size_t open_values = input.model.open_values.size();
  data.set("open_values", section_if(open_values > 0));
  data.set("open_value_count", std::to_string(open_values));
  data.set("momenta", section_if(is_passed(input.program.leaves, Opcode::momentum)));
  data.set("parameter_count", std::to_string(emitted_parameter_count(input.model, input.program)));
}

/// Removes blanks at line ends and keeps at most `most_empty` empty lines in a row: kainjow leaves
/// an empty line for each section that is not rendered.
std::string without_extra_blanks(const std::string& text, std::size_t most_empty) {
  const std::string ends(most_empty + 1, '\n');
  std::string result;
  for (const char c : text) {
    while (c == '\n' && result.ends_with(' ')) result.pop_back();
    if (c != '\n' || !result.ends_with(ends)) result += c;
  }
  return result;
}

bool is_beyond_double(const cln::cl_R& value) {
  return fit(value, ScalarKind::double_precision) == Fit::too_large;
}

/// True if the program calls stumpff(x, k) with k < 0.
bool has_negative_order(const Program& program) {
  return std::ranges::any_of(program.functions, [&program](const Function& function) {
    return std::ranges::any_of(function.instructions, [&](const Instruction& i) {
      const bool is_series = i.opcode == Opcode::call && i.function == FunctionId::stumpff;
      return is_series && stumpff_order(program, function, i.b) < 0;
    });
  });
}

}  // namespace

TemplateData stamp_data(const EmissionInput& input) {
  return TemplateRow{{"generated", input.generated},
                     {"model_hash", input.model_hash},
                     {"scene_hash", input.scene_hash},
                     {"body_hash", std::string(blank_hash())},
                     {"namespace", name_space(input.scene)},
                     {"storage", std::string(name_of(input.scene.emission.storage))}};
}

void set_regular(TemplateData& data, const EmissionInput& input) {
  const std::size_t constraints = input.model.constraints.size();
  data.set("pivots", std::string(pivot_count(input.model)));
  data.set("pivot_count", std::to_string(input.model.velocities.size() + constraints));
  data.set("what_is_regular",
           std::string(constraints > 0 ? "and A M^-1 A^T are regular" : "is regular"));
  data.set("unseen", section_if(constraints > 0));
  data.set("regular", section_if(returns_pivots(input.program)));
}

bool has_loops(const Program& program) {
  return std::ranges::any_of(program.functions,
                             [](const Function& function) { return function.repeated.count > 0; });
}

TemplateData header_data(const EmissionInput& input, const Dialect& dialect) {
  TemplateData data = stamp_data(input);
  set_counts(data, input);
  data.set("introduction",
           lines_data(dialect.escape_docs(introduction(input.model, input.scene, input.program))));
  data.set("operation_table", lines_data(dialect.escape_docs(operation_table(input.program))));
  const auto has = [&input](FunctionId function) { return calls(input.program, function); };
  const bool has_kinks = has(FunctionId::sign) || has(FunctionId::min) || has(FunctionId::max);
  data.set("kinks", section_if(has_kinks));
  data.set("columns", section_if(has_loops(input.program)));
  data.set("stumpff", section_if(has(FunctionId::stumpff)));
  data.set("hyperbolic", section_if(has_negative_order(input.program)));
  data.set("functions", functions(input, dialect));
  set_regular(data, input);
  return data;
}

std::vector<std::string> declared_elements(const DeclaredArray& array, std::string_view interval,
                                           std::string_view unbounded) {
  const auto bound = [&](const cln::cl_R& value, const char* sign) {
    return is_beyond_double(value) ? fmt::format("{}{}", sign, unbounded)
                                   : shortest_literal(value, ScalarKind::double_precision);
  };
  std::vector<std::string> elements;
  for (const std::string& text : array.texts) elements.push_back(string_literal(text));
  for (const cln::cl_R& number : array.numbers) elements.push_back(bound(number, ""));
  for (const std::optional<Interval>& range : array.intervals) {
    elements.push_back(fmt::format(fmt::runtime(interval),
                                   range ? bound(range->low, "-") : fmt::format("-{}", unbounded),
                                   range ? bound(range->high, "") : std::string(unbounded)));
  }
  return elements;
}

bool has_unbounded(const DeclaredArray& array) {
  const auto is_open = [](const std::optional<Interval>& range) {
    return !range || is_beyond_double(range->low) || is_beyond_double(range->high);
  };
  return std::ranges::any_of(array.numbers, is_beyond_double) ||
         std::ranges::any_of(array.intervals, is_open);
}

std::string left_out_note(const Function& function) {
  return fmt::format(" {} is omitted: it has more than {} entries.", function.name,
                     largest_returned);
}

std::vector<std::string> wrapped_notes(const std::vector<std::string>& notes) {
  std::vector<std::string> lines;
  for (const std::string& note : notes) {
    for (std::string& line : wrap_words(note, {line_width - 2, " "}))
      lines.push_back(std::move(line));
  }
  return lines;
}

std::string header_text(std::string_view path, const TemplateData& data, std::size_t most_empty) {
  return with_body_hash(without_extra_blanks(fill_template(path, data), most_empty));
}

}  // namespace elgen
