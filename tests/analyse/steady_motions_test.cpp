// Steady motions: equilibria of the model that remains if [routh] removes cyclic coordinates.
#include <catch2/catch.hpp>
#include <cmath>

#include "analyse/found.hpp"
#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Products steady_products_of(const std::string& text, const std::string& routh,
                            const std::string& at = {}) {
  Products products = modes_products(inputs_of(text, "[routh]\n" + routh), at);
  INFO(format(products.diagnostics));
  REQUIRE(products.modes);
  REQUIRE(products.modes->motions.size() == 1);
  return products;
}

Products steady_products(const std::string& model, const std::string& routh) {
  return steady_products_of(model_file(model), routh);
}

double omega_squared(const Products& products) {
  REQUIRE(products.modes->motions.front().modes.size() == 1);
  return to_double(products.modes->motions.front().modes[0].omega_squared);
}

double rest_coordinate(const Products& products) {
  return to_double(products.modes->motions.front().point.state.q.at(0));
}

std::string steady_page(const Products& products) {
  return screen_page(modes_page(*products.checked, *products.modes), {100, Alphabet::unicode});
}

}  // namespace

TEST_CASE("circular Kepler orbit: r = p^2/(m^2 mu), and nearby orbits close") {
  const Products orbit = steady_products("kepler_polar", "phi = true\n");
  CHECK(rest_coordinate(orbit) == Approx(1.44).epsilon(1e-14));
  CHECK(orbit.modes->motions.front().point.coordinates[0].closed_form);
  CHECK(omega_squared(orbit) == Approx(std::pow(0.5, 6) / std::pow(0.6, 6)).epsilon(1e-14));
  const std::string text = steady_page(orbit);
  INFO(text);
  CHECK(text.starts_with("Kepler problem in polar coordinates, p_φ = 0.6 N m s: normal modes at"));
  CHECK(mentions(text, "0.334898"));
  CHECK(mentions(text, "= 0.578704 rad/s, with the period of the mode: the orbits close\n"));
}

TEST_CASE("a heavy top precesses steadily") {
  const Products top = steady_products("heavy_top", "phi = true\npsi = true\n");
  CHECK(rest_coordinate(top) == Approx(0.487368).epsilon(1e-6));
  CHECK(omega_squared(top) == Approx(1518.19).epsilon(1e-5));
  const std::string text = steady_page(top);
  INFO(text);
  CHECK(text.starts_with("Heavy symmetric top, p_φ = 1.80896 N m s, p_ψ = 2.0351 N m s: normal"));
  CHECK(mentions(text, "= 0.985147 rad/s, "));
  CHECK(mentions(text, "= 100.885 rad/s\n"));
}

TEST_CASE("the heading names the requested point, even if every value is an equilibrium") {
  const std::string gimbal = R"(format = 1
[model]
name = "gimbal"
[[coordinate]]
name = "alpha"
unit = "rad"
[[coordinate]]
name = "beta"
unit = "rad"
start = { value = 0.3 }
[[coordinate]]
name = "gamma"
unit = "rad"
start = { rate = 100 }
[parameters]
A = { value = 0.02, unit = "kg*m^2" }
B = { value = 0.015, unit = "kg*m^2" }
C = { value = 0.008, unit = "kg*m^2" }
[energy]
T = "1/2*(A + B*cos(beta)^2)*dot(alpha)^2 + 1/2*B*dot(beta)^2 + 1/2*C*(dot(gamma) + dot(alpha)*cos(beta))^2"
)";
  const auto heading = [&](const std::string& at) {
    const std::string text = steady_page(steady_products_of(gimbal, "gamma = \"0.8\"\n", at));
    return text.substr(0, text.find('\n'));
  };
  CHECK(mentions(heading("beta=pi/2"), "linearised equations at α = 0, β = ½ π ("));
  CHECK(mentions(heading("beta=0.5"), "linearised equations at α = 0, β = 0.5 ("));
  CHECK(mentions(heading("alpha=-0.25,beta=pi"), "linearised equations at α = -0.25, β = π ("));
}
