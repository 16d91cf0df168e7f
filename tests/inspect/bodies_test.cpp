// E508: principal inertias must be non-negative and obey the triangle inequality. E507: a planar
// spin must be the rate of an angle(q, t).
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string inertia_findings(const std::vector<std::string>& inertia) {
  ModelBuilder b;
  b.parameter("A", "0.05");
  Body body;
  body.name = "top";
  for (const std::string& entry : inertia) body.inertia.push_back(b.expression(entry));
  b.model.bodies.push_back(body);
  return text_of(inspect_inertias({b.model, {}}));
}

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

TEST_CASE("possible inertias of a ball, a plate, a rod and a point pass") {
  CHECK(inertia_findings({"A", "A", "A", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"1", "2", "3", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"0", "1", "1", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"0", "0", "0", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"A"}).empty());
  CHECK(inertia_findings({}).empty());
}

TEST_CASE("a plate's inertia rounded to three digits passes, to two digits it does not") {
  CHECK(inertia_findings({"0.0833", "0.0833", "0.1667", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"1", "1", "2.001", "0", "0", "0"}).empty());
  CHECK_FALSE(inertia_findings({"1", "1", "2.01", "0", "0", "0"}).empty());
}

TEST_CASE("impossible inertias are reported with their values") {
  CHECK(inertia_findings({"1", "1", "3", "0", "0", "0"}) ==
        "E508: inertia 1, 1, 3, 0, 0, 0 of `top` belongs to no body");
  CHECK_FALSE(inertia_findings({"-1", "1", "1", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"-A"}) == "E508: inertia -0.05 of `top` belongs to no body");
  CHECK(inertia_findings({"16616.493", "14.9", "7.123456", "0", "0", "0"}) ==
        "E508: inertia 16616.493, 14.9, 7.123456, 0, 0, 0 of `top` belongs to no body");
}

TEST_CASE("products of inertia count: principal values 1, 1, 3 in rotated axes") {
  CHECK(inertia_findings({"2", "1", "2", "0", "1", "0"}) ==
        "E508: inertia 2, 1, 2, 0, 1, 0 of `top` belongs to no body");
  CHECK(inertia_findings({"2", "2", "2", "0", "1", "0"}).empty());  // principal values 1, 2, 3
}

TEST_CASE("spins that are rates of angles pass") {
  CHECK(spin_findings("th_d").empty());
  CHECK(spin_findings("x_d/r - 2*th_d").empty());
  CHECK(spin_findings("cos(x)*x_d*th + sin(x)*th_d").empty());
  CHECK(spin_findings("th_d*t + th").empty());
  CHECK(spin_findings("ddt(atan(x*th)) + 3*t^2").empty());
}

TEST_CASE("a spin with a curl in space or time is found") {
  const std::string refused = "E507: spin of `wheel` is the rate of no angle";
  CHECK(spin_findings("x*th_d") == refused);
  CHECK(spin_findings("x_d*cos(th)") == refused);
  CHECK(spin_findings("th_d*t") == refused);
  CHECK(spin_findings("th") == refused);
}

TEST_CASE("a spatial spin need not be a rate") { CHECK(spin_findings("x*th_d", 3).empty()); }

TEST_CASE("spins of bodies in nested frames follow from the frames", "[frames]") {
  const CheckedModel planar = checked_model(read_model("planar"));
  CHECK(text_of(inspect_spins({planar.model, planar.scene})).empty());
}
