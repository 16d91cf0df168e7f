#include <catch2/catch.hpp>

#include "elgen/page.hpp"
#include "formula/drawing.hpp"
#include "print/small_page.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A page with M = [s b; b 1] and g = [s; 0]; s is a sum of 19 terms.
Page wide_page() {
  Formulas terms;
  for (int i = 1; i < 20; ++i) {
    terms.push_back(latex_formula("m_{" + std::to_string(i) + "} l"));
  }
  const Formula sum = sum_of(terms);
  const Formula b = latex_formula("b");
  Page page;
  page.title = prose("Wide");
  page.equation_of_motion = latex_formula("M(q) \\ddot{q} = 0");
  page.coordinates = {{latex_formula("\\theta_{1}"), "theta1", "rad", "", "angle"}};
  page.sections = {{.title = prose("Mass matrix"),
                    .function = "mass_matrix",
                    .kind = OutputKind::mass_matrix,
                    .doc = "Mass matrix.",
                    .equations = {{latex_formula("M"), 2, 2, {sum, b, b, number_formula(1)}}}},
                   {.title = prose("Gravity"),
                    .function = "gravity",
                    .kind = OutputKind::gravity,
                    .doc = "Slope.",
                    .equations = {{latex_formula("g"), 2, 1, {sum, number_formula(0)}}}}};
  return page;
}

std::size_t widest_line(const std::string& page) {
  std::size_t widest = 0;
  for (const std::string& line : split_lines(page)) widest = std::max(widest, terminal_width(line));
  return widest;
}

}  // namespace

TEST_CASE("a screen shows variables and matrices") {
  CHECK(screen_page(small_page(), {80, Alphabet::unicode}) ==
        "A & B_1\n\n  M q̈ = 0\n\n  m₁   = 0.5 kg   mass | of *one*\n\nGravity\n  Slope.\n"
        "  g = ⎡  0   ⎤\n      ⎣ m₁ g ⎦\n");
}

TEST_CASE("in a matrix that is too wide, long entries get names") {
  const std::string page = screen_page(wide_page(), {60, Alphabet::unicode});
  CHECK(mentions(page, "  M = ⎡ M₁₁   b ⎤\n      ⎣  b    1 ⎦\n  M₁₁ = m₁ l + m₂ l"));
  CHECK(mentions(page, "  g₁ = m₁ l + m₂ l"));
  CHECK(mentions(page, "  all other entries are 0\n"));
}

TEST_CASE("aligned equations share the column of their equals signs, titles may have formulas") {
  PageSection section{.title = row_of({prose("Equation of"), latex_formula("\\theta_{1}")}),
                      .is_aligned = true};
  section.equations = {
      {latex_formula("\\frac{\\partial L}{\\partial \\dot{\\theta}_{1}}"),
       1,
       1,
       {latex_formula("a")}},
      {latex_formula("V"), 1, 1, {latex_formula("b")}},
      {latex_formula("\\mathbf{r}"), 2, 1, {latex_formula("x"), latex_formula("y")}}};
  Page page;
  page.sections = {section};
  CHECK(screen_page(page, {80, Alphabet::unicode}) ==
        "\n\nEquation of θ₁\n"
        "  ∂L/∂θ̇₁ = a\n"
        "       V = b\n"
        "       r = ⎡ x ⎤\n"
        "           ⎣ y ⎦\n");
}

TEST_CASE("no line is wider than the screen") {
  for (const std::size_t columns : std::vector<std::size_t>{40, 60, 80, 132}) {
    INFO(columns);
    CHECK(widest_line(screen_page(wide_page(), {columns, Alphabet::unicode})) <= columns);
    CHECK(widest_line(overview(wide_page(), {columns, Alphabet::unicode})) <= columns);
    CHECK(widest_line(overview(wide_page(), {columns, Alphabet::ascii})) <= columns);
  }
}

TEST_CASE("the overview abbreviates long entries and shows their length") {
  CHECK(overview(wide_page(), {60, Alphabet::unicode}) ==
        "Wide\n\n  M(q) q̈ = 0\n  q = (θ₁ [rad])\n\n  M = ⎡ …140   b ⎤\n      ⎣  b     1 ⎦\n\n"
        "  g = ⎡ …140 ⎤\n      ⎣  0   ⎦\n");
}

TEST_CASE("the overview of other outputs shows the first three") {
  CHECK(
      mentions(overview(small_page(), {60, Alphabet::ascii}), "  g = [  0   ]\n      [ m1 g ]\n"));
}
