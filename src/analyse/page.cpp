// A page of the model language has the parts of a sheet, one line for each entry of a matrix.
#include "analyse/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/leaf_names.hpp"
#include "forms/present/arithmetic.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"
#include "render/headings.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

/// 1.5e-07 -> 1.5 \cdot 10^{-7}
std::string latex_number(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

std::string rows_of(const PageTable& table) {
  const std::size_t columns = table.heads.size();
  std::vector<std::size_t> widths(columns, 0);
  const auto measure = [&](const std::vector<Printed>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i % columns] = std::max(widths[i % columns], cells[i].text.size());
    }
  };
  measure(table.heads);
  measure(table.cells);
  std::string text;
  const auto add_row = [&](const Printed* first) {
    std::string line;
    for (std::size_t i = 0; i < columns; ++i) {
      line += fmt::format("{:<{}}   ", first[i].text, widths[i]);
    }
    text += fmt::format("  {}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  };
  const bool has_heads =
      std::ranges::any_of(table.heads, [](const Printed& head) { return !head.text.empty(); });
  if (has_heads) add_row(table.heads.data());
  for (std::size_t i = 0; i < table.cells.size(); i += columns) add_row(&table.cells[i]);
  return text;
}

std::string text_of(const PageMatrix& matrix) {
  if (matrix.entries.size() == 1) {
    return fmt::format("  {} = {}\n", matrix.left.text, matrix.entries[0].text);
  }
  std::string text;
  for (std::uint32_t i = 0; i < matrix.entries.size(); ++i) {
    text += fmt::format("  {}[{}][{}] = {}\n", matrix.left.text, i / matrix.columns + 1,
                        i % matrix.columns + 1, matrix.entries[i].text);
  }
  return text;
}

std::vector<std::string> latex_of(const std::vector<Printed>& formulas) {
  std::vector<std::string> result;
  for (const Printed& formula : formulas) result.push_back(formula.latex);
  return result;
}

/// " N m s", " N s": that of a force, times s.
Printed unit_of_momentum(const Parameter& momentum) {
  if (!momentum.unit) return {};
  std::string text = force_unit_text(*momentum.unit / *find_unit("s")) + " s";
  if (text.find('/') != std::string::npos) text = to_string(*momentum.unit);
  std::ranges::replace(text, '*', ' ');
  return {" " + text, fmt::format("\\text{{ {}}}", text)};
}

}  // namespace

Printed prose(const std::string& text) {
  if (text.empty()) return {};
  return {text, fmt::format("\\text{{{} }}", text)};
}

Printed operator+(const Printed& left, const Printed& right) {
  if (left.text.empty()) return right;
  if (right.text.empty()) return left;
  return {left.text + " " + right.text, left.latex + " " + right.latex};
}

Printed with_commas(const std::vector<Printed>& items) {
  Printed result;
  for (const Printed& item : items) {
    const char* const comma = result.text.empty() ? "" : ", ";
    result = {result.text + comma + item.text, result.latex + comma + item.latex};
  }
  return result;
}

Printed equation(const Printed& name, const Printed& value) {
  return {name.text + " = " + value.text, name.latex + " = " + value.latex};
}

Printed listed(const std::vector<Printed>& items) {
  if (items.size() < 2) return with_commas(items);
  return with_commas({items.begin(), items.end() - 1}) + prose("and") + items.back();
}

Printed number(const cln::cl_R& value) {
  // Newton's method ends at 58 digits of the largest coordinate.
  static const cln::cl_R noise = power_of_ten(-40);
  const std::string text = cln::abs(value) < noise ? "0" : short_text(value);
  return {text, latex_number(text)};
}

Printed number(double value) {
  const std::string text = value == 0 ? "0" : fmt::format("{:.6g}", value);
  return {text, latex_number(text)};
}

LeafValues<Printed> symbols_of(const Model& model) {
  const LeafNames names = leaf_names(model);
  return map_leaves(
      [](const std::string& text, const std::string& latex) {
        return Printed{text, latex};
      },
      static_cast<const LeafValues<std::string>&>(names), ModelSymbols(model).leaves());
}

Printed titled(const CheckedModel& checked, const std::string& subject) {
  const Model& model = checked.model;
  const std::string title = page_title(model);
  if (!has_routhian(model)) return prose(fmt::format("{}: {}", title, subject));
  const LeafValues<Printed> symbols = symbols_of(model);
  const State nominal = nominal_state(model, checked.scene);
  std::vector<Printed> momenta;
  for (const Cyclic& cyclic : model.variant.cyclic) {
    const Printed value = number(nominal.parameters[cyclic.parameter]);
    const Printed unit = unit_of_momentum(model.parameters[cyclic.parameter]);
    momenta.push_back(equation(symbols.parameters[cyclic.parameter],
                               {value.text + unit.text, value.latex + unit.latex}));
  }
  const Printed held = with_commas(momenta);
  const Printed rest{": " + subject, prose(": " + subject).latex};
  return prose(title + ",") + Printed{held.text + rest.text, held.latex + rest.latex};
}

bool is_mirrored(ClosedForms& forms, const RestPoint& here, const RestPoint& next) {
  if (here.stability.kind != next.stability.kind) return false;
  bool differs = false;
  Arithmetic arithmetic(forms.algebra);
  for (std::size_t k = 0; k < here.coordinates.size(); ++k) {
    const CoordinateAtRest& x = here.coordinates[k];
    const CoordinateAtRest& y = next.coordinates[k];
    if (x.is_any && y.is_any) continue;
    if (!x.form || !y.form) return false;
    if (proved_equal(forms, *x.form, *y.form)) continue;
    const Value turned = arithmetic.negate(*y.form);
    if (!x.sinusoid || !proved_equal(forms, *x.form, *turned)) return false;
    differs = true;
  }
  return differs;
}

Sheet sheet_of(const AnalysisPage& page) {
  Sheet sheet{.title = page.title.text, .title_latex = page.title.latex};
  for (const PagePart& part : page.parts) {
    SheetOutput& output = sheet.outputs.emplace_back();
    output.title = part.title;
    output.doc = part.doc;
    output.lines = latex_of(part.lines);
    for (const PageMatrix& matrix : part.matrices) {
      output.equations.push_back(
          {matrix.left.latex, matrix.rows, matrix.columns, latex_of(matrix.entries)});
    }
    output.is_row = part.is_row;
    output.table = {latex_of(part.table.heads), latex_of(part.table.cells)};
  }
  return sheet;
}

std::string text_of(const AnalysisPage& page) {
  std::string text = page.title.text + "\n";
  for (const PagePart& part : page.parts) {
    text += "\n";
    if (!part.title.empty()) text += part.title + "\n";
    if (!part.doc.empty()) text += fmt::format("  {}\n", part.doc);
    for (const Printed& line : part.lines) text += fmt::format("  {}\n", line.text);
    for (const PageMatrix& matrix : part.matrices) text += text_of(matrix);
    if (!part.table.heads.empty()) text += rows_of(part.table);
  }
  return text;
}

}  // namespace elgen
