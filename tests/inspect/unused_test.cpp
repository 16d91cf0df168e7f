// E522: what is declared and never used.
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A mass on a spring; its parameters are arrays of one, or the two of `k`.
ModelBuilder spring(const std::string& potential) {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "1").parameter("k1", "2").parameter("k2", "3");
  b.T("m*x_d^2/2").V(potential);
  b.model.parameter_arrays = {{.name = "m", .first = 0}, {.name = "k", .first = 1, .count = 2}};
  return b;
}

std::string unused_findings(const Model& model) { return text_of(inspect_unused({model, {}})); }

}  // namespace

TEST_CASE("one used element of an array is enough") {
  CHECK(unused_findings(spring("k2*x^2").model).empty());
  CHECK(unused_findings(spring("x^2").model) == "E522: parameter `k` is used nowhere");
}

TEST_CASE("an input acts on a velocity, or stands in a force") {
  ModelBuilder nowhere = spring("k1*x");
  nowhere.input("u");
  CHECK(unused_findings(nowhere.model) == "E522: input `u` acts on nothing");
  ModelBuilder acts = spring("k1*x");
  acts.input("u", 0);
  CHECK(unused_findings(acts.model).empty());
  ModelBuilder named = spring("k1*x");
  named.input("u").force_on(0, "2*u");
  CHECK(unused_findings(named.model).empty());
}

TEST_CASE("what a lock takes out of the equations was used") {
  Model locked = spring("x^2").model;
  locked.unlocked = std::make_shared<const Model>(spring("k1*x^2").model);
  CHECK(unused_findings(locked).empty());
}
