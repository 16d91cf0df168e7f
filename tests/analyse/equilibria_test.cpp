// Equilibria of models: pages of textbook systems, numbers of equilibria, and claims of
// completeness.
#include <array>
#include <cmath>

#include "analyse/formulas.hpp"
#include "analyse/found.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"
#include "program/evaluate/subject.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string page(const std::string& model, const AnalysisOptions& words = {}) {
  const Analysed found = analyse_model(model_file(model), words);
  return screen_page(equilibria_page(found.checked, found.equilibria), {100, Alphabet::unicode});
}

double value(const RestPoint& point, std::size_t coordinate) {
  return to_double(point.state.q[coordinate]);
}

}  // namespace

TEST_CASE("the double pendulum has four equilibria, for all values of its parameters") {
  CHECK(page("double_pendulum") == R"(Double pendulum: equilibria (v = 0)

  θ₁   θ₂
  0    0    stable: V₀ has a strict minimum
  0    π    unstable: 5.84583 1/s
  π    0    unstable: 5.03436 1/s
  π    π    unstable: 8.14991 1/s, 3.61108 1/s

  exact for all values of the parameters; stability computed at the parameters' values; θ₁ and θ₂ modulo 2 π
  the list is complete at the parameters' values (proved)
)");
}

TEST_CASE("the bead leaves the bottom of a fast hoop") {
  CHECK(page("rotating_hoop") ==
        R"(Bead on a hoop turned about its vertical diameter: equilibria (v = 0)

  K = m R (R Ω² (2 sin² θ - 1) + g cos θ)

  θ                               K
  0                               m R (g - R Ω²)      unstable: 3.86652 1/s
  π                               -m R (g + R Ω²)     unstable: 10.6325 1/s
  ±arccos(g/(R Ω²)) = ±0.697569   m (R² Ω⁴ - g²)/Ω²   stable: V₀ - T₀ has a strict minimum

  the last two exist if |g| <= R Ω²; stability computed at the parameters' values; θ modulo 2 π
  the list is complete at the parameters' values (proved)
)");
}

TEST_CASE("the bead stays at the bottom of a slow hoop and of a hoop at the critical speed") {
  CHECK(page("rotating_hoop", {.fixed = {"Omega=2"}}) ==
        R"(Bead on a hoop turned about its vertical diameter: equilibria (v = 0)

  K = m R (4 R (2 sin² θ - 1) + g cos θ)

  θ   K
  0   m R (g - 4 R)    stable: V₀ - T₀ has a strict minimum
  π   -m R (g + 4 R)   unstable: 7.28354 1/s

  exact for all values of the parameters; stability computed at the parameters' values; θ modulo 2 π
  the list is complete at the parameters' values (proved)
)");
  const Analysed critical =
      analyse_model(model_file("rotating_hoop"), {.fixed = {"Omega=7", "g=9.8"}});
  REQUIRE(critical.equilibria.points.size() == 2);
  CHECK(critical.equilibria.completeness == Completeness::proved);
  const StabilityVerdict& bottom = critical.equilibria.points[0].stability;
  CHECK(bottom.kind == Stability::degenerate_minimum);
  CHECK(bottom.is_degenerate);
  REQUIRE(bottom.leading);
  CHECK(bottom.leading->order == 4);
}

TEST_CASE("the leading term of V has brackets around the displacement and the coefficient") {
  const Analysed well = analyse_model(R"(format = 1
[model]
name = "well"
[[coordinate]]
name = "x"
unit = "rad"
[parameters]
a = 1
b = 2
[energy]
T = "1/2*dot(x)^2"
V = "(a + b)*(1 + sin(x))^2"
)");
  const std::string text = text_of(equilibria_page(well.checked, well.equilibria));
  INFO(text);
  CHECK(mentions(text, "V0 = 1/4*(a + b)*(x + 1/2*pi)^4 + ... has a strict minimum"));
}

