// headings: symbols and equations of the output table, in LaTeX and in the model's own symbols.
#include "render/headings.hpp"

#include <fmt/format.h>

#include "elgen/step_methods.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

std::string replaced(std::string text, std::string_view from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

std::string sentence(const std::string& text) {
  const bool has_end = !text.empty() && (text.back() == '.' || text.back() == '!');
  return has_end ? text : text + ".";
}

}  // namespace

std::string latex_of(const Model& model, std::string_view latex) {
  const bool turns = !model.rotations.empty();
  std::string text = replaced(std::string(latex), "<v>", turns ? "v" : "\\dot{q}");
  text = replaced(text, "<a>", turns ? "a" : "\\ddot{q}");
  return replaced(text, "<N>", turns ? " N" : "");
}

Heading heading(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  const Notation& equation = equation_of(row, !model.rotations.empty());
  Heading result{latex_of(model, row.symbol.latex), latex_of(model, equation.latex)};
  if (!row.of_user) return result;
  ModelSymbols symbols(model);
  SymbolText y;
  for (std::uint32_t i = 0; i <= function.user; ++i) {
    y = symbols.distinct(latex_symbol(model.outputs[i].name));
  }
  result.symbol = replaced(result.symbol, "<y>", y.text());
  result.definition = replaced(result.definition, "<y>", y.text());
  const std::string second = fmt::format("\\ddot{{{}}}{}", y.base, y.scripts);
  result.definition = replaced(result.definition, "<y''>", second);
  return result;
}

std::string field_symbol(const Model& model, OutputKind kind, const Field& field) {
  return latex_of(model, field_row(kind, field.name).latex);
}

std::string output_doc(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  if (row.steps) {
    const StepMethodRow& method = step_methods[function.user];
    const bool is_composed = function.composed_order > 0;
    return fmt::format("{} {}.", row.doc,
                       fmt::format(fmt::runtime(method.doc),
                                   is_composed ? function.composed_order : method.order));
  }
  if (!row.of_user) return std::string(row.doc);
  const UserOutput& output = model.outputs[function.user];
  return sentence(
      fmt::format("{} `{}`{}{}", row.doc, output.name, output.doc.empty() ? "" : ": ", output.doc));
}

}  // namespace elgen
