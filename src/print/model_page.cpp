// model_page: the variables of a model and the equations of its outputs, with the symbols and
// definitions of the output table.
#include <fmt/ranges.h>

#include <utility>

#include "elgen/page.hpp"
#include "elgen/step_methods.hpp"
#include "elgen/wording.hpp"
#include "model/symbols.hpp"
#include "numbers/exact_number.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

std::vector<PageVariable> coordinate_variables(const Model& model,
                                               const LeafValues<Formula>& symbols) {
  std::vector<PageVariable> list;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& c = model.coordinates[i];
    const std::string& doc = c.rotation ? model.rotations[*c.rotation].doc : c.doc;
    list.push_back({symbols.q[i], c.name, c.unit_text, "", doc});
  }
  for (std::size_t i = 0; i < model.velocities.size(); ++i) {
    const Velocity& v = model.velocities[i];
    if (!v.rotation) continue;
    list.push_back({symbols.v[i], "dot(" + v.name + ")", "rad/s", "",
                    "angular velocity in the axes of the body"});
  }
  return list;
}

std::vector<PageVariable> input_variables(const Model& model, const Formulas& symbols) {
  std::vector<PageVariable> list;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Input& input = model.inputs[i];
    list.push_back({symbols[i], input.name, input.unit_text, "", input.doc});
  }
  return list;
}

std::vector<PageVariable> function_variables(const Model& model, const Formulas& symbols) {
  std::vector<PageVariable> list;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const OpenValue& value = model.open_values[i];
    if (!value.derivative_arguments.empty()) continue;
    const OpenFunction& function = model.functions[value.function];
    list.push_back({symbols[i], function.name, function.unit_text, "", function.doc});
  }
  return list;
}

/// "pi/10": the typed expression `form` of an irrational `value`; without `form`, the exact value.
std::string value_text(const Model& model, const cln::cl_R& value,
                       const std::optional<ExpressionId>& form) {
  return form ? to_string(model, *form) : exact_text(value);
}

/// "0.5"; "0.3, 0.4"; "0.3 each" for equal elements; with "(fixed)" if the code contains the value
/// as a number.
std::string value_text(const Model& model, const Scene& scene, const ParameterArray& array) {
  std::string text;
  bool is_uniform = true;
  bool is_fixed = true;
  std::string first;
  for (std::uint32_t i = array.first; i < array.first + array.count; ++i) {
    const auto fixed = scene.specialisation.fixed.find(i);
    const bool has_value = fixed == scene.specialisation.fixed.end();
    const Parameter& parameter = model.parameters[i];
    const std::string value =
        has_value ? value_text(model, parameter.value, parameter.exact_expression)
                  : value_text(model, fixed->second.number, fixed->second.exact_expression);
    if (i == array.first) first = value;
    is_uniform = is_uniform && value == first;
    is_fixed = is_fixed && !has_value;
    text += (text.empty() ? "" : ", ") + value;
  }
  if (is_uniform) text = first + (array.count > 1 ? " each" : "");
  return text + (is_fixed ? " (fixed)" : "");
}

std::vector<PageVariable> parameter_variables(const Model& model, const Scene& scene,
                                              const Formulas& symbols) {
  std::vector<PageVariable> list;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const ParameterArray& array = model.parameter_arrays[i];
    const std::string name =
        array.is_array ? fmt::format("{}[1..{}]", array.name, array.count) : array.name;
    list.push_back({symbols[i], name, array.unit_text, value_text(model, scene, array), array.doc});
  }
  return list;
}

/// "Mass matrix"; a user's output keeps its name.
std::string title_of(const Function& function) {
  return output_row(function.kind).is_user_output ? function.name : title_from_name(function.name);
}

/// The definition of an output by other outputs; empty if the output has no definition.
Formula output_definition(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  if (!row.definition.empty()) return latex_formula(model, row.definition);
  const bool is_square = !row.driftless_definition.empty() && !model.may_drift;
  if (is_square) return latex_formula(model, row.driftless_definition);
  return heading(model, function).definition;
}

PageSection definition_section(const Model& model, const Function& function) {
  return {prose(title_of(function)), function.name, function.kind, output_doc(model, function),
          output_definition(model, function)};
}

PageSection section_with_equations(const Model& model, const Program& program, std::size_t index) {
  const Function& function = program.functions[index];
  const Heading heading = elgen::heading(model, function);
  PageSection result = definition_section(model, function);
  result.definition = heading.definition;
  const FunctionEquations read = equations(model, program, index);
  for (const auto& [name, value] : read.definitions) {
    result.equations.push_back({name, 1, 1, {value}});
  }
  for (std::size_t f = 0; f < function.fields.size(); ++f) {
    const Field& field = function.fields[f];
    const std::string_view latex = field_row(function.kind, field.name).latex;
    const Formula symbol = field.name.empty()
                               ? heading.symbol
                               : symbol_formula(field.name, latex_glyphs(model, latex));
    if (field.name != "multipliers") {
      result.equations.push_back({symbol, field.rows, field.columns, read.entries[f]});
      continue;
    }
    const Formulas symbols = ModelSymbols(model).leaf_symbols().multipliers;
    for (std::uint32_t i = 0; i < field.rows; ++i) {
      result.equations.push_back({symbols[i], 1, 1, {read.entries[f][i]}});
    }
  }
  return result;
}

/// True if a section fills more than about half a page, which is too much to read.
bool fills_page(const PageSection& section) {
  constexpr std::size_t longest = 3000;
  std::size_t letters = 0;
  for (const PageEquation& equation : section.equations) {
    for (const Formula& entry : equation.entries) letters += to_latex(glyphs_of(entry)).size();
  }
  return letters > longest;
}