TEST_CASE("the page of a system without equilibria gives the reason and the cyclic coordinates") {
  CHECK(page("kepler_polar") == R"(Kepler problem in polar coordinates: equilibria (v = 0)

  no equilibrium: g = (μ m/r², 0) is not 0 for r in [0.3, 3] at the parameters' values (proved)
  φ is cyclic: a scene with [routh] phi = true holds its momentum and may have steady motions
)");
  CHECK(page("heavy_top") == R"(Heavy symmetric top: equilibria (v = 0)

  no equilibrium: g = (0, -m g h sin θ, 0) is not 0 for θ in [0.1, 3.04159] at the parameters' values (proved)
  φ and ψ are cyclic: a scene with [routh] holds their momenta and may have steady motions
)");
  const Analysed crane = analyse_model(read_model("crane"));
  CHECK(mentions(text_of(equilibria_page(crane.checked, crane.equilibria)),
                 "  an input is 0 unless --input NAME=VALUE sets it: F and S\n"));
}

TEST_CASE("only coordinates that [routh] can remove are called cyclic") {
  const std::string fall = R"toml(format = 1
[model]
name = "fall"
[[coordinate]]
name = "z"
[[coordinate]]
name = "x"
[parameters]
m = { value = 1, assume = "positive" }
g = { value = 9.81, assume = "positive" }
d = 2
[energy]
T = "1/2*m*(dot(x)^2 + dot(z)^2)"
V = "m*g*z"
)toml";
  const auto shown = [](const std::string& model) {
    const Analysed found = analyse_model(model);
    CHECK(found.equilibria.points.empty());
    return text_of(equilibria_page(found.checked, found.equilibria));
  };
  CHECK(shown(fall).ends_with(
      "  x is cyclic: a scene with [routh] x = true holds its momentum and may have steady motions"
      "\n"));
  // z is not cyclic because V depends on z; x is not cyclic if x is damped, driven or forced, or if
  // the force on z depends on the rate of x.
  for (const char* const acting :
       {"D = \"1/2*d*dot(x)^2\"\n", "[[input]]\nname = \"u\"\non = \"x\"\n",
        "[[force]]\non = \"x\"\nvalue = \"-d*dot(z)\"\n",
        "[[force]]\non = \"z\"\nvalue = \"-d*dot(x)\"\n"}) {
    CHECK_FALSE(mentions(shown(fall + acting), "cyclic"));
  }
  CHECK_FALSE(mentions(page("atwood"), "cyclic"));
  CHECK_FALSE(mentions(page("quadrotor"), "cyclic"));
}

TEST_CASE("coordinates that balance at exact angles have closed forms") {
  CHECK(page("elastic_pendulum") == R"(Elastic pendulum: equilibria (v = 0)

  r                     θ
  ℓ₀ - m g/k = 0.4365   π   unstable: 4.7407 1/s
  ℓ₀ + m g/k = 0.7635   0   stable: V₀ has a strict minimum

  exact for all values of the parameters; stability computed at the parameters' values; r in [0.2, 2]; θ modulo 2 π
  the list is complete at the parameters' values (proved)
)");
}

TEST_CASE("a two-link arm has four equilibria, a pendulum two") {
  const Analysed still = analyse_model(model_file("two_link_arm"));
  CHECK(still.equilibria.points.size() == 4);
  CHECK(still.equilibria.completeness == Completeness::proved);
  const Analysed held = analyse_model(model_file("simple_pendulum"));
  CHECK(held.equilibria.points.size() == 2);
}

TEST_CASE("a coordinate that occurs in no equation may have any value") {
  const Analysed cart = analyse_model(model_file("cart_pole"));
  REQUIRE(cart.equilibria.points.size() == 2);
  CHECK(cart.equilibria.points[0].coordinates[0].is_arbitrary);
  CHECK(cart.equilibria.points[0].stability.kind == Stability::unstable);
  // x may drift at any constant speed, so the linear part does not decide stability.
  CHECK(cart.equilibria.points[1].stability.kind == Stability::undecided);
  CHECK(analyse_model(model_file("cart_pole"), {.laws = {"u=1"}}).equilibria.points.empty());
}

