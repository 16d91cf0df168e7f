// Derivations as text and as pages.
#include "print/steps.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "elgen/steps.hpp"
#include "elgen/typeset.hpp"
#include "print/small_page.hpp"
#include "support/models.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Derivation {
  explicit Derivation(const std::string& text) : checked(checked_model(text)) {
    const auto derived = derive_textbook_steps(*formulate(checked.model));
    const auto recursive = lower(derived->equations, derived->requests, {});
    steps.program = typeset_derivation(checked, present(*recursive), *recursive);
    steps.masses.assign(derived->masses.size(), "mass");
  }

  [[nodiscard]] std::string text(std::string_view title = {}) const {
    return text_of(derivation_sections(checked.model, steps, title));
  }
  [[nodiscard]] Page page() const { return derivation_page(checked.model, checked.scene, steps); }

  CheckedModel checked;
  ReadableDerivation steps;
};

}  // namespace

TEST_CASE("the steps are in the order of a textbook") {
  const Derivation d(read_model("cart_pole"));
  const std::string text = d.text();
  std::size_t last = 0;
  for (const char* title :
       {"\nAction\n", "\nPositions\n", "\nVelocities\n", "\nEnergies\n", "\nEquation of x\n",
        "\nEquation of theta\n", "\nEnergy function\n", "\nEquations of motion\n"}) {
    INFO(title);
    const std::size_t at = text.find(title, last);
    REQUIRE(at != std::string::npos);
    last = at;
  }
  CHECK(mentions(text, " = (x, 0)\n"));
  CHECK(mentions(text, " = (x + l*sin(theta), l*cos(theta))\n"));
  CHECK(mentions(text, "  dL/dtheta = -m*l*dot(x)*dot(theta)*sin(theta) + m*g*l*sin(theta)\n"));
  CHECK(mentions(d.text(energies_title), "  V = m*g*l*cos(theta)\n"));
}

TEST_CASE("dissipation, forces and explicit time are separate steps") {
  const Derivation d(read_model("everything"));
  const std::string text = d.text();
  CHECK(mentions(text, "  dD/d(dot(r)) = "));
  CHECK(mentions(text, "L contains t, so E is not conserved\n"));
  CHECK(mentions(text, "  dL/dt at fixed q and v = "));
}

