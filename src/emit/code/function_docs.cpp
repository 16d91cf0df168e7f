// function_docs: a sentence, the equation, then the entries. The entries form a matrix if its rows
// fit the width; otherwise each line has one entry. If the entries need more than
// `longest_listing` lines, a note refers to the sidecar.
#include "emit/code/function_docs.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "elgen/spellings.hpp"
#include "elgen/step_methods.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/layout.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t longest_listing = 60;
constexpr std::size_t longest_units =
    60;  // characters; the units share a line with the field's name
constexpr std::size_t listing_width = 88;  // columns of a line without `///` and indentation

/// "2 x 2, row-major", "2 entries", "Scalar"; in interpreted languages "2 x 2", "2 entries", "A
/// number".
std::string shape_text(const Field& field, const Emission& emission) {
  const bool is_interpreted = language_row(emission.language).is_interpreted;
  if (field.columns > 1) {
    return fmt::format("{} x {}{}{}", field.rows, field.columns, is_interpreted ? "" : ", ",
                       is_interpreted ? "" : name_of(emission.storage));
  }
  if (field.rows > 1) return fmt::format("{} entries", field.rows);
  return is_interpreted ? "A number" : "Scalar";
}

/// "y = y(q, v, a)": the arguments are q and the leaves in `output.argument_kinds`.
std::string user_output_equation(const OutputRow& row, const UserOutput& output) {
  std::string arguments = "q";
  for (const LeafRow& leaf : leaf_table()) {
    if (output.argument_kinds.has_any(leaf.id)) arguments += fmt::format(", {}", leaf.symbol);
  }
  return fmt::format("{0} = {0}({1})", row.symbol.text, arguments);
}

std::string equation_text(const Function& function, const Model& model) {
  const OutputRow& row = output_row(function.kind);
  if (is_user_value(row)) {
    return user_output_equation(row, model.outputs[function.user]);
  }
  const std::string_view equation = equation_of(row, setting_of(model)).text;
  const bool is_whole = equation.find(" = ") != std::string_view::npos;
  if (is_whole || equation == row.symbol.text) return std::string(equation);
  return fmt::format("{} = {}", row.symbol.text, equation);
}

/// The entries as rows with aligned columns; empty if a row would be too long.
Lines matrix_lines(const Field& field, const std::vector<std::string>& entries) {
  std::vector<std::size_t> widths(field.columns, 0);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::size_t& width = widths[i % field.columns];
    width = std::max(width, entries[i].size());
  }
  Lines lines;
  for (std::size_t row = 0; row < field.rows; ++row) {
    std::string line = "[ ";
    for (std::size_t column = 0; column < field.columns; ++column) {
      const bool is_last = column + 1 == field.columns;
      const std::string entry = entries[row * field.columns + column] + (is_last ? "" : ",");
      line += fmt::format("{:<{}}", entry, widths[column] + (is_last ? 0 : 2));
    }
    lines.push_back(line + " ]");
    if (lines.back().size() > listing_width) return {};
  }
  return lines;
}

void append(Lines& to, const Lines& from) { to.insert(to.end(), from.begin(), from.end()); }

Lines wrap_line(const std::string& line) { return wrap_expression(line, {listing_width, "    "}); }

/// "[0, 1] = l*m*cos(theta)"
Lines indexed_lines(const Field& field, const std::vector<std::string>& entries,
                    std::size_t first) {
  Lines lines;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string index = field.columns > 1 ? fmt::format("[{}, {}]", first + i / field.columns,
                                                              first + i % field.columns)
                                                : fmt::format("[{}]", first + i);
    append(lines, wrap_line(fmt::format("{} = {}", index, entries[i])));
  }
  return lines;
}

Lines entry_list_lines(const Field& field, const std::vector<std::string>& entries,
                       std::size_t first) {
  if (entries.size() == 1) return wrap_line("= " + entries.front());
  const Lines matrix = matrix_lines(field, entries);
  return matrix.empty() ? indexed_lines(field, entries, first) : matrix;
}

Lines equation_lines(const FunctionDocsInput& text) {
  const LanguageId language = text.emission.language;
  const std::size_t first =
      language_row(language).is_interpreted ? source_spelling(language).first_index : 0;
  Lines lines;
  for (const auto& [name, value] : text.equations.definitions) {
    append(lines, wrap_line(text_of(name) + " = " + text_of(value)));
    if (lines.size() > longest_listing) return lines;
  }
  if (!lines.empty()) lines.emplace_back();
  for (std::size_t i = 0; i < text.function.fields.size(); ++i) {
    const Field& field = text.function.fields[i];
    if (!field.name.empty()) lines.push_back(field.name + ":");
    append(lines, entry_list_lines(field, texts_of(text.equations.entries[i]), first));
  }
  return lines;
}

