// E512: V or [gravity] pushes a mass up. E526: V and [gravity] both contain the weight of a point.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

ModelBuilder falling_bob(const std::string& potential, const std::string& mass = "m") {
  ModelBuilder b;
  b.coordinate("th").parameter("m", "2").parameter("g", "9.81").parameter("k", "3");
  b.point("bob", {"sin(th)", "-cos(th)"}, mass).V(potential);
  return b;
}

std::string potential_findings(const ModelBuilder& b) {
  return text_of(inspect_potential({b.model, {}}));
}

const std::string pushed_up = "E512: V falls as `bob` rises";

ModelBuilder weighed(const std::string& potential, const std::vector<std::string>& gravity) {
  ModelBuilder b;
  b.coordinate("th").parameter("m", "2").parameter("g", "9.81").parameter("k", "3");
  b.parameter("m2", "1");
  b.point("bob", {"sin(th)", "-cos(th)"}, "m").point("hook", {"th", "2*sin(th)"}, "m2");
  if (!gravity.empty()) b.gravity(gravity);
  b.V(potential);
  return b;
}

std::string weight_findings(const std::string& potential,
                            const std::vector<std::string>& gravity = {"0", "-g"}) {
  return text_of(inspect_weights({weighed(potential, gravity).model, {}}));
}

const std::string bob_is_twice =
    "E526: V contains the weight of `bob`, which [gravity] adds already";

}  // namespace

TEST_CASE("weights and springs pass") {
  CHECK(potential_findings(falling_bob("m*g*y(bob)")).empty());
  CHECK(potential_findings(falling_bob("k*y(bob)^2/2 - m*g*y(bob)")).empty());
  CHECK(potential_findings(falling_bob("-m*g*x(bob)")).empty());
  CHECK(potential_findings(falling_bob("-m*g*cos(th)")).empty());
}

TEST_CASE("a weight of the wrong sign is noted, even through a definition") {
  CHECK(potential_findings(falling_bob("-m*g*y(bob)")) == pushed_up);
  ModelBuilder b = falling_bob("0");
  b.definition("height", "y(bob) + 1").V("-m*g*height");
  CHECK(potential_findings(b) == pushed_up);
}

TEST_CASE("if gravity is given, up is the opposite direction") {
  ModelBuilder sideways = falling_bob("-m*g*y(bob)");
  CHECK(potential_findings(sideways.gravity({"-g", "0"})).empty());
  ModelBuilder down = falling_bob("m*g*y(bob)");
  CHECK(potential_findings(down.gravity({"0", "g"})) ==
        "E512: gravity pulls along +y\n" + pushed_up);
}

TEST_CASE("gravity along the positive last axis is noted") {
  CHECK(potential_findings(falling_bob("0").gravity({"0", "g"})) == "E512: gravity pulls along +y");
  CHECK(potential_findings(falling_bob("0").gravity({"0", "-g"})).empty());
  CHECK(potential_findings(falling_bob("0").gravity({"g", "0"})).empty());
  ModelBuilder space;
  space.coordinate("z").parameter("g", "9.81").point("bob", {"0", "0", "z"}, "1");
  CHECK(potential_findings(space.gravity({"0", "0", "g"})) == "E512: gravity pulls along +z");
}

TEST_CASE("gravity of the wrong sign is noted for bodies too") {
  const auto of_body = [](std::uint32_t dimension, const std::vector<std::string>& gravity) {
    ModelBuilder b;
    b.coordinate("z").parameter("g", "9.81");
    Body body;
    body.name = "ship";
    body.dimension = dimension;
    b.model.bodies.push_back(body);
    return potential_findings(b.gravity(gravity));
  };
  CHECK(of_body(3, {"0", "0", "g"}) == "E512: gravity pulls along +z");
  CHECK(of_body(3, {"0", "0", "-g"}).empty());
  CHECK(of_body(2, {"0", "g"}) == "E512: gravity pulls along +y");
}

TEST_CASE("a point without a mass has no weight") {
  CHECK(potential_findings(falling_bob("-k*y(bob)", "")).empty());
  ModelBuilder b = falling_bob("-m*g*y(bob)", "");
  CHECK(potential_findings(b.T("m*(ddt(x(bob))^2 + ddt(y(bob))^2)/2")) == pushed_up);
}

TEST_CASE("a weight in both V and [gravity] is found among other terms") {
  CHECK(weight_findings("-m*g*cos(th)") == bob_is_twice);
  CHECK(weight_findings("m*g*(1 - cos(th)) + 1/2*k*th^2") == bob_is_twice);
  CHECK(weight_findings("m*g*y(bob) + m2*g*y(hook)") == bob_is_twice);
  CHECK(weight_findings("m2*g*y(hook) + 7*m*th^2") ==
        "E526: V contains the weight of `hook`, which [gravity] adds already");
  CHECK(weight_findings("9.81*(m*y(bob) + m2*y(hook))", {"0", "-9.81"}) == bob_is_twice);
}

TEST_CASE("other potentials pass") {
  CHECK(weight_findings("-m*g*cos(th)", {}).empty());
  CHECK(weight_findings("1/2*k*th^2").empty());
  CHECK(weight_findings("1/2*m*k*th^2").empty());
  CHECK(weight_findings("m*g*th").empty());
  CHECK(weight_findings("k*g*cos(th)").empty());
  CHECK(weight_findings("0").empty());
}
