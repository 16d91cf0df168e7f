// A page with all content that needs special treatment in some notation.
#pragma once

#include <string>

#include "elgen/page.hpp"
#include "formula/glyphs.hpp"
#include "support/text.hpp"

namespace elgen::test {

inline Page small_page() {
  Page page;
  page.title = prose("A & B_1");
  page.description = "100 % of x < y";
  page.equation_of_motion = latex_formula("M \\ddot{q} = 0");
  page.parameters = {{latex_formula("m_{1}"), "m1", "kg", "0.5", "mass | of *one*"}};
  page.sections = {
      {.title = prose("Gravity"),
       .function = "gravity",
       .kind = OutputKind::gravity,
       .doc = "Slope.",
       .equations = {{latex_formula("g"), 2, 1, {number_formula(0), latex_formula("m_{1} g")}}}}};
  return page;
}

inline std::string latex_of(const Formula& formula) { return to_latex(glyphs_of(formula)); }

inline std::vector<std::string> latex_of(const Formulas& formulas) {
  std::vector<std::string> all;
  for (const Formula& formula : formulas) all.push_back(latex_of(formula));
  return all;
}

}  // namespace elgen::test