TEST_CASE("equilibria at a singular M or outside the range of an angle are not listed") {
  const std::string sphere = R"toml(format = 1
[model]
name = "sph"
[[coordinate]]
name = "alpha"
unit = "rad"
[[coordinate]]
name = "beta"
unit = "rad"
range = [-1, 1]
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 1, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
[gravity]
vector = ["0", "0", "-g"]
[[point]]
name = "load"
at = ["l*sin(alpha)*cos(beta)", "-l*sin(beta)", "-l*cos(alpha)*cos(beta)"]
mass = "m"
)toml";
  const Analysed found = analyse_model(sphere);
  REQUIRE(found.equilibria.points.size() == 2);
  CHECK(value(found.equilibria.points[0], 1) == 0);
  CHECK(value(found.equilibria.points[1], 1) == 0);
  const std::string text = text_of(equilibria_page(found.checked, found.equilibria));
  INFO(text);
  CHECK(mentions(text,
                 "beta in [-1, 1]; alpha and beta modulo 2*pi\n"
                 "  the chart is singular at beta = +-1/2*pi\n"
                 "  the list is complete at the parameters' values (proved)\n"));
  // Polar coordinates are singular at r = 0. Of the equilibria 0 and pi of V = cos(x), only pi is
  // in the range [2, 4].
  const std::string polar =
      "format = 1\n[model]\nname = \"polar\"\n" + coordinate("r", "[-1, 1]") +
      "[[coordinate]]\nname = \"phi\"\n[energy]\nT = \"1/2*r^2*dot(phi)^2\"\nV = \"r^2\"\n";
  const Analysed middle = analyse_model(polar);
  CHECK(middle.equilibria.points.empty());
  CHECK(mentions(text_of(equilibria_page(middle.checked, middle.equilibria)),
                 "no equilibrium with a regular M for r in [-1, 1] at the parameters' values "
                 "(proved)\n"
                 "  the chart is singular at r = 0\n"));
  const Analysed half = analyse_model(potential_model(coordinate("x", "[2, 4]"), "cos(x)"));
  REQUIRE(half.equilibria.points.size() == 1);
  CHECK(half.equilibria.points[0].stability.kind == Stability::minimum);
}

TEST_CASE("springs on a line have one equilibrium for every position of the first mass") {
  const Analysed molecule =
      analyse_model(potential_model(coordinate("x1") + coordinate("x2") + coordinate("x3"),
                                    "1/2*(x2 - x1 - 1)^2 + 1/2*(x3 - x2 - 1)^2"));
  REQUIRE(molecule.equilibria.points.size() == 1);
  const RestPoint& point = molecule.equilibria.points[0];
  CHECK(point.coordinates[0].is_arbitrary);
  CHECK(value(point, 1) == 1);
  CHECK(value(point, 2) == 2);
  CHECK(molecule.equilibria.completeness == Completeness::proved);
}

TEST_CASE("a coordinate that cancels only at the values of the parameters is any at these values") {
  for (const auto& [coordinates, potential, parameters] :
       {std::array{coordinate("x", "[-1, 1]"), std::string("1/2*k*x^2"), std::string("k = 0\n")},
        std::array{coordinate("x"), std::string("(a - b)*x"), std::string("a = 1\nb = 1\n")},
        std::array{coordinate("x"), std::string("(0.1*a - b)*sin(x)"),
                   std::string("a = 3\nb = 0.3\n")}}) {
    const Analysed found =
        analyse_model(potential_model(coordinates, potential) + "[parameters]\n" + parameters);
    REQUIRE(found.equilibria.points.size() == 1);
    CHECK(found.equilibria.points[0].coordinates[0].is_arbitrary);
    CHECK_FALSE(found.equilibria.points[0].is_exact);
    CHECK(mentions(text_of(equilibria_page(found.checked, found.equilibria)),
                   "  \"any\" and stability computed at the parameters' values\n"
                   "  the list is complete at the parameters' values (proved)\n"));
  }
}

