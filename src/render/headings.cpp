// headings: symbols and equations of the output table, in LaTeX and in the model's own symbols.
#include "render/headings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "elgen/step_methods.hpp"
#include "render/latex.hpp"
#include "render/symbols.hpp"

namespace elgen {
namespace {

std::string sentence(const std::string& text) {
  const bool has_end = !text.empty() && (text.back() == '.' || text.back() == '!');
  return has_end ? text : text + ".";
}

}  // namespace

std::string as_title(std::string name) {
  std::ranges::replace(name, '_', ' ');
  if (!name.empty()) name[0] = in_upper_case(name[0]);
  return name;
}

std::string page_title(const Model& model) {
  return model.title.empty() ? as_title(model.name) : model.title;
}

std::string latex_of(const Model& model, std::string_view latex) {
  const bool turns = !model.rotations.empty();
  std::string text = replaced(std::string(latex), "<N>", turns ? " N" : "");
  if (!turns) text = replaced(replaced(text, "<v>", "\\dot{<q>}"), "<a>", "\\ddot{<q>}");
  for (std::size_t open = text.find('<'); open != std::string::npos; open = text.find('<')) {
    const std::size_t close = text.find('>', open);
    const std::string name = text.substr(open + 1, close - open - 1);
    const bool is_greek = !greek_letter(name).empty();
    text.replace(
        open, close + 1 - open,
        is_greek ? fmt::format("\\boldsymbol{{\\{}}}", name) : fmt::format("\\mathbf{{{}}}", name));
  }
  return text;
}

Heading heading(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  Heading result{std::string(row.symbol.latex),
                 std::string(equation_of(row, setting_of(model)).latex)};
  if (row.of_user) {
    ModelSymbols symbols(model);
    SymbolText y;
    for (std::uint32_t i = 0; i <= function.user; ++i) {
      y = symbols.distinct(latex_symbol(model.outputs[i].name));
    }
    const std::string second = fmt::format("\\ddot{{{}}}{}", y.base, y.scripts);
    result.symbol = replaced(result.symbol, "<y>", y.text());
    result.definition = replaced(replaced(result.definition, "<y>", y.text()), "<y''>", second);
  }
  return {latex_of(model, result.symbol), latex_of(model, result.definition)};
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
  if (!row.of_user) {
    const bool is_without = row.gives_pivots && !has_pivots(function);
    const std::string_view doc = is_without ? row.doc_without_pivots : row.doc;
    const std::string_view constrained =
        is_without ? row.constrained_doc_without_pivots : row.constrained_doc;
    return std::string(model.constraints.empty() || constrained.empty() ? doc : constrained);
  }
  const UserOutput& output = model.outputs[function.user];
  return sentence(
      fmt::format("{} `{}`{}{}", row.doc, output.name, output.doc.empty() ? "" : ": ", output.doc));
}

}  // namespace elgen