TEST_CASE("D as typed brings the definitions that it contains") {
  const Derivation d(model_text("damped", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
m = 1
c = 2
[define]
w = "dot(x) - dot(y)"
[energy]
T = "1/2*m*(dot(x)^2 + dot(y)^2)"
D = "1/2*c*w^2"
)toml"));
  CHECK(mentions(d.text(energies_title), "  D = 1/2*c*w^2\n  where w = dot(x) - dot(y)\n"));
}

TEST_CASE("the page has one section per step") {
  const std::vector<PageSection> sections = Derivation(read_model("cart_pole")).page().sections;
  REQUIRE(sections.size() == 8);
  CHECK(text_of(sections[0].title) == "Action");
  CHECK(latex_of(sections[5].title) == "\\text{Equation of } \\theta");
  CHECK(sections[1].equations.at(0).rows == 2);
  CHECK(latex_of(sections[5].equations.at(0).left) ==
        "\\frac{\\partial L}{\\partial \\dot{\\theta}}");
}

TEST_CASE("a derivation begins with the action, its variation by parts and the end points") {
  const Derivation free(
      model_text("block", "[[coordinate]]\nname = \"x\"\n[energy]\nT = \"dot(x)^2\"\n"));
  CHECK(free.text().find(R"(
Action
  Hamilton's principle: the motion between two fixed ends makes S stationary.
  S = int L dt
  delta S = int (dL/dq * delta q + dL/dv * d/dt delta q) dt
  delta S = int (dL/dq - d/dt dL/dv) * delta q dt + [dL/dv * delta q] by parts
  [dL/dv * delta q] = 0, as delta q = 0 at both ends
  delta S = 0 for every delta q, so d/dt dL/dv - dL/dq = 0

Energies
)") == 0);
  const Derivation driven(read_model("cart_pole"));
  const std::string text = driven.text();
  CHECK(mentions(text, "  delta W = Q * delta q is the virtual work of forces (d'Alembert)\n"));
  CHECK(mentions(text, "for every delta q, so d/dt dL/dv - dL/dq = Q\n"));
  CHECK(mentions(text, "\n  dE/dt = v^T Q\n"));
}

TEST_CASE("a cyclic coordinate has a line about Noether's theorem, with symbols on a page") {
  const Derivation d(read_model("cart_pole"));
  CHECK(mentions(d.text(),
                 "  L does not contain x, so p_x = dL/d(dot(x)) is conserved if no force and no "
                 "dissipation act on it\n"));
  const Page page = d.page();
  CHECK(latex_of(page.sections[4].lines) ==
        std::vector<std::string>{
            "L \\text{ does not contain } x \\text{, so } p_{x} = \\frac{\\partial L}{\\partial "
            "\\dot{x}} \\text{ is conserved if no force and no dissipation act on it}"});
  CHECK(page.sections[5].lines.empty());
  const std::string screen = screen_page(page, {120, Alphabet::unicode});
  CHECK(mentions(screen, "  S = ∫ L dt\n"));
  CHECK(mentions(screen, "  δS = ∫ (∂L/∂q - d/dt ∂L/∂q̇) ⋅ δq dt + [∂L/∂q̇ ⋅ δq] by parts\n"));
  CHECK(mentions(screen, "  L does not contain x, so pₓ = ∂L/∂ẋ is conserved if"));
  CHECK(mentions(screen, "  L does not contain t, so E is conserved if forces"));
}

TEST_CASE("a multiplier is added to L, and acts on coordinates in its equation") {
  const Derivation d(read_model("rod"));
  const std::string text = d.text();
  INFO(text);
  CHECK(mentions(text, "so d/dt dL/dv - dL/dq = A^T lambda\n"));
  CHECK(mentions(text, "\nConstraints\n"));
  CHECK(mentions(text, "  L + lambda_rod*f_rod instead of L gives the same A^T lambda\n"));
  CHECK(mentions(text, "  f_rod = 1/2*(x^2 + y^2) - 1/2*l^2\n"));
  CHECK(mentions(text, "  (A^T lambda)_x = lambda_rod*x\n  m*dot(dot(x)) = lambda_rod*x\n"));
  CHECK_FALSE(mentions(text, "p_x = dL/d(dot(x)) is conserved"));
  CHECK(mentions(text, "E is conserved if constraints do no work\n"));
  CHECK(mentions(text,
                 "\nEquations of motion\n"
                 "  m*dot(dot(x)) = lambda_rod*x\n"
                 "  m*dot(dot(y)) + m*g = lambda_rod*y\n"
                 "  1/2*(x^2 + y^2) - 1/2*l^2 = 0\n"));
  CHECK_FALSE(mentions(text, "  dot(dot(x)) = "));
}

TEST_CASE("velocity constraints do virtual work and do not change L") {
  const Derivation d(read_model("disc"));
  const std::string text = d.text();
  INFO(text);
  CHECK(mentions(
      text, "  constraints on velocities add nothing to L: delta q * A^T lambda is virtual work"));
  CHECK_FALSE(mentions(text, "instead of L"));
  CHECK(mentions(text, "  phi_roll_2 = dot(y) - R*dot(phi)*sin(psi)\n"));
  CHECK(mentions(text, "L does not contain psi, so p_psi = dL/d(dot(psi)) is conserved\n"));
  CHECK_FALSE(mentions(text, "L does not contain phi, so"));
  CHECK(mentions(text,
                 "\nEquations of motion\n"
                 "  m*dot(dot(x)) = lambda_roll_1\n"
                 "  m*dot(dot(y)) = lambda_roll_2\n"
                 "  A*dot(dot(phi)) = tau - lambda_roll_1*R*cos(psi) - lambda_roll_2*R*sin(psi)\n"
                 "  J*dot(dot(psi)) = 0\n"
                 "  dot(x) - R*dot(phi)*cos(psi) = 0\n"));
}

TEST_CASE("a page of steps prints multipliers by their symbols, also in its heading") {
  const Derivation d(read_model("rod"));
  const Page page = d.page();
  CHECK(mentions(latex_of(page.equation_of_motion), "= A^{\\top} \\boldsymbol{\\lambda}"));
  CHECK(latex_of(page.sections.back().equations.at(0).entries.at(0)) ==
        "\\lambda_{\\mathrm{rod}} x");
}

TEST_CASE("the lines of the principle are printed as they are read") {
  for (const char* const name : {"rod", "disc", "everything", "cart_pole", "free_pendulum"}) {
    const Model model = checked_model(read_model(name)).model;
    std::vector<std::string> lines = principle_lines(model);
    lines.push_back(lagrange_equation(model));
    lines.push_back(energy_rate(model, false));
    for (const std::string& line : lines) {
      const Glyphs glyphs = read_latex(line);
      CHECK(read_latex(to_latex(glyphs)) == glyphs);
    }
  }
}

TEST_CASE("a prescribed angle with a root keeps its name, a short angle is substituted") {
  const auto orbit = [](const std::string& angle) {
    return R"toml(format = 1
[model]
name = "dumbbell"
[[coordinate]]
name = "theta"
unit = "rad"
[parameters]
m = { value = 50, unit = "kg", assume = "positive" }
l = { value = 10, unit = "m", assume = "positive" }
Ro = { value = 7e6, unit = "m", assume = "positive" }
mu = { value = 4e14, unit = "m^3/s^2", assume = "positive" }
w = { value = 1e-3, unit = "1/s", assume = "positive" }
[[prescribed]]
name = "nu"
unit = "rad"
value = ")toml" +
           angle + R"toml("
[[point]]
name = "a"
at = ["Ro*cos(nu) + l*cos(nu + theta)", "Ro*sin(nu) + l*sin(nu + theta)"]
mass = "m"
[gravity]
vector = ["0", "-w^2*Ro"]
)toml";
  };
  const std::string by_name = Derivation(orbit("sqrt(mu/Ro^3)*t")).text();
  INFO(by_name);
  CHECK(mentions(by_name, "nu = t*sqrt(mu/Ro^3)"));
  CHECK(mentions(by_name, "cos(nu + theta)"));
  CHECK_FALSE(mentions(by_name, "(t*sqrt(mu/Ro^3)"));
  const std::string written_out = Derivation(orbit("w*t")).text();
  INFO(written_out);
  CHECK(mentions(written_out, "cos(w*t"));
  CHECK_FALSE(mentions(written_out, "nu = "));
}
