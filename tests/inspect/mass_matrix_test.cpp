// Singular mass matrices (E501, E511), and negative masses, kinetic energies and dissipations
// (E523, E524, E525).
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string mass_matrix_findings(const ModelBuilder& b, const Scene& scene = {}) {
  return text_of(inspect_mass_matrix({b.model, scene}));
}

std::string sign_findings(const ModelBuilder& b) {
  Diagnostics found = inspect_mass_matrix({b.model, {}});
  const Diagnostics signs = inspect_signs({b.model, {}});
  found.insert(found.end(), signs.begin(), signs.end());
  return text_of(found);
}

ModelBuilder coupled(const std::string& kinetic) {
  ModelBuilder b;
  b.coordinate("x").coordinate("th").parameter("m", "2").parameter("M", "3").T(kinetic);
  return b;
}

const std::string th_is_negative =
    "E524: M is not positive definite: motions of `th` have negative kinetic energy";

std::string chart_findings(const ModelBuilder& b) { return text_of(inspect_charts({b.model, {}})); }

}  // namespace

TEST_CASE("regular mass matrices pass, even indefinite ones") {
  CHECK(mass_matrix_findings(double_pendulum()).empty());
  ModelBuilder exchange;
  exchange.coordinate("x").coordinate("y").T("x_d*y_d");
  CHECK(mass_matrix_findings(exchange).empty());
}

TEST_CASE("outputs that solve for accelerations need kinetic energy of every single rate") {
  Scene scene;
  OutputRequest request;
  request.kind = OutputKind::forward_dynamics;
  request.name = "forward_dynamics";
  scene.outputs = {request};
  CHECK(mass_matrix_findings(double_pendulum(), scene).empty());
  ModelBuilder b;
  b.coordinate("x").coordinate("y");
  CHECK(mass_matrix_findings(b.T("x_d*y_d + y_d^2"), scene) ==
        "E501: `forward_dynamics` has no value: the rate of `x` alone has no kinetic energy, "
        "whatever the state is");
  CHECK(mass_matrix_findings(b.T("x_d*y_d + y_d^2*(sin(2*x) - 2*sin(x)*cos(x)) + x_d^2"), scene) ==
        "E501: `forward_dynamics` has no value: the rate of `y` alone has no kinetic energy, "
        "whatever the state is");
  CHECK(mass_matrix_findings(b.T("x_d*y_d + y_d^2*(sin(2*x) - 2*sin(x)*cos(x))")).empty());
}

TEST_CASE("a mass whose expression simplifies to zero is reported as missing") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").T("x_d^2/2 + (cosh(x)^2 - sinh(x)^2 - 1)*y_d^2");
  CHECK(mass_matrix_findings(b) == "E501: the rate of `y` has no kinetic energy");
}

TEST_CASE("a coordinate without a mass is reported at its own span") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").T("x_d^2/2 + 0*y_d");
  b.model.velocities[1].span = {nullptr, 7, 8};
  CHECK(mass_matrix_findings(b) == "E501: the rate of `y` has no kinetic energy");
  CHECK(inspect_mass_matrix({b.model, {}})[0].span.begin == 7);
}

TEST_CASE("a null vector is printed as a proportion") {
  ModelBuilder b;
  b.coordinate("x1").coordinate("x2").coordinate("x3").parameter("m", "2").parameter("l", "0.75");
  CHECK(mass_matrix_findings(b.T("m*(x1_d - x2_d)^2 + m*x3_d^2")) ==
        "E501: the motion `x1 : x2 = 1 : 1` has no kinetic energy");
  CHECK(mass_matrix_findings(b.T("m*(x1_d - l*x3_d)^2 + m*x2_d^2")) ==
        "E501: the motion `x1 : x3 = 1 : 4/3` has no kinetic energy");
}

TEST_CASE("two missing masses are two diagnostics") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").coordinate("z").T("y_d^2/2");
  CHECK(mass_matrix_findings(b) ==
        "E501: the rate of `x` has no kinetic energy\n"
        "E501: the rate of `z` has no kinetic energy");
}

TEST_CASE("a null vector that depends on the configuration is reported with the rank") {
  ModelBuilder b;  // a point in the plane has two degrees of freedom, but three coordinates
  b.coordinate("x").coordinate("y").coordinate("th");
  b.point("p", {"x + cos(th)", "y + sin(th)"}, "1");
  const std::string text = mass_matrix_findings(b);
  CHECK(text.find(
            "E501: rank 2 of 3 at every sampled configuration: the motion `x : y : th = 1 : ") ==
        0);
  CHECK(mentions(text, " has no kinetic energy at q = ("));
}