TEST_CASE("an equilibrium is exact if the equations are 0 for all values of the parameters") {
  const std::string spring =
      potential_model(coordinate("x", "[-3, 3]"), "1/2*k*(sqrt(x^2 + h^2) - c)^2") +
      "[parameters]\nk = 5\nh = { value = 1, assume = \"positive\" }\nc = 0.8\n";
  const Analysed found = analyse_model(spring);
  REQUIRE(found.equilibria.points.size() == 1);
  CHECK(found.equilibria.points[0].is_exact);
  CHECK(mentions(text_of(equilibria_page(found.checked, found.equilibria)),
                 "exact for all values of the parameters; stability computed at the parameters' "
                 "values"));
  // At c < h the only equilibrium is x = 0; at c > h there are also x = +-sqrt(c^2 - h^2).
  CHECK(analyse_model(spring, {.fixed = {"c=1.5"}}).equilibria.points.size() == 3);
  // The equilibrium is x = b - a, which is 0 at the values of a and b.
  const Analysed special = analyse_model(potential_model(coordinate("x"), "1/2*x^2 + (a - b)*x") +
                                         "[parameters]\na = 1\nb = 1\n");
  REQUIRE(special.equilibria.points.size() == 1);
  CHECK(special.equilibria.points[0].is_exact);
  CHECK(special.equilibria.points[0].coordinates[0].closed_form);
}

TEST_CASE("a null direction of two coupled coordinates leaves stability and completeness open") {
  const std::string both = coordinate("x", "[-1, 1]") + coordinate("y", "[-1, 1]");
  const Analysed found = analyse_model(potential_model(both, "(y - x^2)^2 - x^6"));
  REQUIRE(found.equilibria.points.size() == 1);
  CHECK(value(found.equilibria.points[0], 0) == 0);
  CHECK(found.equilibria.points[0].stability.kind == Stability::undecided);
  CHECK(found.equilibria.completeness == Completeness::undecided);
}

TEST_CASE("double roots are exact at simple numbers, and undecided elsewhere") {
  const Analysed exact = analyse_model(potential_model(coordinate("x", "[-1, 1]"), "x^4"));
  REQUIRE(exact.equilibria.points.size() == 1);
  CHECK(exact.equilibria.completeness == Completeness::proved);
  CHECK(exact.equilibria.points[0].stability.kind == Stability::degenerate_minimum);
  CHECK(exact.equilibria.points[0].stability.leading->order == 4);
  const Analysed inflection = analyse_model(potential_model(coordinate("x", "[-1, 1]"), "x^3"));
  REQUIRE(inflection.equilibria.points.size() == 1);
  CHECK(inflection.equilibria.points[0].stability.kind == Stability::undecided);
  // V' = (x - 0.3)^2 (x^2 + 1) has a double zero at 0.3, which is not among the simple numbers.
  const Analysed open = analyse_model(potential_model(
      coordinate("x", "[-1, 1]"), "1/5*x^5 - 0.15*x^4 + 1.09/3*x^3 - 0.3*x^2 + 0.09*x"));
  CHECK(open.equilibria.completeness == Completeness::undecided);
  REQUIRE(open.equilibria.undecided_boxes.size() == 1);
  const Interval& sides = open.equilibria.undecided_boxes[0].at(0);
  CHECK(to_double(sides.low) == Approx(0.3).margin(1e-5));
  CHECK(to_double(sides.high) == Approx(0.3).margin(1e-5));
}

