#include <catch2/catch.hpp>
#include <sstream>

#include "elgen/render.hpp"
#include "render/drawing.hpp"
#include "render/small_sheet.hpp"

using namespace elgen;
using namespace elgen::testing;

namespace {

/// M = [ long  b ; b  1 ] and a long sum.
Sheet wide_sheet() {
  std::string sum = "m_{1} l";
  for (int i = 2; i < 20; ++i) sum += " + m_{" + std::to_string(i) + "} l";
  Sheet sheet;
  sheet.title = "Wide";
  sheet.equation_of_motion = "M(q) \\ddot{q} = 0";
  sheet.coordinates = {{"\\theta_{1}", "theta1", "rad", "", "angle"}};
  sheet.outputs = {
      {"Mass matrix",
       "mass_matrix",
       OutputKind::mass_matrix,
       "Mass matrix.",
       "",
       {{"M", 2, 2, {sum, "b", "b", "1"}}}},
      {"Gravity", "gravity", OutputKind::gravity, "Slope.", "", {{"g", 2, 1, {sum, "0"}}}}};
  return sheet;
}

std::size_t widest_line(const std::string& page) {
  std::istringstream lines(page);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, columns_of(line));
  return widest;
}

}  // namespace

TEST_CASE("a screen shows variables and matrices") {
  CHECK(screen_page(small_sheet(), {80, Alphabet::unicode}) ==
        "A & B_1\n\n  M q̈ = 0\n\n  m₁   = 0.5 kg   mass | of *one*\n\nGravity\n  Slope.\n"
        "  g = ⎡  0   ⎤\n      ⎣ m₁ g ⎦\n");
}

TEST_CASE("a matrix too wide gives names to what is wider than a name") {
  const std::string page = screen_page(wide_sheet(), {60, Alphabet::unicode});
  CHECK(has(page, "  M = ⎡ M₁₁   b ⎤\n      ⎣  b    1 ⎦\n  M₁₁ = m₁ l + m₂ l"));
  CHECK(has(page, "  g₁ = m₁ l + m₂ l"));
  CHECK(has(page, "  all other entries are 0\n"));
}

TEST_CASE("signs of aligned equations stand below each other, titles have formulas") {
  SheetOutput output{.title = "Equation of theta1",
                     .title_latex = "\\text{Equation of }\\theta_{1}",
                     .is_aligned = true};
  output.equations = {{"\\frac{\\partial L}{\\partial \\dot{\\theta}_{1}}", 1, 1, {"a"}},
                      {"V", 1, 1, {"b"}},
                      {"\\mathbf{r}", 2, 1, {"x", "y"}}};
  Sheet sheet;
  sheet.outputs = {output};
  CHECK(screen_page(sheet, {80, Alphabet::unicode}) ==
        "\n\nEquation of θ₁\n"
        "  ∂L/∂θ̇₁ = a\n"
        "       V = b\n"
        "       r = ⎡ x ⎤\n"
        "           ⎣ y ⎦\n");
}

TEST_CASE("no screen is exceeded") {
  for (const std::size_t columns : std::vector<std::size_t>{40, 60, 80, 132}) {
    INFO(columns);
    CHECK(widest_line(screen_page(wide_sheet(), {columns, Alphabet::unicode})) <= columns);
    CHECK(widest_line(overview(wide_sheet(), {columns, Alphabet::unicode})) <= columns);
    CHECK(widest_line(overview(wide_sheet(), {columns, Alphabet::ascii})) <= columns);
  }
}

TEST_CASE("the overview folds what does not fit, and says how long it is") {
  CHECK(overview(wide_sheet(), {60, Alphabet::unicode}) ==
        "Wide\n\n  M(q) q̈ = 0\n  q = (θ₁ [rad])\n\n  M = ⎡ …140   b ⎤\n      ⎣  b     1 ⎦\n\n"
        "  g = ⎡ …140 ⎤\n      ⎣  0   ⎦\n");
}

TEST_CASE("the overview of other outputs shows the first three") {
  CHECK(has(overview(small_sheet(), {60, Alphabet::ascii}), "  g = [  0   ]\n      [ m1 g ]\n"));
}
