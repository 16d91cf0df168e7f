// E526: weights that stand in [gravity] and in V.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

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

const std::string bob_is_twice = "E526: V holds the weight of `bob`, which [gravity] gives it too";

}  // namespace

TEST_CASE("a weight in V and in gravity is given twice, whatever stands beside it") {
  CHECK(weight_findings("-m*g*cos(th)") == bob_is_twice);
  CHECK(weight_findings("m*g*(1 - cos(th)) + 1/2*k*th^2") == bob_is_twice);
  CHECK(weight_findings("m*g*y(bob) + m2*g*y(hook)") == bob_is_twice);
  CHECK(weight_findings("m2*g*y(hook) + 7*m*th^2") ==
        "E526: V holds the weight of `hook`, which [gravity] gives it too");
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
