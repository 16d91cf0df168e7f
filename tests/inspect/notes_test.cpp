// E522: unused declarations. E619: outputs left out of `full`. E627: friction smoothed by tanh.
#include <algorithm>
#include <catch2/catch.hpp>

#include "inspect/checks.hpp"
#include "inspect/found.hpp"
#include "oracle/samples.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A mass on a spring. Its parameter arrays are `m` (one element) and `k` (two elements).
ModelBuilder spring(const std::string& potential) {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "1").parameter("k1", "2").parameter("k2", "3");
  b.T("m*x_d^2/2").V(potential);
  b.model.parameter_arrays = {{.name = "m", .first = 0}, {.name = "k", .first = 1, .count = 2}};
  return b;
}

std::string unused_findings(const Model& model) {
  return text_of(inspect_unused_names({model, {}}));
}

Diagnostics left_out_notes(const std::vector<OmittedOutputs>& left_out) {
  Scene scene;
  scene.omitted_outputs = left_out;
  return inspect_omissions({Model{}, scene});
}

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
  return text_of(inspect_smoothed_friction({checked.model, scene}));
}

const std::string is_damper = "E627: `linearization` contains this friction as a damper near rest";

}  // namespace

TEST_CASE("an array is used if one of its elements is") {
  CHECK(unused_findings(spring("k2*x^2").model).empty());
  CHECK(unused_findings(spring("x^2").model) == "E522: parameter `k` is used nowhere");
}

TEST_CASE("an input must act on a velocity or occur in a force") {
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

TEST_CASE("a parameter that only a locked model lacks counts as used") {
  Model locked = spring("x^2").model;
  locked.reduction.unreduced = std::make_shared<const Model>(spring("k1*x^2").model);
  CHECK(unused_findings(locked).empty());
}

TEST_CASE("no notes if no outputs are left out") { CHECK(left_out_notes({}).empty()); }

TEST_CASE("one note per reason names the outputs and how to get them") {
  const SourcePointer source = make_source("a.toml", "name = \"a\" abs(x)");
  const Diagnostics notes = left_out_notes(
      {{OmissionReason::too_many_entries, {"mass_matrix", "tip"}, {source.get(), 7, 10}},
       {OmissionReason::kinked_force, {"linearization"}, {source.get(), 11, 17}}});
  CHECK(text_of(notes) ==
        "E619: not emitted because of more than 4096 entries: `mass_matrix`, `tip`\n"
        "E619: not emitted because a force with a kink has no derivatives: `linearization`");
  CHECK(notes[0].hint == "name the output in a scene or in `--outputs`");
  CHECK(notes[1].hint == "use a smooth approximation: `tanh(x/width)` for `sign(x)`");
  CHECK(covered_text(notes[0].span) == "\"a\"");
  CHECK(covered_text(notes[1].span) == "abs(x)");
}

TEST_CASE("friction smoothed by tanh becomes a damper in a requested linearization") {
  CHECK(smoothed_findings("-f*tanh(dot(x)/0.01)", {"linearization"}) == is_damper);
  CHECK(smoothed_findings("-f*tanh(dot(x)/0.01)", {"mass_matrix", "bias"}).empty());
}

TEST_CASE("linear dampers and tanh of positions get no note") {
  CHECK(smoothed_findings("-f*dot(x)", {"linearization"}).empty());
  CHECK(smoothed_findings("-f*tanh(x)", {"linearization"}).empty());
}
