// E512: a written potential that falls as a mass rises.
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

}  // namespace

TEST_CASE("weights and springs pass") {
  CHECK(potential_findings(falling_bob("m*g*y(bob)")).empty());
  CHECK(potential_findings(falling_bob("k*y(bob)^2/2 - m*g*y(bob)")).empty());
  CHECK(potential_findings(falling_bob("-m*g*x(bob)")).empty());
  CHECK(potential_findings(falling_bob("-m*g*cos(th)")).empty());
}

TEST_CASE("a weight of the wrong sign is noted, also through a definition") {
  CHECK(potential_findings(falling_bob("-m*g*y(bob)")) == pushed_up);
  ModelBuilder b = falling_bob("0");
  b.definition("height", "y(bob) + 1").V("-m*g*height");
  CHECK(potential_findings(b) == pushed_up);
}

TEST_CASE("up is against gravity where that is given") {
  ModelBuilder sideways = falling_bob("-m*g*y(bob)");
  CHECK(potential_findings(sideways.gravity({"-g", "0"})).empty());
  ModelBuilder down = falling_bob("m*g*y(bob)");
  CHECK(potential_findings(down.gravity({"0", "g"})) ==
        "E512: gravity pulls along +y\n" + pushed_up);
}

TEST_CASE("gravity along the last axis is noted") {
  CHECK(potential_findings(falling_bob("0").gravity({"0", "g"})) == "E512: gravity pulls along +y");
  CHECK(potential_findings(falling_bob("0").gravity({"0", "-g"})).empty());
  CHECK(potential_findings(falling_bob("0").gravity({"g", "0"})).empty());
  ModelBuilder space;
  space.coordinate("z").parameter("g", "9.81").point("bob", {"0", "0", "z"}, "1");
  CHECK(potential_findings(space.gravity({"0", "0", "g"})) == "E512: gravity pulls along +z");
}

TEST_CASE("gravity on a model of bodies is noted too") {
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