TEST_CASE("a line of equilibria that cannot be listed is reported as undecided near a box") {
  // F = -m g holds the load at theta = 0 with any l; at theta = 0 the force on l has a double zero.
  // The equilibria of the second potential are the line x = y.
  const std::string load = R"toml(format = 1
[model]
name = "hang"
[[coordinate]]
name = "l"
range = [0.5, 5]
[[coordinate]]
name = "theta"
[parameters]
m = 20
g = 9.81
[gravity]
vector = ["0", "-g"]
[[point]]
name = "load"
at = ["l*sin(theta)", "-l*cos(theta)"]
mass = "m"
[[input]]
name = "F"
on = "l"
)toml";
  const std::string both = coordinate("x", "[-1, 1]") + coordinate("y", "[-1, 1]");
  for (const Analysed& found :
       {analyse_model(load, {.laws = {"F=-196.2"}, .boxes = 5000}),
        analyse_model(potential_model(both, "(x - y)^4 + (x - y)^2"), {.boxes = 5000})}) {
    CHECK(found.equilibria.completeness != Completeness::proved);
    REQUIRE(found.equilibria.undecided_boxes.size() == 1);
    const std::string text = text_of(equilibria_page(found.checked, found.equilibria));
    INFO(text);
    CHECK(mentions(text, "undecided near "));
    CHECK_FALSE(mentions(text, "no equilibrium was found"));
  }
  const Analysed held = analyse_model(load, {.laws = {"F=-196.2"}, .boxes = 5000});
  const UndecidedBox& box = held.equilibria.undecided_boxes.front();
  CHECK(to_double(box.at(0).low) == Approx(0.5));
  CHECK(to_double(box.at(0).high) == Approx(5));
  CHECK(std::abs(to_double(box.at(1).low)) < 0.1);
  CHECK(std::abs(to_double(box.at(1).high)) < 0.1);
}

TEST_CASE("no completeness is claimed if the limit of boxes ends the search") {
  const Analysed found = analyse_model(model_file("two_link_arm"), {.boxes = 5});
  CHECK(found.equilibria.completeness == Completeness::searched);
  CHECK(found.equilibria.boxes == 5);
  CHECK(mentions(text_of(equilibria_page(found.checked, found.equilibria)),
                 "; the limit boxes=5 ended the search: raise it with --limit boxes=N"));
}

TEST_CASE("the default limit of enclosures follows from the limit of seconds") {
  CHECK(Limits{}.enclosures == 60 * enclosures_per_second);
  CHECK(Limits{.seconds = 7}.enclosures == 7 * enclosures_per_second);
}

TEST_CASE("equilibria need a range, and no time or kinks in the equations") {
  const auto code = [](const std::string& text) {
    const Products products = analysed_products(text);
    CHECK_FALSE(products.equilibria);
    for (const Diagnostic& diagnostic : products.diagnostics) {
      if (has_errors({diagnostic})) return diagnostic.code;
    }
    return Code::E101;
  };
  CHECK(code(potential_model(coordinate("x"), "x^4 - x")) == Code::E531);
  CHECK(code(potential_model(coordinate("x", "[-1, 1]"), "x^4 - x*sin(t)")) == Code::E530);
  const std::string kinked =
      potential_model(coordinate("x", "[-1, 1]"), "x^2") +
      "[[force]]\nname = \"friction\"\non = \"x\"\nvalue = \"-sign(dot(x))\"\n";
  CHECK(code(kinked) == Code::E530);
}

TEST_CASE("at every equilibrium the bias of the oracle is 0 to 50 digits") {
  for (const char* const name : {"two_link_arm", "elastic_pendulum", "rotating_hoop", "chain"}) {
    const Analysed found = analyse_model(model_file(name));
    INFO(name);
    CHECK_FALSE(found.equilibria.points.empty());
    for (const RestPoint& point : found.equilibria.points) {
      const OracleValues bias =
          oracle_values(found.checked.model, {.kind = OutputKind::bias}, point.state);
      REQUIRE(bias);
      for (const cln::cl_R& entry : *bias) {
        CHECK(std::abs(to_double(entry)) < 1e-50);
      }
    }
  }
}