/// "q1, q2": names_without_leaf() of the rows; "" if the list is too long to help.
std::string row_names_text(const Model& model, OutputKind kind, const Field& field) {
  const Extent rows = field_row(kind, field.name).rows;
  const std::string list = fmt::format("{}", fmt::join(names_without_leaf(model, rows), ", "));
  return list.size() <= longest_units ? list : "";
}

std::string sidecar_note(const FunctionDocsInput& text) {
  return fmt::format("{} definitions and {} entries: see {}.", text.equations.definitions.size(),
                     entry_count(text.function), text.sidecar);
}

Lines step_lines(const StepSpec& step, const Model& model) {
  const auto equation = fmt::runtime(step_method_row(step.method).equation);
  std::istringstream text(fmt::format(equation, step.iterations));
  Lines lines;
  for (std::string line; std::getline(text, line);) append(lines, wrap_line(line));
  if (step.projects) {
    const OutputRow& projected = output_row(OutputKind::projected);
    append(lines, wrap_line(fmt::format("then, at t + h, {}",
                                        equation_of(projected, setting_of(model)).text)));
  }
  if (step.composed_order == 0) return lines;
  std::vector<std::string> parts;
  for (const cln::cl_RA& part : composition_coefficients(step.composed_order)) {
    parts.push_back(fmt::format("{:.6g} h", cln::double_approx(part)));
  }
  const char* const residual =
      step.iterations > 0 ? "; `residual` belongs to the longest of them" : "";
  append(lines, wrap_line(fmt::format("in sequence over {}{}", fmt::join(parts, ", "), residual)));
  return lines;
}

Lines equation_docs(const FunctionDocsInput& text) {
  const OutputRow& row = output_row(text.function.kind);
  if (row.is_summary) return {};
  if (row.is_step) return step_lines(*text.function.step, text.model);
  const Lines all = equation_lines(text);
  Lines lines = {equation_text(text.function, text.model), ""};
  append(lines, all.size() > longest_listing ? Lines{sidecar_note(text)} : all);
  return lines;
}

/// A sentence about Scalar if the function compares numbers and the caller chooses the scalar type;
/// otherwise "".
std::string ordering_note(const FunctionDocsInput& text) {
  if (language_row(text.emission.language).scalars == LanguageScalars::one) return "";
  const auto& all = text.function.instructions;
  const bool has_kinks = std::any_of(all.begin(), all.end(), [](const Instruction& i) {
    return i.opcode == Opcode::call && is_kinked(i.function);
  });
  return has_kinks || needs_ordered_scalar(text.function)
             ? " Needs an ordered Scalar, or a pack of ordered numbers."
             : "";
}

}  // namespace

std::string units_text(const Model& model, OutputKind kind, const Field& field) {
  std::string list;
  std::set<std::string> different;
  for (std::size_t i = 0; i < field.rows; ++i) {
    for (std::size_t j = 0; j < field.columns; ++j) {
      const std::string text = unit_text_of_entry(model, {kind, field.name, i, j});
      if (text.empty()) return "";
      different.insert(text);
      if (i + j > 0) list += j == 0 && field.columns > 1 ? "; " : ", ";
      list += text;
    }
  }
  if (different.size() == 1) return *different.begin();
  return list.size() <= longest_units ? list : "";
}

std::string field_summary(const FunctionDocsInput& text, const Field& field) {
  const OutputKind kind = kind_of_field(text.program, text.function, field);
  const std::string units = units_text(text.model, kind, field);
  const std::string rows = row_names_text(text.model, kind, field);
  return shape_text(field, text.emission) + (units.empty() ? "" : " [" + units + "]") +
         (rows.empty() ? "" : ", of " + rows);
}

std::string function_heading(const FunctionDocsInput& text) {
  const std::string doc = comment_text(output_doc(text.model, text.function));
  if (returns_struct(text.function)) return doc;
  return doc + " " + field_summary(text, text.function.fields.front()) + ".";
}

std::vector<std::string> function_docs(const FunctionDocsInput& text) {
  Lines lines;
  const std::string heading = function_heading(text) + ordering_note(text);
  for (const std::string& line : wrap_words(heading, {line_width - 4, ""})) {
    lines.push_back(" " + line);
  }
  const Lines equations = equation_docs(text);
  if (!equations.empty()) lines.emplace_back();
  for (const std::string& line : equations) lines.push_back(line.empty() ? "" : "     " + line);
  return lines;
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
