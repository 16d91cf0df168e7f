// Tests small motions: frequencies of textbook systems (in closed form and as numbers), poles, and
// refusals.
#include <cmath>

#include "analyse/found.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct Motions {
  CheckedModel checked;
  Modes modes;
};

Motions motions(const std::string& text, const std::string& at = {},
                const std::vector<std::string>& sizes = {}) {
  Products products = modes_products(inputs_of(text), at, sizes);
  INFO(format(products.diagnostics));
  REQUIRE(products.modes);
  return {std::move(*products.checked), std::move(*products.modes)};
}

std::string page(const Motions& found) {
  return screen_page(modes_page(found.checked, found.modes), {100, Alphabet::unicode});
}

std::vector<double> squares(const LinearMotions& motions) {
  std::vector<double> result;
  for (const NormalMode& mode : motions.modes) {
    result.push_back(to_double(mode.omega_squared));
  }
  return result;
}

/// Compares w^2 l/g of each mode with `expected`. Links and masses are equal; l = 0.3, g = 9.81.
void check_chain(const std::string& size, const std::vector<double>& expected) {
  const Motions chain = motions(model_file("chain"), {}, {size});
  REQUIRE(chain.modes.motions.size() == 1);
  const std::vector<double> found = squares(chain.modes.motions[0]);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i] * 0.3 / 9.81 == Approx(expected[i]).epsilon(1e-14));
  }
}

}  // namespace

TEST_CASE("the double pendulum has two modes, by a formula") {
  CHECK(page(motions(model_file("double_pendulum"))) ==
        R"(Double pendulum: normal modes at θ₁ = 0, θ₂ = 0 (stable)

  M η̈ + K η = 0
  M = ⎡ (m₁ + m₂) l₁²   m₂ l₁ l₂ ⎤  K = ⎡ (m₁ + m₂) g l₁      0    ⎤
      ⎣   m₂ l₁ l₂       m₂ l₂²  ⎦      ⎣       0          m₂ g l₂ ⎦

       g ((m₁ + m₂) (l₁ + l₂) ∓ √(m₁ (m₁ (l₁ - l₂)² + 2 m₂ (l₁² + l₂²)) + m₂² (l₁ + l₂)²))
  ω² = ───────────────────────────────────────────────────────────────────────────────────
                                           2 m₁ l₁ l₂

  mode   ω² [1/s²]   f [Hz]     θ₁          θ₂
  1      13.0399     0.574721   0.704612    1
  2      66.4211     1.2971     -0.504612   1
)");
}

TEST_CASE("the tilted bead has the same mode on either side") {
  CHECK(page(motions(model_file("rotating_hoop"))) ==
        R"(Bead on a hoop turned about its vertical diameter: normal modes at θ = ±0.697569 (stable)

  m R² η̈ + K η = 0,   K = m (R² Ω⁴ - g²)/Ω²

             g²
  ω² = Ω² - ─────
            R² Ω²

  mode   ω² [1/s²]   f [Hz]     θ
  1      26.4078     0.817873   1
)");
}

TEST_CASE("a sum of masses before an acceleration has brackets in all notations") {
  const Motions sum = motions(R"(format = 1
[model]
name = "pair"
[[coordinate]]
name = "x"
range = [-1, 1]
[parameters]
m1 = 1
m2 = 1
k = 1
c = 1
[energy]
T = "1/2*(m1 + m2)*dot(x)^2"
V = "1/2*(k + c)*x^2"
)");
  CHECK(mentions(text_of(modes_page(sum.checked, sum.modes)),
                 "  (m1 + m2) eta'' + K eta = 0,   K = k + c\n"));
  CHECK(mentions(page(sum), "  (m₁ + m₂) η̈ + K η = 0,   K = k + c\n"));
  CHECK(mentions(latex_document(modes_page(sum.checked, sum.modes)),
                 "(m_{1} + m_{2}) \\ddot{\\eta} + K \\eta = 0"));
}

