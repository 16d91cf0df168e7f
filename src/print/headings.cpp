// headings: symbols and equations of the output table, in the model's own symbols.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/step_methods.hpp"
#include "model/symbols.hpp"
#include "print/sections.hpp"

namespace elgen {
namespace {

std::string sentence(const std::string& text) {
  const bool has_end = !text.empty() && (text.back() == '.' || text.back() == '!');
  return has_end ? text : text + ".";
}

}  // namespace

Heading heading(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  Glyphs symbol = typed_glyphs(model, row.symbol.latex);
  Glyphs definition = typed_glyphs(model, equation_of(row, setting_of(model)).latex);
  if (row.of_user) {
    ModelSymbols symbols(model);
    Glyphs y;
    for (std::uint32_t i = 0; i <= function.user; ++i) {
      y = symbols.distinct(symbol_of_name(model.outputs[i].name));
    }
    symbol = replaced(std::move(symbol), "y", y);
    definition = replaced(std::move(definition), "y", y);
    definition = replaced(std::move(definition), "y''", accented(std::move(y), "¨"));
  }
  Heading result{symbol_formula(function.name, std::move(symbol))};
  if (!definition.parts.empty()) result.definition = symbol_formula("", std::move(definition));
  return result;
}

Formula field_symbol(const Model& model, OutputKind kind, const Field& field) {
  return symbol_formula(field.name, typed_glyphs(model, field_row(kind, field.name).latex));
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
