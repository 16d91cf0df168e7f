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

TemplateData struct_data(const FunctionDocsInput& text, const Dialect& dialect) {
  std::vector<Member> members;
  for (const Field& field : text.function.fields) {
    const std::string declaration = dialect.field_declaration(text.function, field);
    if (!declaration.empty()) members.push_back({declaration, field_summary(text, field)});
  }
  return TemplateRow{
      {"name", dialect.struct_name(text.function)},
      {"doc", fmt::format("Result type of {}.", text.function.name)},
      {"members", lines_section(member_doc_lines(members, dialect.body_rules().comments))}};
}

TemplateData function_data(const EmissionInput& input, const Dialect& dialect, std::size_t index) {
  const Function& function = input.program.functions[index];
  const FunctionDocsInput text{input.model,
                               input.program,
                               function,
                               input.equations[index],
                               input.scene.base_name + ".equations.json",
                               input.scene.emission};
  const bool has_struct = returns_struct(function);
  const FunctionDefinition written =
      dialect.function_definition(function, input.scene.emission.storage);
  return TemplateRow{{"struct", optional_section(has_struct, has_struct ? struct_data(text, dialect)
                                                                        : TemplateData())},
                     {"summary", function_heading(text)},
                     {"documentation", lines_section(dialect.escape_docs(function_docs(text)))},
                     {"parts", parts_section(function, written)},
                     {"signature", written.whole.signature},
                     {"body", written.whole.body}};
}

TemplateData functions_data(const EmissionInput& input, const Dialect& dialect) {
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
  data.set("constraints", optional_section(constraints > 0));
  data.set("constraint_count", std::to_string(constraints));
  const std::size_t open_values = input.model.open_values.size();
  data.set("open_values", optional_section(open_values > 0));
  data.set("open_value_count", std::to_string(open_values));
  data.set("momenta", optional_section(may_be_argument(input.program.leaves, Opcode::momentum)));
  data.set("parameter_count", std::to_string(emitted_parameter_count(input.model, input.program)));
}

/// Removes blanks at line ends and keeps at most `max_empty_lines` empty lines in a row: kainjow
/// leaves an empty line for each section that is not rendered.
std::string remove_extra_blanks(const std::string& text, std::size_t max_empty_lines) {
  const std::string ends(max_empty_lines + 1, '\n');
  std::string result;
  for (const char c : text) {
    while (c == '\n' && result.ends_with(' ')) result.pop_back();
    if (c != '\n' || !result.ends_with(ends)) result += c;
  }
  return result;
}

bool exceeds_double(const cln::cl_R& value) {
  return scalar_fit(value, ScalarKind::double_precision) == ScalarFit::too_large;
}

/// True if the program calls stumpff(x, k) with k < 0.
bool has_negative_stumpff_order(const Program& program) {
  return std::ranges::any_of(program.functions, [&program](const Function& function) {
    return std::ranges::any_of(function.instructions, [&](const Instruction& i) {
      const bool is_series = i.opcode == Opcode::call && i.function == FunctionId::stumpff;
      return is_series && stumpff_order(program, function, i.b) < 0;
    });
  });
}

}  // namespace

TemplateData stamp_data(const EmissionInput& input) {
  return TemplateRow{{"generated", input.generated_notice},
                     {"model_hash", input.model_hash},
                     {"scene_hash", input.scene_hash},
                     {"body_hash", std::string(blank_hash())},
                     {"namespace", name_space(input.scene)},
                     {"storage", std::string(name_of(input.scene.emission.storage))}};
}

TemplateData parts_section(const Function& function, const FunctionDefinition& definition,
                           const std::string& types) {
  const TemplateData parts = repeated_section(definition.parts, [](const DefinitionText& part) {
    return TemplateRow{{"signature", part.signature}, {"body", part.body}};
  });
  return optional_section(!definition.parts.empty(),
                          TemplateRow{{"function", function.name},
                                      {"workspace", definition.workspace.name},
                                      {"values", lines_section(definition.workspace.members)},
                                      {"types", types},
                                      {"part", parts}});
}

void set_pivot_data(TemplateData& data, const EmissionInput& input) {
  const std::size_t constraints = input.model.constraints.size();
  data.set("pivots", std::string(pivot_count_text(input.model)));
  data.set("pivot_count", std::to_string(input.model.velocities.size() + constraints));
  data.set("what_is_regular",
           std::string(constraints > 0 ? "and A M^-1 A^T are regular" : "is regular"));
  data.set("unseen", optional_section(constraints > 0));
  data.set("regular", optional_section(returns_pivots(input.program)));
}

bool has_column_loops(const Program& program) {
  return std::ranges::any_of(program.functions,
                             [](const Function& function) { return function.repeated.count > 0; });
}

TemplateData header_data(const EmissionInput& input, const Dialect& dialect) {
  TemplateData data = stamp_data(input);
  set_counts(data, input);
  data.set(
      "introduction",
      lines_section(dialect.escape_docs(introduction(input.model, input.scene, input.program))));
  data.set("operation_table", lines_section(dialect.escape_docs(operation_table(input.program))));
  const auto has = [&input](FunctionId function) {
    return calls_function(input.program, function);
  };
  const bool has_kinks = has(FunctionId::sign) || has(FunctionId::min) || has(FunctionId::max);
  data.set("kinks", optional_section(has_kinks));
  data.set("compares", optional_section(compares_numbers(input.program)));
  const auto calls_numbers = [](const Function& function) {
    return std::ranges::any_of(function.instructions, [&function](const Instruction& i) {
      return is_call_of_numbers(function, i);
    });
  };
  data.set("run_time",
           optional_section(std::ranges::any_of(input.program.functions, calls_numbers)));
  data.set("columns", optional_section(has_column_loops(input.program)));
  data.set("stumpff", optional_section(has(FunctionId::stumpff)));
  data.set("hyperbolic", optional_section(has_negative_stumpff_order(input.program)));
  data.set("functions", functions_data(input, dialect));
  set_pivot_data(data, input);
  return data;
}

std::vector<std::string> element_literals(const DeclaredArray& array, std::string_view interval,
                                          std::string_view unbounded) {
  const auto bound = [&](const cln::cl_R& value, const char* sign) {
    return exceeds_double(value) ? fmt::format("{}{}", sign, unbounded)
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

bool has_unbounded_element(const DeclaredArray& array) {
  const auto is_open = [](const std::optional<Interval>& range) {
    return !range || exceeds_double(range->low) || exceeds_double(range->high);
  };
  return std::ranges::any_of(array.numbers, exceeds_double) ||
         std::ranges::any_of(array.intervals, is_open);
}

std::string omission_note(const Function& function) {
  return fmt::format(" {} is omitted: it has more than {} entries.", function.name,
                     max_returned_entries);
}

std::vector<std::string> wrap_notes(const std::vector<std::string>& notes) {
  std::vector<std::string> lines;
  for (const std::string& note : notes) {
    for (std::string& line : wrap_words(note, {line_width - 2, " "}))
      lines.push_back(std::move(line));
  }
  return lines;
}

std::string fill_header_template(std::string_view path, const TemplateData& data,
                                 std::size_t most_empty) {
  return with_body_hash(remove_extra_blanks(fill_template(path, data), most_empty));
}

}  // namespace elgen
