// Pages on constraints: equations as typed, multipliers with their units, gains.
#include "render/constraints.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "elgen/typeset.hpp"
#include "render/constrained.hpp"
#include "render/headings.hpp"
#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::test;
using elgen::testing::has;

namespace {

using Cells = std::vector<std::string>;

Sheet typeset_sheet(const std::string& text) {
  const Chosen c = chosen(text);
  return sheet(c.checked.model, c.checked.scene, typeset(c.checked, c.forms, c.choice.program));
}

const SheetOutput& section_titled(const Sheet& sheet, const std::string& title) {
  const auto found = std::ranges::find(sheet.outputs, title, &SheetOutput::title);
  REQUIRE(found != sheet.outputs.end());
  return *found;
}

}  // namespace

TEST_CASE("a constraint is a line of its sides, its kind and its gains") {
  CHECK(constraint_lines(checked_model(rod_text()).model) ==
        Cells{"rod (position): (x^2 + y^2)/2 = l^2/2, omega = 2*omega, zeta = 1"});
  CHECK(constraint_lines(checked_model(disc_text()).model) ==
        Cells{"roll_1 (velocity): dot(x) = R*cos(psi)*dot(phi)",
              "roll_2 (velocity): dot(y) = R*sin(psi)*dot(phi)"});
  CHECK(constraint_lines(checked_model(model_text("none",
                                                  "[[coordinate]]\nname = \"x\"\n"
                                                  "[energy]\nT = \"dot(x)^2\"\n"))
                             .model)
            .empty());
}

TEST_CASE("points that coincide stand by their names") {
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
  const Sheet page = typeset_sheet(crank);
  CHECK(section_titled(page, "Constraints").table.cells.at(3) == "x_{P} = x_{Q}");
}

TEST_CASE("rates obey what the gains ask for, and nothing else") {
  CHECK(constraint_equation(checked_model(rod_text()).model).text ==
        "A a = -gamma - 2 zeta omega r - omega^2 f");
  CHECK(constraint_equation(checked_model(disc_text()).model).text == "A a = -gamma");
  const std::string steady = disc_text() + "stabilise = { omega = 10, zeta = 1 }\n";
  CHECK(constraint_equation(checked_model(steady).model).text == "A a = -gamma - 2 zeta omega r");
}

TEST_CASE("sheets have a table of constraints, and each multiplier by its symbol") {
  const Sheet page = typeset_sheet(rod_text());
  const SheetOutput& section = section_titled(page, "Constraints");
  CHECK(has(section.doc, " rod: massless."));
  CHECK(section.definition ==
        "A \\ddot{\\mathbf{q}} = -\\boldsymbol{\\gamma} - 2 \\zeta \\omega \\mathbf{r} - "
        "\\omega^{2} \\mathbf{f}");
  CHECK(section.table.cells ==
        Cells{"\\lambda_{\\mathrm{rod}}", "\\text{kg/s\u00b2}", "\\text{position}",
              "\\frac{x^{2} + y^{2}}{2} = \\frac{l^{2}}{2}", "2 \\omega", "1"});
  CHECK(section_titled(page, "Forward dynamics").equations.back().left ==
        "\\lambda_{\\mathrm{rod}}");
  const Sheet other = typeset_sheet(disc_text());
  CHECK(section_titled(other, "Constraints").table.heads.size() == 4);
  CHECK(has(markdown_page(page), "| $\\lambda_{\\mathrm{rod}}$ | kg/s\u00b2 | position | $"));
}

TEST_CASE("the page of text lists constraints below the variables") {
  const Chosen c = chosen(rod_text());
  CHECK(has(text_page(c.checked.model, c.checked.scene, c.choice.program),
            "  lambda = (lambda_rod [kg/s^2])\n"
            "  A a = -gamma - 2 zeta omega r - omega^2 f, (f, r) = constraint_residual\n\n"
            "constraints\n  rod (position): "));
}

TEST_CASE("what holds for forces without constraints is not said of those with some") {
  const Chosen c = chosen(rod_text());
  for (const Function& function : c.choice.program.functions) {
    if (function.kind == OutputKind::energy_function) {
      CHECK(has(output_doc(c.checked.model, function), "v.(B u + A^T lambda + Q - dD/dv)"));
    }
    if (function.kind == OutputKind::position_gradient) {
      CHECK_FALSE(has(elgen::heading(c.checked.model, function).definition, "="));
    }
  }
}