TEST_CASE("a mass that is 0 by default is no mistake, a mass fixed at 0 is") {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "0").T("m*x_d^2/2");
  CHECK(mass_matrix_findings(b).empty());
  Scene scene;
  scene.specialisation.fixed[0] = {0};
  CHECK(mass_matrix_findings(b, scene) == "E501: the rate of `x` has no kinetic energy");
}

TEST_CASE("a negative mass is reported once") {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "2").point("bob", {"x", "0"}, "-m");
  CHECK(sign_findings(b) == "E523: the mass of `bob` is -2");
  ModelBuilder positive;
  positive.coordinate("x").parameter("m", "2").point("bob", {"x", "0"}, "m");
  CHECK(sign_findings(positive).empty());
}

TEST_CASE("M has to be positive definite") {
  CHECK(sign_findings(coupled("1/2*M*x_d^2 + 1/2*m*th_d^2 + 1/2*m*cos(th)*x_d*th_d")).empty());
  CHECK(sign_findings(coupled("1/2*M*x_d^2 - 1/2*m*th_d^2")) == th_is_negative);
  CHECK(sign_findings(coupled("1/2*M*x_d^2 + 1/2*m*th_d^2 + 4*m*x_d*th_d")) == th_is_negative);
}

TEST_CASE("neither a singular chart nor a parameter of value 0 counts as negative") {
  CHECK(sign_findings(coupled("1/2*M*x_d^2 + 1/2*m*sin(th)^2*th_d^2")).empty());
  ModelBuilder zero;
  zero.coordinate("x").parameter("m", "0").point("bob", {"x", "0"}, "m");
  CHECK(sign_findings(zero).empty());
}

TEST_CASE("a negative dissipation D is reported") {
  const std::string kinetic = "1/2*M*x_d^2 + 1/2*m*th_d^2";
  CHECK(sign_findings(coupled(kinetic).D("1/2*m*x_d^2")).empty());
  CHECK(sign_findings(coupled(kinetic).D("-1/2*m*x_d^2")) ==
        "E525: D is negative, so it drives the motion");
}

TEST_CASE("charts without a singular configuration pass") {
  CHECK(chart_findings(pendulum()).empty());
  CHECK(chart_findings(cart_pole()).empty());
  CHECK(chart_findings(double_pendulum()).empty());
}

TEST_CASE("values of a coordinate at which M loses rank are listed") {
  CHECK(chart_findings(spherical_pendulum()) == "E511: the mass matrix loses rank at `th` = 0, pi");
  ModelBuilder polar;
  polar.coordinate("r", "m").coordinate("ph", "rad").T("r_d^2/2 + r^2*ph_d^2/2");
  CHECK(chart_findings(polar) == "E511: the mass matrix loses rank at `r` = 0");
  ModelBuilder latitude;
  latitude.coordinate("la", "rad").coordinate("lo", "rad").T("la_d^2 + cos(la)^2*lo_d^2");
  CHECK(chart_findings(latitude) == "E511: the mass matrix loses rank at `la` = pi/2, -pi/2");
}

TEST_CASE("a range excludes a singular value of a length, but not of an angle") {
  ModelBuilder polar;
  polar.coordinate("r", "m").coordinate("ph", "rad").T("r_d^2/2 + r^2*ph_d^2/2");
  polar.model.coordinates[0].range = Interval{1, 2};
  CHECK(chart_findings(polar).empty());
  ModelBuilder b = spherical_pendulum();
  b.model.coordinates[0].range = Interval{1, 2};
  CHECK(chart_findings(b) == "E511: the mass matrix loses rank at `th` = 0, pi");
}

TEST_CASE("a declared singular factor is reported as written, without a search") {
  ModelBuilder b = spherical_pendulum();
  const SourcePointer source = make_source("model.toml", "singular = \"sin(th)\"");
  const ExpressionId factor = b.expression("sin(th)");
  b.model.expressions[factor].span = {source.get(), 12, 19};
  b.model.coordinates[0].singular_condition = factor;
  CHECK(chart_findings(b) == "E511: the chart of `th` breaks where `sin(th)` is zero");
}
