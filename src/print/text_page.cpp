// text_page: equations in the model language, one line per entry, and the cost of each form of a
// function.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text_table.hpp"
#include "elgen/page.hpp"
#include "elgen/scalars.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"
#include "program/network/instructions.hpp"

namespace elgen {
namespace {

/// Joins functions into one, so that common subexpressions are computed once. Fields keep the order
/// of the functions. If a name that starts with intermediate_mark is already in use, the name of
/// the function is inserted after the mark.
Function join_functions(const Program& program, const std::vector<std::size_t>& functions) {
  Function all;
  InstructionBuilder instructions(all);
  for (const std::size_t index : functions) {
    Function each = program.functions[index];
    const std::set<std::string> known(all.names.begin(), all.names.end());
    for (std::string& name : each.names) {
      if (name.starts_with(intermediate_mark) && known.contains(name))
        name.insert(1, each.name + "_");
    }
    const std::vector<std::uint32_t> places = instructions.add_all(each);
    for (Field field : each.fields) {
      for (std::uint32_t& entry : field.entries) entry = places[entry];
      all.fields.push_back(std::move(field));
    }
  }
  return all;
}

std::string function_text(const Function& function, std::vector<Formulas>::const_iterator entries) {
  std::string text;
  for (const Field& field : function.fields) {
    const std::string& name = field.name.empty() ? function.name : field.name;
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
      text += fmt::format("  {}{} = {}\n", name, index_text(field, i), text_of((*entries)[i]));
    }
    ++entries;
  }
  return text;
}

std::string definitions_text(const FunctionEquations& equations) {
  std::string text;
  for (const auto& [name, value] : equations.definitions) {
    text += fmt::format("  {} = {}\n", text_of(name), text_of(value));
  }
  return text;
}

/// An equation. If `is_tuple`, all entries are on one line: "(x, y)"; else one line per entry.
std::string equation_text(const PageEquation& equation, bool is_tuple) {
  const std::string left = text_of(equation.left);
  if (equation.entries.size() == 1) {
    return fmt::format("  {}{} = {}\n", equation.is_definition ? "where " : "", left,
                       text_of(equation.entries[0]));
  }
  if (is_tuple) return fmt::format("  {} = {}\n", left, text_of(tuple_of(equation.entries)));
  std::string text;
  for (std::uint32_t i = 0; i < equation.entries.size(); ++i) {
    text += fmt::format("  {}[{}][{}] = {}\n", left, i / equation.columns + 1,
                        i % equation.columns + 1, text_of(equation.entries[i]));
  }
  return text;
}

/// A table, without a line of heads if all heads are empty.
std::string table_text(const PageTable& table) {
  const auto columns = static_cast<std::ptrdiff_t>(table.heads.size());
  std::vector<std::string> cells = texts_of(table.heads);
  if (std::ranges::all_of(table.heads, &Formula::is_empty)) cells.clear();
  for (const Formula& cell : table.cells) cells.push_back(text_of(cell));
  TextRows rows;
  for (auto first = cells.begin(); first != cells.end(); first += columns) {
    rows.emplace_back(first, first + columns);
  }
  std::string text;
  for (const std::string& line : table_lines(rows, {{}, {false, 0, 3}})) text += line + "\n";
  return text;
}

/// True if a page shows the equations of a function.
bool is_shown(const Program& program, const Function& function, const PageOptions& options) {
  return has_equations(output_row(function.kind)) &&
         (options.shows_zeros || !is_zero(program, function));
}

/// The digits that `loss` costs a double: "3.1"; "0" if no digit is lost, "all" if no digit
/// remains, "" if the loss is unknown.
std::string lost_digits_text(const std::optional<double>& loss) {
  if (!loss) return {};
  const double digits = digits_lost(*loss, ScalarKind::double_precision);
  if (digits >= decimal_digits(ScalarKind::double_precision)) return "all";
  return digits > 0 ? fmt::format("{:.1f}", digits) : "0";
}

}  // namespace