TEST_CASE("the cart-pole is controllable in the upright position") {
  const Motions upright = motions(model_file("cart_pole"), "theta=0");
  REQUIRE(upright.modes.motions.size() == 1);
  const LinearMotions& about = upright.modes.motions[0];
  REQUIRE(about.poles.size() == 4);
  CHECK(about.poles[0].real() == Approx(4.64564).epsilon(1e-6));
  CHECK(about.poles[1].real() == Approx(-4.64564).epsilon(1e-6));
  CHECK(about.poles[2] == 0.0);
  CHECK(about.poles[3] == 0.0);
  CHECK(about.controllable_rank == 4);
  CHECK(mentions(page(upright), "linearised equations at x = 0, θ = 0, u = 0 (unstable)\n"));
  CHECK(mentions(page(upright), "inputs        u: controllable (rank 4 of 4)"));
}

TEST_CASE("chains of equal links have the frequencies of Laguerre's polynomials") {
  check_chain("n=3", {0.4157745567834791, 2.294280360279042, 6.289945082937479});
  check_chain("n=5", {0.2635603197181409, 1.413403059106517, 3.596425771040722, 7.085810005858838,
                      12.64080084427578});
}

TEST_CASE("equal pendulums: w^2 = g/l (2 -+ sqrt 2)") {
  const std::string text = model_file("double_pendulum");
  PipelineOptions options;
  options.goals = {Goal::modes};
  options.scene.fixed = {make_source("--fix", "m1=1"), make_source("--fix", "m2=1"),
                         make_source("--fix", "l1=1"), make_source("--fix", "l2=1")};
  const Products products = products_with(&Products::modes, inputs_of(text), options);
  const std::string page = text_of(modes_page(*products.checked, *products.modes));
  CHECK(mentions(page, "w^2 = g*(2 -+ sqrt(2))\n"));
}

TEST_CASE("the square root of a square is simplified: a cylinder inside a hollow cylinder") {
  const std::string text = R"toml(format = 1
[model]
name = "cylinders"
[[coordinate]]
name = "theta"
unit = "rad"
[[coordinate]]
name = "phi"
unit = "rad"
[parameters]
M = { value = 2, unit = "kg", assume = "positive" }
m = { value = 1, unit = "kg", assume = "positive" }
a = { value = 0.5, unit = "m", assume = "positive" }
b = { value = 0.1, unit = "m", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
[[body]]
name = "outer"
mass = "M"
com = ["0", "0"]
inertia = "M*a^2"
spin = "-dot(phi)"
[[body]]
name = "inner"
mass = "m"
com = ["-(a - b)*sin(theta)", "-(a - b)*cos(theta)"]
inertia = "1/2*m*b^2"
spin = "-(a*dot(phi) - (a - b)*dot(theta))/b"
[gravity]
vector = ["0", "-g"]
)toml";
  const Motions cylinders = motions(text, "theta=0");
  const std::string page = text_of(modes_page(cylinders.checked, cylinders.modes));
  INFO(page);
  CHECK(mentions(page, "w^2 = 0\n"));
  CHECK_FALSE(mentions(page, "sqrt"));
  CHECK_FALSE(mentions(page, "-+"));
}

TEST_CASE("Stumpff functions of 0 are numbers on the page of small motions") {
  const std::string text = R"toml(format = 1
[model]
name = "soft"
[[coordinate]]
name = "q"
unit = "rad"
range = [-2, 2]
[parameters]
m = { value = 0.1, unit = "kg", assume = "positive" }
L = { value = 0.3, unit = "m", assume = "positive" }
k = { value = 0.2, unit = "N*m", assume = "positive" }
g = { value = 9.81, unit = "m/s^2" }
[[point]]
name = "tip"
mass = "m"
at = )toml";
  const std::string rest = "\n[energy]\nV = \"1/2*k*q^2\"\n[gravity]\nvector = [\"0\", \"-g\"]\n";
  for (const std::string at : {R"toml(["L*q*cosc(q)", "-L*sinc(q)"])toml",
                               R"toml(["L*(1 - cos(q))/q", "-L*sin(q)/q"])toml"}) {
    const Motions soft = motions(text + at + rest, "q=0");
    const std::string page = text_of(modes_page(soft.checked, soft.modes));
    INFO(page);
    CHECK_FALSE(mentions(page, "cosc"));
    CHECK_FALSE(mentions(page, "stumpff"));
    // (k + g L m/3)/(m L^2/4)
    CHECK(squares(soft.modes.motions[0])[0] ==
          Approx((0.2 + 9.81 * 0.3 * 0.1 / 3) / (0.1 * 0.09 / 4)));
  }
}

