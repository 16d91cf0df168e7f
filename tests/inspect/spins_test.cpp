// E507: a planar spin has to be the rate of an angle(q, t).
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"
#include "support/arms.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string spin_findings(const std::string& spin, std::uint32_t dimension = 2) {
  ModelBuilder b;
  b.coordinate("x").coordinate("th").parameter("r", "0.3");
  Body body;
  body.name = "wheel";
  body.dimension = dimension;
  body.inertia = {b.expression("1")};
  body.spin = {b.expression(spin)};
  b.model.bodies.push_back(body);
  return text_of(inspect_spins({b.model, {}}));
}

}  // namespace

TEST_CASE("rates of angles pass") {
  CHECK(spin_findings("th_d").empty());
  CHECK(spin_findings("x_d/r - 2*th_d").empty());
  CHECK(spin_findings("cos(x)*x_d*th + sin(x)*th_d").empty());
  CHECK(spin_findings("th_d*t + th").empty());
  CHECK(spin_findings("ddt(atan(x*th)) + 3*t^2").empty());
}

TEST_CASE("a curl in space or in time is found") {
  const std::string refused = "E507: spin of `wheel` is the rate of no angle";
  CHECK(spin_findings("x*th_d") == refused);
  CHECK(spin_findings("x_d*cos(th)") == refused);
  CHECK(spin_findings("th_d*t") == refused);
  CHECK(spin_findings("th") == refused);
}

TEST_CASE("in space a spin need not be a rate") { CHECK(spin_findings("x*th_d", 3).empty()); }

TEST_CASE("spins of bodies in nested frames follow from the frames", "[frames]") {
  const CheckedModel planar = checked_model(planar_text());
  CHECK(text_of(inspect_spins({planar.model, planar.scene})).empty());
}
