// E627: friction smoothed by tanh in a linearization.
#include <algorithm>
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::string smoothed_findings(const std::string& force, const std::vector<std::string>& outputs) {
  const CheckedModel checked = checked_model(model_text("slide", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 2
f = 3
[energy]
T = "1/2*m*dot(x)^2"
[[force]]
on = "x"
value = ")toml" + force + "\"\n"));
  Scene scene = checked.scene;
  static const SourcePointer source = make_source("command line", "linearization");
  std::erase_if(scene.outputs, [&](const OutputRequest& output) {
    return std::find(outputs.begin(), outputs.end(), output.name) == outputs.end();
  });
  for (OutputRequest& output : scene.outputs) output.span = {source.get(), 0, 13};
  return text_of(inspect_smoothed({checked.model, scene}));
}

const std::string is_damper = "E627: `linearization` has this friction as a damper near rest";

}  // namespace

TEST_CASE("friction smoothed by tanh is a damper of a linearization that is named") {
  CHECK(smoothed_findings("-f*tanh(dot(x)/0.01)", {"linearization"}) == is_damper);
  CHECK(smoothed_findings("-f*tanh(dot(x)/0.01)", {"mass_matrix", "bias"}).empty());
}

TEST_CASE("dampers, and tanh of positions, are what they are") {
  CHECK(smoothed_findings("-f*dot(x)", {"linearization"}).empty());
  CHECK(smoothed_findings("-f*tanh(x)", {"linearization"}).empty());
}