/// The equations of an output. If the output has a definition, the definition replaces equations
/// that are not readable, and equations that fill a page unless the user asked for this output.
PageSection output_section(const Model& model, const Program& program, std::size_t index,
                           bool is_asked_for) {
  PageSection defined = definition_section(model, program.functions[index]);
  const bool is_defined = !defined.definition.is_empty();
  if (is_defined && !has_readable_form(program, index)) return defined;
  PageSection result = section_with_equations(model, program, index);
  return is_defined && !is_asked_for && fills_page(result) ? defined : result;
}

/// The documentation of an output. If the output depends only on the rates and accelerations of
/// `function.independent`, the text names these velocities.
std::string independent_output_doc(const Model& model, const Function& function) {
  std::vector<std::string> names;
  for (const std::uint32_t i : function.independent) {
    names.push_back(quote_text(model.velocities[i].name));
  }
  const std::string_view doc = output_row(function.kind).doc;
  if (names.empty()) return fmt::format("{}.", doc);
  return fmt::format("{}, from the rates and accelerations of {} alone.", doc,
                     fmt::join(names, ", "));
}

std::string end_sentence(const std::string& text) {
  const bool has_end = !text.empty() && (text.back() == '.' || text.back() == '!');
  return has_end ? text : text + ".";
}

/// The sentence that a step drifts off the constraints or projects back to the constraints; ""
/// without constraints.
std::string step_drift_note(const Model& model, const StepSpec& step) {
  if (model.constraints.empty()) return {};
  return step.projects
             ? " One Newton step back to the constraints follows, as by `projected`."
             : " Called in a loop it drifts off the constraints: call `projected` after every "
               "step, or write `step = { projected = true }`.";
}

}  // namespace

Heading heading(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  Glyphs symbol = latex_glyphs(model, row.symbol.latex);
  Glyphs definition = latex_glyphs(model, equation_of(row, setting_of(model)).latex);
  if (row.is_user_output) {
    ModelSymbols symbols(model);
    Glyphs y;
    for (std::uint32_t i = 0; i <= function.user; ++i) {
      y = symbols.make_distinct(symbol_of_name(model.outputs[i].name));
    }
    symbol = replace_vector(std::move(symbol), "y", y);
    definition = replace_vector(std::move(definition), "y", y);
    definition = replace_vector(std::move(definition), "y''", add_dots(std::move(y), "¨"));
  }
  Heading result{symbol_formula(function.name, std::move(symbol))};
  if (!definition.parts.empty()) result.definition = symbol_formula("", std::move(definition));
  return result;
}

std::string output_doc(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  if (row.is_step) {
    const StepSpec& step = *function.step;
    const std::string method =
        fmt::format(fmt::runtime(step_method_row(step.method).doc), step_order(step));
    return fmt::format("{} {}.{}", row.doc, method, step_drift_note(model, step));
  }
  if (row.options.has(OutputOption::independent)) return independent_output_doc(model, function);
  if (!row.is_user_output) {
    const bool is_without = row.gives_pivots && !has_pivots(function);
    const std::string_view doc = is_without ? row.doc_without_pivots : row.doc;
    const std::string_view constrained =
        is_without ? row.constrained_doc_without_pivots : row.constrained_doc;
    return std::string(model.constraints.empty() || constrained.empty() ? doc : constrained);
  }
  const UserOutput& output = model.outputs[function.user];
  return end_sentence(
      fmt::format("{} `{}`{}{}", row.doc, output.name, output.doc.empty() ? "" : ": ", output.doc));
}

Page model_page(const Model& model, const Scene& scene, const Program& program,
                const PageOptions& options) {
  Page result{prose(page_title(model)), model.description, model.reference};
  result.notes = scene_notes(model, scene);
  result.equation_of_motion = equation_of_motion(model, program);
  const ModelSymbols symbols(model);
  result.coordinates = coordinate_variables(model, symbols.leaf_symbols());
  result.inputs = input_variables(model, symbols.leaf_symbols().u);
  result.functions = function_variables(model, symbols.leaf_symbols().f);
  result.parameters = parameter_variables(model, scene, symbols.parameter_symbols());
  if (options.opening_steps != nullptr) {
    result.sections = derivation_sections(model, *options.opening_steps, equations_title);
  }
  if (!model.constraints.empty()) result.sections.push_back(constraint_section(model));
  bool needs_parts = false;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    const OutputRow& row = output_row(function.kind);
    if (row.is_step) {
      result.sections.push_back(
          {prose(title_of(function)), function.name, function.kind, output_doc(model, function)});
    }
    if (!has_equations(row)) continue;
    if (!options.shows_zeros && is_zero(program, function)) continue;
    if (entry_count(function) <= options.most_entries) {
      const bool is_asked_for = options.most_entries == SIZE_MAX;
      result.sections.push_back(output_section(model, program, i, is_asked_for));
      const bool is_basic = !divides_by_mass(row) && !row.differentiates && !row.is_user_output;
      needs_parts = needs_parts || (is_basic && result.sections.back().equations.empty());
    } else {
      result.sections.push_back(definition_section(model, function));
      result.sections.back().doc += fmt::format(" {} entries.", entry_count(function));
    }
  }
  if (needs_parts && has_frame_recursion(model)) {
    const std::vector<PageSection> parts = recursion_sections(model);
    result.sections.insert(result.sections.begin(), parts.begin(), parts.end());
  }
  PageSection conserved{.title = prose("Conserved"), .doc = "Constant along every motion."};
  for (const ConservedQuantity& quantity : conserved_quantities(model, program)) {
    conserved.lines.push_back(quantity.definition);
  }
  if (!conserved.lines.empty()) result.sections.push_back(std::move(conserved));
  return result;
}

}  // namespace elgen
