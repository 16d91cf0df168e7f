// E508: principal inertias obey the triangle inequality and are not negative.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

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

}  // namespace

TEST_CASE("possible inertias pass: a ball, a plate, a rod, a point") {
  CHECK(inertia_findings({"A", "A", "A", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"1", "2", "3", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"0", "1", "1", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"0", "0", "0", "0", "0", "0"}).empty());
  CHECK(inertia_findings({"A"}).empty());
  CHECK(inertia_findings({}).empty());
}

TEST_CASE("a plate rounded to three digits passes") {
  CHECK(inertia_findings({"0.0833", "0.0833", "0.1667", "0", "0", "0"}).empty());
}

TEST_CASE("impossible inertias are reported with their values") {
  CHECK(inertia_findings({"1", "1", "3", "0", "0", "0"}) ==
        "E508: inertia 1, 1, 3, 0, 0, 0 of `top` belongs to no body");
  CHECK(inertia_findings({"-A"}) == "E508: inertia -1/20 of `top` belongs to no body");
}

TEST_CASE("products of inertia count: principal values 1, 1, 3 in turned axes") {
  CHECK(inertia_findings({"2", "1", "2", "0", "1", "0"}) ==
        "E508: inertia 2, 1, 2, 0, 1, 0 of `top` belongs to no body");
  CHECK(inertia_findings({"2", "2", "2", "0", "1", "0"}).empty());  // principal values 1, 2, 3
}