std::string text_of(const std::vector<PageSection>& sections) {
  std::string text;
  for (const PageSection& section : sections) {
    text += "\n";
    if (!section.title.is_empty()) text += text_of(section.title) + "\n";
    if (!section.doc.empty()) text += fmt::format("  {}\n", section.doc);
    for (const Formula& line : section.lines) text += fmt::format("  {}\n", text_of(line));
    for (const PageEquation& equation : section.equations) {
      text += equation_text(equation, section.is_aligned);
    }
    text += table_text(section.table);
  }
  return text;
}

std::string text_of(const Page& page) {
  return text_of(page.title) + "\n" + text_of(page.sections);
}

std::string text_page(const Model& model, const Scene& scene, const Program& program,
                      const PageOptions& options) {
  std::string text = page_title(model) + "\n";
  for (const std::string& note : scene_notes(model, scene)) text += note + "\n";
  text += fmt::format("\n  {}\n\n", text_of(equation_of_motion(model, program)));
  for (const std::string& line : variable_lines(model, program)) text += "  " + line + "\n";
  if (!model.constraints.empty()) text += "\nconstraints\n";
  for (const std::string& line : constraint_lines(model)) text += "  " + line + "\n";
  if (options.opening_steps != nullptr) {
    text += text_of(derivation_sections(model, *options.opening_steps, equations_title));
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const bool is_closed = has_readable_form(program, i);
    if (!is_closed && is_shown(program, program.functions[i], options)) open.push_back(i);
  }
  const Function all = join_functions(program, open);
  const FunctionEquations parts =
      function_equations(program, all, temporary_names(program, all, FallbackName::number));
  if (!parts.definitions.empty()) text += "\nnamed parts\n";
  text += definitions_text(parts);
  std::vector<Formulas>::const_iterator next = parts.entries.begin();
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    const bool is_step = output_row(function.kind).is_step;
    if (is_step) text += fmt::format("\n{}\n  {}\n", function.name, output_doc(model, function));
    if (!is_shown(program, function, options)) continue;
    text += fmt::format("\n{}\n", function.name);
    if (has_readable_form(program, i)) {
      const FunctionEquations read = equations(program, i);
      text += definitions_text(read);
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

std::string cost_page(const std::vector<FormCosts>& costs) {
  TextRows rows{
      {"function", "form", "add", "mul", "div", "sqrt", "sincos", "other", "cost", "digits", ""}};
  const auto add = [&](const FormCosts& of, Form form, const OperationCounts& n,
                       const std::optional<double>& loss) {
    std::string mark = form != of.chosen_form ? "" : of.is_demanded ? "requested" : "emitted";
    if (form == Form::closed && of.inaccurate_entry) {
      mark +=
          fmt::format("{}inaccurate in entry {}", mark.empty() ? "" : ", ", *of.inaccurate_entry);
    }
    if (form == of.chosen_form && of.limited_entry) {
      mark += fmt::format(", limit of rewritings in entry {}", *of.limited_entry);
    }
    std::vector<std::string>& row = rows.emplace_back();
    row = {of.function, std::string(name_of(form))};
    for (const std::size_t count : {n.add, n.mul, n.div, n.sqrt, n.sincos, n.other, cost(n)}) {
      row.push_back(std::to_string(count));
    }
    row.insert(row.end(), {lost_digits_text(loss), mark});
  };
  for (const FormCosts& function : costs) {
    if (function.closed) add(function, Form::closed, *function.closed, function.closed_loss);
    add(function, Form::recursive, function.recursive, function.recursive_loss);
  }
  std::string text;
  const std::vector<TextColumn> columns{{false, 0, 0},
                                        {false, 9, 2},
                                        {true, 6, 2},
                                        {true, 6, 1},
                                        {true, 5, 1},
                                        {true, 5, 1},
                                        {true, 6, 1},
                                        {true, 5, 1},
                                        {true, 6, 2},
                                        {true, 6, 2},
                                        {}};
  for (const std::string& line : table_lines(rows, columns)) text += line + "\n";
  return text;
}

}  // namespace elgen
