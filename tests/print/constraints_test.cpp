// Constraints on pages: equations as typed, multipliers with their units, gains.

#include <algorithm>
#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "elgen/typeset.hpp"
#include "print/sections.hpp"
#include "print/small_page.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Cells = std::vector<std::string>;

Page typeset_page(const std::string& text) {
  const ChosenForms c = chosen(text);
  return model_page(c.checked.model, c.checked.scene,
                    typeset(c.checked, c.forms, c.choice.program));
}

const PageSection& section_titled(const Page& page, const std::string& title) {
  const auto found = std::ranges::find_if(
      page.sections, [&title](const PageSection& each) { return text_of(each.title) == title; });
  REQUIRE(found != page.sections.end());
  return *found;
}

}  // namespace

TEST_CASE("the line of a constraint has its sides, its kind and its gains") {
  CHECK(constraint_lines(checked_model(read_model("rod")).model) ==
        Cells{"rod (position): (x^2 + y^2)/2 = l^2/2, omega = 2*omega, zeta = 1"});
  CHECK(constraint_lines(checked_model(read_model("disc")).model) ==
        Cells{"roll_1 (velocity): dot(x) = R*cos(psi)*dot(phi)",
              "roll_2 (velocity): dot(y) = R*sin(psi)*dot(phi)"});
  CHECK(constraint_lines(checked_model(model_text("none",
                                                  "[[coordinate]]\nname = \"x\"\n"
                                                  "[energy]\nT = \"dot(x)^2\"\n"))
                             .model)
            .empty());
}

TEST_CASE("coinciding points are printed by their names") {
  const std::string crank = model_text("crank", R"toml([[coordinate]]
name = "a"
[[coordinate]]
name = "s"
[parameters]
l = 1
[energy]
T = "dot(a)^2 + dot(s)^2"
[[point]]
name = "P"
at = ["l*cos(a)", "0"]
[[point]]
name = "Q"
at = ["s", "0"]
[[constraint]]
name = "pin"
equation = "x(P) = x(Q)"
)toml");
  CHECK(constraint_lines(checked_model(crank).model) == Cells{"pin (position): x(P) = x(Q)"});
  const Page page = typeset_page(crank);
  CHECK(latex_of(section_titled(page, "Constraints").table.cells.at(3)) == "x_{P} = x_{Q}");
}

TEST_CASE("the constraint equation has exactly the terms of its gains") {
  CHECK(text_of(constraint_equation(checked_model(read_model("rod")).model)) ==
        "A a = -gamma - 2 zeta omega r - omega^2 f");
  CHECK(text_of(constraint_equation(checked_model(read_model("disc")).model)) == "A a = -gamma");
  const std::string steady = read_model("disc") + "stabilise = { omega = 10, zeta = 1 }\n";
  CHECK(text_of(constraint_equation(checked_model(steady).model)) ==
        "A a = -gamma - 2 zeta omega r");
}

TEST_CASE("a page has a table of constraints with the symbols of their multipliers") {
  const Page page = typeset_page(read_model("rod"));
  const PageSection& section = section_titled(page, "Constraints");
  CHECK(mentions(section.doc, " rod: massless."));
  CHECK(latex_of(section.definition) ==
        "A \\ddot{\\mathbf{q}} = -\\boldsymbol{\\gamma} - 2 \\zeta \\omega \\mathbf{r} - "
        "\\omega^{2} \\mathbf{f}");
  CHECK(latex_of(section.table.cells) ==
        Cells{"\\lambda_{\\mathrm{rod}}", "\\text{kg/s\u00b2}", "\\text{position}",
              "\\frac{x^{2} + y^{2}}{2} = \\frac{l^{2}}{2}", "2 \\omega", "1"});
  CHECK(latex_of(section_titled(page, "Forward dynamics").equations.back().left) ==
        "\\lambda_{\\mathrm{rod}}");
  const Page other = typeset_page(read_model("disc"));
  CHECK(section_titled(other, "Constraints").table.heads.size() == 4);
  CHECK(mentions(markdown_page(page), "| $\\lambda_{\\mathrm{rod}}$ | kg/s\u00b2 | position | $"));
}

TEST_CASE("a text page lists constraints below the variables") {
  const ChosenForms c = chosen(read_model("rod"));
  CHECK(mentions(text_page(c.checked.model, c.checked.scene, c.choice.program),
                 "  lambda = (lambda_rod [kg/s^2])\n"
                 "  A a = -gamma - 2 zeta omega r - omega^2 f, (f, r) = constraint_residual\n\n"
                 "constraints\n  rod (position): "));
}

TEST_CASE("statements that hold only without constraints are omitted in models with constraints") {
  const ChosenForms c = chosen(read_model("rod"));
  for (const Function& function : c.choice.program.functions) {
    if (function.kind == OutputKind::energy_function) {
      CHECK(mentions(output_doc(c.checked.model, function), "v.(B u + A^T lambda + Q - dD/dv)"));
    }
    if (function.kind == OutputKind::position_gradient) {
      CHECK_FALSE(mentions(latex_of(elgen::heading(c.checked.model, function).definition), "="));
    }
  }
}
