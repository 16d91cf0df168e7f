// What keeps kick, drift, kick from being symplectic.
#include <catch2/catch.hpp>

#include "elgen/choose.hpp"
#include "elgen/integrate.hpp"
#include "elgen/pipeline.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

std::string obstacle(const std::string& energies) {
  const std::string text = model_text(
      "plane", "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n[energy]\n" + energies);
  PipelineOptions options;
  options.goals = {Goal::choose};
  options.scene.outputs = {make_source("outputs", "mass_matrix, momentum, bias")};
  const Products products = run_pipeline({make_source("plane.toml", text), nullptr}, options);
  return not_separable(*products.checked, *products.program);
}

}  // namespace

TEST_CASE("M is constant, forces and L are free of rates, but for T") {
  const std::string kinetic = "T = \"dot(x)^2 + dot(x)*dot(y) + dot(y)^2\"\n";
  CHECK(obstacle(kinetic + "V = \"x*y + sin(t)*x\"\n").empty());
  CHECK(obstacle("T = \"x^2*dot(x)^2 + dot(y)^2\"\n") == "M depends on `x`");
  CHECK(obstacle("T = \"exp(t)*dot(x)^2 + dot(y)^2\"\n") == "M depends on `t`");
  CHECK(obstacle("L = \"-sqrt(1 - dot(x)^2) + dot(y)^2\"\n") == "M depends on `dot(x)`");
  for (const std::string linear : {"x*dot(y)", "3*dot(y)"}) {
    CHECK(obstacle("L = \"dot(x)^2 + dot(y)^2 + " + linear + "\"\n") ==
          "L has terms linear in the rates");
  }
  CHECK(obstacle(kinetic + "D = \"dot(y)^2\"\n") == "a force depends on `dot(y)`");
}

}  // namespace elgen::test