TEST_CASE("a molecule on a line: 0, k/m, k (1/m + 2/M)") {
  const std::string text = R"(format = 1
[model]
name = "molecule"
[[coordinate]]
name = "x1"
unit = "m"
[[coordinate]]
name = "x2"
unit = "m"
[[coordinate]]
name = "x3"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
M = { value = 3, unit = "kg" }
k = { value = 5, unit = "N/m" }
b = { value = 1, unit = "m" }
[energy]
T = "1/2*m*dot(x1)^2 + 1/2*M*dot(x2)^2 + 1/2*m*dot(x3)^2"
V = "1/2*k*(x2 - x1 - b)^2 + 1/2*k*(x3 - x2 - b)^2"
)";
  const Motions molecule = motions(text, "x1=0,x2=1,x3=2");
  REQUIRE(molecule.modes.motions.size() == 1);
  const std::vector<double> found = squares(molecule.modes.motions[0]);
  CHECK(std::abs(found[0]) < 1e-25);
  CHECK(found[1] == Approx(5.0 / 2).epsilon(1e-15));
  CHECK(found[2] == Approx(5 * (1 / 2.0 + 2 / 3.0)).epsilon(1e-15));
  const std::vector<double> stretched{-1, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(molecule.modes.motions[0].modes[1].shape[i]) ==
          Approx(std::abs(stretched[i])).margin(1e-9));
  }
}

TEST_CASE("modes of equal frequency span a space") {
  const Motions found =
      motions(potential_model(coordinate("x") + coordinate("y"), "1/2*x^2 + 1/2*y^2"));
  REQUIRE(found.modes.motions.size() == 1);
  CHECK(found.modes.motions[0].modes[0].multiplicity == 2);
  CHECK(found.modes.motions[0].modes[0].shape == std::vector<double>{1, 0});
  CHECK(found.modes.motions[0].modes[1].shape == std::vector<double>{0, 1});
}

TEST_CASE("damped systems have poles, damping ratios and time constants") {
  const Motions damped = motions(model_file("two_mass_damper"));
  const std::string text = page(damped);
  CHECK(damped.modes.motions[0].modes.empty());
  CHECK(mentions(text, "damping ratio"));
  for (const std::complex<double>& pole : damped.modes.motions[0].poles) CHECK(pole.real() < 0);
}

TEST_CASE("A and B agree with the linearization of the program") {
  const Motions upright = motions(model_file("cart_pole"), "theta=0");
  const RestPoint& point = upright.modes.motions[0].point;
  const OracleValues exact =
      oracle_values(upright.checked.model,
                    {.kind = OutputKind::linearization, .rows = 4, .columns = 4}, point.state);
  REQUIRE(exact);
  std::vector<double> both = upright.modes.motions[0].a;
  both.insert(both.end(), upright.modes.motions[0].b.begin(), upright.modes.motions[0].b.end());
  REQUIRE(exact->size() == both.size());
  for (std::size_t i = 0; i < both.size(); ++i) {
    CHECK(both[i] == Approx(to_double((*exact)[i])).margin(1e-13));
  }
}

TEST_CASE("motions are refused if forces do not balance or no equilibrium is stable") {
  const Products moving = modes_products(inputs_of(model_file("cart_pole")), "theta=1");
  CHECK_FALSE(moving.modes);
  CHECK(moving.diagnostics.back().code == Code::E532);
  const Products none =
      modes_products(inputs_of(potential_model(coordinate("x", "[-1, 1]"), "-1/2*x^2")));
  CHECK_FALSE(none.modes);
  CHECK(mentions(format(none.diagnostics), "E532"));
}
