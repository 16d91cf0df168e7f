// html_page: a Sheet as one page of HTML with MathML Core, translated from the LaTeX.
#include <fmt/format.h>

#include "elgen/render.hpp"
#include "render/display.hpp"
#include "render/latex_tree.hpp"

namespace elgen {
namespace {

std::string formula(const std::string& latex) {
  return fmt::format("<mrow>{}</mrow>", mathml(read_latex(latex)));
}

std::string cell(const std::string& content) { return fmt::format("<mtd>{}</mtd>", content); }

/// Rows of `columns` entries in tall brackets.
std::string matrix(const Display& display) {
  std::string rows;
  for (std::size_t i = 0; i < display.texts.size(); ++i) {
    if (i % display.columns == 0) rows += "<mtr>";
    rows += cell(formula(display.texts[i]));
    if ((i + 1) % display.columns == 0) rows += "</mtr>\n";
  }
  return fmt::format("<mrow>{}<mo>=</mo><mo>(</mo><mtable>\n{}</mtable><mo>)</mo></mrow>",
                     formula(display.left), rows);
}

/// One line, or lines that continue each other to the right of the sign.
std::string lines(const Display& display) {
  const std::string start = formula(display.left) + "<mo>=</mo>";
  if (display.texts.size() == 1) {
    return fmt::format("<mrow>{}{}</mrow>", start, formula(display.texts.front()));
  }
  std::string rows;
  for (std::size_t i = 0; i < display.texts.size(); ++i) {
    const std::string left = i == 0 ? fmt::format("<mrow>{}</mrow>", start) : "";
    rows += fmt::format("<mtr>{}{}</mtr>\n", cell(left), cell(formula(display.texts[i])));
  }
  return fmt::format("<mtable class=\"lines\">\n{}</mtable>", rows);
}

std::string block(const std::string& mathml) {
  return fmt::format("<math display=\"block\">{}</math>\n", mathml);
}

std::string table(const std::string& title, const std::vector<SheetVariable>& variables) {
  if (variables.empty()) return {};
  std::string text = fmt::format("<table>\n<caption>{}</caption>\n", title);
  for (const SheetVariable& v : variables) {
    text += fmt::format(
        "<tr><td><math>{}</math></td><td><code>{}</code></td><td>{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        formula(v.symbol), xml_text(v.name), xml_text(v.value), xml_text(v.unit), xml_text(v.doc));
  }
  return text + "</table>\n";
}

std::string section(const SheetOutput& output) {
  std::string text = fmt::format("<h2>{}</h2>\n", xml_text(output.name));
  if (!output.doc.empty()) text += fmt::format("<p>{}</p>\n", xml_text(output.doc));
  if (!output.definition.empty()) text += block(formula(output.definition));
  for (const SheetEquation& equation : output.equations) {
    for (const Display& display : displays(equation)) {
      text += block(display.columns > 0 ? matrix(display) : lines(display));
    }
  }
  return text;
}

constexpr const char* style =
    "body { font-family: serif; max-width: 52em; margin: 2em auto; padding: 0 1em; }\n"
    "h1, h2 { font-weight: normal; }\n"
    "table { border-collapse: collapse; margin: 1em 0; }\n"
    "caption { text-align: left; font-style: italic; }\n"
    "td { padding: 0.1em 0.8em 0.1em 0; }\n"
    "math[display=block] { margin: 0.8em 0; overflow-x: auto; overflow-y: hidden; }\n"
    "mtable.lines mtd { text-align: left; }\n";

}  // namespace

std::string html_page(const Sheet& sheet) {
  const std::string title = xml_text(sheet.title);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      title, style, title);
  for (const std::string& paragraph : {sheet.description, sheet.reference}) {
    if (!paragraph.empty()) text += fmt::format("<p>{}</p>\n", xml_text(paragraph));
  }
  for (const std::string& note : sheet.notes) text += fmt::format("<p>{}</p>\n", xml_text(note));
  text += block(formula(sheet.equation_of_motion));
  text += table("Coordinates", sheet.coordinates);
  text += table("Inputs", sheet.inputs);
  text += table("Parameters", sheet.parameters);
  for (const SheetOutput& output : sheet.outputs) text += section(output);
  return text + "</body>\n</html>\n";
}

}  // namespace elgen
