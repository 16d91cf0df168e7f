// markdown_page: a Sheet as GitHub Markdown, formulas in blocks of $$.
#include <fmt/format.h>

#include "elgen/render.hpp"
#include "render/display.hpp"

namespace elgen {
namespace {

/// One line, without what Markdown would read as markup.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("|<*_\\$`").find(c) != std::string_view::npos) result += '\\';
    result += c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  }
  return result;
}

std::string block(const std::string& latex) { return fmt::format("$$\n{}\n$$\n\n", latex); }

std::string table(const std::string& title, const std::vector<SheetVariable>& variables,
                  bool have_values) {
  if (variables.empty()) return {};
  std::string text = have_values ? "| {} | | value | unit | |\n|---|---|---|---|---|\n"
                                 : "| {} | | unit | |\n|---|---|---|---|\n";
  text = fmt::format(fmt::runtime(text), title);
  for (const SheetVariable& v : variables) {
    const std::string value = have_values ? fmt::format(" {} |", plain(v.value)) : "";
    text += fmt::format("| ${}$ | `{}` |{} {} | {} |\n", v.symbol, v.name, value, plain(v.unit),
                        plain(v.doc));
  }
  return text + "\n";
}

std::string section(const SheetOutput& output) {
  std::string text = fmt::format("## {}\n\n", output.name);
  if (!output.doc.empty()) text += plain(output.doc) + "\n\n";
  if (!output.definition.empty()) text += block(output.definition);
  for (const SheetEquation& equation : output.equations) {
    for (const Display& display : displays(equation)) {
      text += block(latex_block(display));
    }
  }
  return text;
}

}  // namespace

std::string markdown_page(const Sheet& sheet) {
  std::string text = fmt::format("# {}\n\n", plain(sheet.title));
  if (!sheet.description.empty()) text += plain(sheet.description) + "\n\n";
  if (!sheet.reference.empty()) text += fmt::format("Reference: {}\n\n", plain(sheet.reference));
  for (const std::string& note : sheet.notes) text += plain(note) + "\n\n";
  text += block(sheet.equation_of_motion);
  text += table("coordinate", sheet.coordinates, false);
  text += table("input", sheet.inputs, false);
  text += table("parameter", sheet.parameters, true);
  for (const SheetOutput& output : sheet.outputs) text += section(output);
  while (text.size() > 1 && text.substr(text.size() - 2) == "\n\n") text.pop_back();
  return text;
}

}  // namespace elgen
