// text_page: equations in the model language, one entry a line, and what either form of a function
// costs.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "elgen/render.hpp"
#include "elgen/scalars.hpp"
#include "program/network/instructions.hpp"
#include "render/constraints.hpp"
#include "render/headings.hpp"
#include "render/named_parts.hpp"

namespace elgen {
namespace {

using FieldTexts = std::vector<std::vector<std::string>>;

/// Functions as one: what they compute alike is computed once. Their fields follow one another.
/// Names that another function tells too have that of their function before them.
Function united(const Program& program, const std::vector<std::size_t>& functions) {
  Function all;
  Instructions instructions(all);
  for (const std::size_t index : functions) {
    Function each = program.functions[index];
    const std::set<std::string> known(all.names.begin(), all.names.end());
    for (std::string& name : each.names) {
      if (name.starts_with(told_mark) && known.contains(name)) name.insert(1, each.name + "_");
    }
    const std::vector<std::uint32_t> places = instructions.add_all(each);
    for (Field field : each.fields) {
      for (std::uint32_t& entry : field.entries) entry = places[entry];
      all.fields.push_back(std::move(field));
    }
  }
  return all;
}

std::string function_text(const Function& function, FieldTexts::const_iterator entries) {
  std::string text;
  for (const Field& field : function.fields) {
    const std::string& name = field.name.empty() ? function.name : field.name;
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      text += fmt::format("  {}{} = {}\n", name, index_text(field, i), (*entries)[i]);
    }
    ++entries;
  }
  return text;
}

/// Whether a page shows the equations of a function.
bool is_shown(const Program& program, const Function& function, const PageOptions& options) {
  return has_equations(output_row(function.kind)) && (options.zeros || !is_zero(program, function));
}

}  // namespace

std::string text_page(const Model& model, const Scene& scene, const Program& program,
                      const PageOptions& options) {
  std::string text = page_title(model) + "\n";
  for (const std::string& note : scene_notes(model, scene)) text += note + "\n";
  text += fmt::format("\n  {}\n\n", equation_of_motion(model, program).text);
  for (const std::string& line : variable_lines(model, program)) text += "  " + line + "\n";
  if (!model.constraints.empty()) text += "\nconstraints\n";
  for (const std::string& line : constraint_lines(model)) text += "  " + line + "\n";
  if (options.opening != nullptr) {
    text += "\n" + steps_text(model, *options.opening, equations_title);
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const bool is_closed = has_readable_form(program, i);
    if (!is_closed && is_shown(program, program.functions[i], options)) open.push_back(i);
  }
  const Function all = united(program, open);
  const FunctionEquations parts =
      equations(program, all, temporary_names(program, all, LastName::number));
  if (!parts.definitions.empty()) text += "\nnamed parts\n";
  for (const EquationLine& line : parts.definitions) {
    text += fmt::format("  {} = {}\n", line.name, line.value);
  }
  FieldTexts::const_iterator next = parts.entries.begin();
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    const bool is_step = output_row(function.kind).steps;
    if (is_step) text += fmt::format("\n{}\n  {}\n", function.name, output_doc(model, function));
    if (!is_shown(program, function, options)) continue;
    text += fmt::format("\n{}\n", function.name);
    if (has_readable_form(program, i)) {
      const FunctionEquations read = readable_equations(program, i);
      for (const EquationLine& line : read.definitions) {
        text += fmt::format("  {} = {}\n", line.name, line.value);
      }
      text += function_text(function, read.entries.begin());
    } else {
      text += function_text(function, next);
      next += static_cast<std::ptrdiff_t>(function.fields.size());
    }
  }
  std::string conserved;
  for (const ConservedQuantity& quantity : conserved_quantities(model, program)) {
    conserved += (conserved.empty() ? "" : ", ") + quantity.name;
  }
  if (!conserved.empty()) text += fmt::format("\nconserved: {}\n", conserved);
  return text;
}

namespace {

/// "3.1", of 16 digits at most; "0" where nothing is lost, nothing where it was not asked.
std::string digits_text(const std::optional<double>& loss) {
  if (!loss) return {};
  const double digits = digits_lost(*loss, ScalarKind::double_precision);
  if (digits >= decimal_digits(ScalarKind::double_precision)) return "all";
  return digits > 0 ? fmt::format("{:.1f}", digits) : "0";
}

}  // namespace

std::string cost_page(const std::vector<FormCosts>& costs) {
  std::size_t width = std::string_view("function").size();
  for (const FormCosts& row : costs) width = std::max(width, row.function.size());
  constexpr std::string_view row =
      "{:<{}}  {:<9}  {:>6} {:>6} {:>5} {:>5} {:>6} {:>5}  {:>6}  {:>6}  {}";
  std::string text;
  const auto add_line = [&text](const std::string& line) {
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  add_line(fmt::format(row, "function", width, "form", "add", "mul", "div", "sqrt", "sincos",
                       "other", "cost", "digits", ""));
  const auto add = [&](const FormCosts& of, Form form, const OperationCounts& n,
                       const std::optional<double>& loss) {
    std::string mark = form != of.chosen ? "" : of.is_asked_for ? "asked for" : "emitted";
    if (form == Form::closed && of.inaccurate) {
      mark += fmt::format("{}harms entry {}", mark.empty() ? "" : ", ", *of.inaccurate);
    }
    add_line(fmt::format(row, of.function, width, name_of(form), n.add, n.mul, n.div, n.sqrt,
                         n.sincos, n.other, cost(n), digits_text(loss), mark));
  };
  for (const FormCosts& function : costs) {
    if (function.closed) add(function, Form::closed, *function.closed, function.closed_loss);
    add(function, Form::recursive, function.recursive, function.recursive_loss);
  }
  return text;
}

}  // namespace elgen
