// html_page: a Sheet as one page of HTML with MathML Core, translated from the LaTeX.
#include <fmt/format.h>

#include "render/latex_tree.hpp"
#include "render/page_data.hpp"

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

std::string html_equation(const Display& display) {
  return display.columns > 0 ? matrix(display) : lines(display);
}

}  // namespace

std::string html_page(const Sheet& sheet) {
  const PageWords words{xml_text, xml_text, formula, html_equation};
  return fill_template("pages/mathml.html.mustache", page_data(sheet, words));
}

}  // namespace elgen
