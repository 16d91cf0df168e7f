// The derived outputs, their shapes, and the limit on the number of definitions.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "derived.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/specialise.hpp"
#include "model/requests.hpp"
#include "support/links.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Result<EquationsOfMotion> derived(const CheckedModel& checked,
                                  const std::vector<OutputRequest>& outputs,
                                  const Limits& limits = {}) {
  return derive(*formulate(checked.model), outputs, limits);
}

const OutputRequest& request(const CheckedModel& checked, OutputKind kind) {
  for (const OutputRequest& output : checked.scene.outputs) {
    if (output.kind == kind) return output;
  }
  throw std::runtime_error("not an output of this model");
}

/// The number of non-empty fields of the output `kind`. The diagonal of M is an additional field of
/// outputs with pivots.
std::size_t fields_of(OutputKind kind, const Model& model) {
  const std::span<const FieldRow> fields = output_row(kind).fields;
  const auto is_there = [&](const FieldRow& field) {
    return extent_size(model, field.rows) > 0 && extent_size(model, field.columns) > 0;
  };
  const std::size_t more = output_row(kind).gives_pivots ? 1 : 0;
  return more + static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), is_there));
}

}  // namespace

TEST_CASE("every output of the default scene has entries of its shape") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    const CheckedModel checked = checked_model(text);
    const auto equations = derived(checked, checked.scene.outputs);
    REQUIRE(equations);
    std::size_t wanted = 0;
    for (const OutputRequest& output : checked.scene.outputs) {
      if (!output_row(output.kind).is_summary) ++wanted;
    }
    CHECK(equations->outputs.size() == wanted);
    for (const OutputEquations& output : equations->outputs) {
      INFO(output.request.name);
      CHECK(output.fields.size() == fields_of(output.request.kind, checked.model));
      for (const FieldEquations& field : output.fields) {
        CHECK(field.entries.size() == std::size_t{field.rows} * field.columns);
      }
    }
  }
}

TEST_CASE("gravity alone needs no definitions with velocities or accelerations") {
  const CheckedModel checked = checked_model(read_model("chain"));
  const auto equations = derived(checked, {request(checked, OutputKind::gravity)});
  REQUIRE(equations);
  for (const Definition& definition : equations->definitions.list) {
    CHECK_FALSE(definition.leaf_dependence.has_any(Opcode::velocity | Opcode::acceleration));
  }
}

TEST_CASE("terms with a fixed zero disappear from the equations") {
  SceneOptions options;
  options.fixed = {make_source("command line", "g=0")};
  const CheckedModel checked = checked_model(read_model("cart_pole"), options);
  const Lagrangian lagrangian = *specialise(*formulate(checked.model), checked);
  const auto equations = derive(lagrangian, {request(checked, OutputKind::gravity)}, {});
  REQUIRE(equations);
  for (const auto& entry : equations->outputs.front().fields.front().entries) {
    CHECK(entry.is_zero());
  }
}

TEST_CASE("the number of definitions grows linearly along a chain") {
  const auto count = [](int n) {
    const CheckedModel checked =
        checked_model(replaced(read_model("chain"), "n = 3", "n = " + std::to_string(n)));
    const auto equations = derived(checked, {request(checked, OutputKind::inverse_dynamics)});
    REQUIRE(equations);
    return equations->definitions.list.size();
  };
  // Each link adds the same number of definitions, so second differences vanish.
  CHECK(count(30) - count(20) == count(20) - count(10));
}

TEST_CASE("more definitions than the limit are refused with the name of the output") {
  const CheckedModel checked = checked_model(read_model("chain"));
  Limits limits;
  limits.derived_nodes = 10;
  const auto equations = derived(checked, checked.scene.outputs, limits);
  REQUIRE_FALSE(equations);
  CHECK(equations.diagnostics.front().code == Code::E908);
  CHECK(equations.diagnostics.front().message == "`mass_matrix` takes more than 10 derived nodes");
  CHECK(equations.diagnostics.front().hint == "`--limit derived_nodes=N` raises the limit");
}

TEST_CASE("an energy without a value at rest is reported with the output that needs it") {
  const CheckedModel checked = checked_model(model_text("pole", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 2
[energy]
L = "1/2*m*dot(x)^2"
)toml"));
  Lagrangian lagrangian = *formulate(checked.model);
  lagrangian.lagrangian.push_back({1 / lagrangian.symbols.v[0]});
  const auto equations = derive(lagrangian, {request(checked, OutputKind::gravity)}, {});
  REQUIRE_FALSE(equations);
  CHECK(equations.diagnostics.front().code == Code::E313);
}

TEST_CASE(
    "a failed elimination of M is reported with a velocity, only by outputs that solve for M") {
  const auto message = [](const std::string& energy, OutputKind kind) {
    const CheckedModel checked =
        checked_model(model_text("two",
                                 "[[coordinate]]\nname = \"x\"\n[[coordinate]]\nname = \"y\"\n"
                                 "[parameters]\nm = 2\n[energy]\nT = \"" +
                                     energy + "\"\n"));
    const auto equations = derived(checked, {request(checked, kind)});
    return equations ? std::string() : equations.diagnostics.front().message;
  };
  const std::string exchange = "m*dot(x)^2 + m*dot(x)*dot(y)";
  const std::string together = "1/2*(dot(x) + dot(y))^2";
  CHECK(message(exchange, OutputKind::mass_matrix).empty());
  CHECK(message(exchange, OutputKind::forward_dynamics) ==
        "`forward_dynamics` has no value: the rate of `y` alone has no kinetic energy, whatever "
        "the state is");
  CHECK(message(together, OutputKind::forward_dynamics) ==
        "`forward_dynamics` has no value: the mass matrix is singular (`y` has no pivot), whatever "
        "the state is");
}

TEST_CASE("a dump lists definitions, then entries, and is deterministic") {
  const CheckedModel checked = checked_model(read_model("cart_pole"));
  const std::string text = dump(*derived(checked, {request(checked, OutputKind::mass_matrix)}));
  CHECK(mentions(text, "; bob_x\n"));
  CHECK(mentions(text, "mass_matrix (2 x 2) ="));
  CHECK(text == dump(*derived(checked_model(read_model("cart_pole")),
                              {request(checked, OutputKind::mass_matrix)})));
}

TEST_CASE("named intermediates have a kind, frame and axis, independent of other outputs") {
  const CheckedModel checked = checked_model(links_text(3));
  const OutputRequest bias = request(checked, OutputKind::bias);
  const auto told = [&](const std::vector<OutputRequest>& outputs) {
    std::set<std::string> names;
    const auto equations = derived(checked, outputs);
    for (const auto& [symbol, name] : equations->outputs.back().value_names) names.insert(name);
    return names;
  };
  const std::set<std::string> alone = told({bias});
  for (const char* const name : {"motion_f2_x", "moment_f3_z", "inertial_f3_y"}) {
    INFO(name);
    CHECK(alone.contains(name));
  }
  CHECK(told({request(checked, OutputKind::mass_matrix), request(checked, OutputKind::gravity),
              request(checked, OutputKind::inverse_dynamics), bias}) == alone);
}
