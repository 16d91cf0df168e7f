// Requests: availability, shapes and names of outputs.
#include "model/requests.hpp"

#include <catch2/catch.hpp>
#include <utility>

#include "check/check_testing.hpp"

namespace elgen::test {
namespace {

const std::string with_output = block(R"toml([[input]]
name = "u"
unit = "N"
on = "x"
[[output]]
name = "tip"
value = ["x", "2*x"]
jacobian = true
[[output]]
name = "place"
value = "x"
)toml");

std::vector<std::string> names_in_full(const std::string& model) {
  std::vector<std::string> names;
  for (const OutputRequest& request : checked(model).scene.outputs) {
    names.push_back(request.name);
  }
  return names;
}

/// One line per reason, such as "too many entries: mass_matrix, linearization".
std::string left_out(const CheckedModel& checked) {
  std::string lines;
  for (const OmittedOutputs& reason : checked.scene.omitted_outputs) {
    std::string names;
    for (const std::string& output : reason.outputs) names += (names.empty() ? "" : ", ") + output;
    lines += std::string(name_of(reason.reason)) + ": " + names + "\n";
  }
  return lines;
}

const std::string without_derivatives =
    "kinked force: linearization, inverse_dynamics_derivatives, forward_dynamics_derivatives\n";

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_CASE("full contains every output of the model") {
  const std::vector<std::string> all = names_in_full(with_output);
  CHECK(all.front() == "mass_matrix");
  CHECK(all.back() == "dynamics");
  for (const char* name : {"input_matrix", "tip", "place", "tip_jacobian", "tip_bias", "gravity"}) {
    CHECK(has(all, name));
  }
  CHECK_FALSE(has(all, "place_jacobian"));
  for (const char* name : {"hamiltonian", "velocities_of_momenta", "hamilton_equations", "step"}) {
    CHECK_FALSE(has(all, name));
  }
  CHECK_FALSE(has(names_in_full(block()), "input_matrix"));
}

TEST_CASE("outputs of a Lagrangian that is not quadratic, or not split into T and V") {
  const std::string head =
      "format = 1\n[model]\nname = \"a\"\n[[coordinate]]\nname = \"x\"\n"
      "unit = \"m\"\n[parameters]\nm = { value = 1, unit = \"kg\" }\n"
      "c = { value = 1, unit = \"m/s\" }\n[energy]\n";
  const std::string relativistic = head + "L = \"-m*c^2*sqrt(1 - dot(x)^2/c^2)\"\n";
  const std::vector<std::string> some = names_in_full(relativistic);
  for (const char* name : {"mass_matrix", "bias", "momentum", "energy_function"}) {
    CHECK(has(some, name));
  }
  for (const char* name : {"coriolis_matrix", "velocity_force", "gravity", "drift",
                           "kinetic_energy", "potential_energy", "total_energy"}) {
    CHECK_FALSE(has(some, name));
  }
  CheckOptions wanted;
  wanted.outputs = {"gravity"};
  CHECK(messages(relativistic, wanted) ==
        "E505 1:1 `gravity` needs a Lagrangian at most quadratic in the rates\n");
  wanted.outputs = {"hamilton_equations"};
  CHECK(
      messages(relativistic, wanted) ==
      "E534 1:1 `hamilton_equations` needs rates that p = dL/dv gives by a linear solve, and L is "
      "not quadratic in the rates\n");
  // L is quadratic, but not split into T and V.
  const std::string whole = head + "L = \"m*dot(x)^2\"\n";
  CHECK(has(names_in_full(whole), "gravity"));
  wanted.outputs = {"total_energy"};
  CHECK(messages(whole, wanted) ==
        "E603 1:1 `total_energy` needs T and V separately, but the model gives L\n");
}

TEST_CASE("shapes follow the dimensions") {
  const CheckedModel model = checked(with_output);
  const auto shape = [&](const char* name) {
    const auto request = find_request(model.model, name);
    REQUIRE(request);
    return std::pair(request->rows, request->columns);
  };
  CHECK(shape("mass_matrix") == std::pair(1U, 1U));
  CHECK(shape("input_matrix") == std::pair(1U, 1U));
  CHECK(shape("tip") == std::pair(2U, 1U));
  CHECK(shape("tip_jacobian") == std::pair(2U, 1U));
  CHECK(shape("tip_bias") == std::pair(2U, 1U));
  CHECK(shape("forward_dynamics") == std::pair(1U, 1U));
  CHECK(find_request(model.model, "tip")->kind == OutputKind::user_value);
  CHECK(find_request(model.model, "tip_jacobian")->kind == OutputKind::user_jacobian);
  CHECK(find_request(model.model, "tip_bias")->kind == OutputKind::user_bias);
  CHECK(find_request(model.model, "bias")->kind == OutputKind::bias);
  CHECK_FALSE(find_request(model.model, "tipp"));
}

TEST_CASE("the requests of a scene are found by name") {
  const CheckedModel model = checked(with_output);
  REQUIRE(find_request(model.scene, "tip_bias") != nullptr);
  CHECK(find_request(model.scene, "tip_bias")->kind == OutputKind::user_bias);
  CHECK(find_request(model.scene, "nothing") == nullptr);
}

TEST_CASE("unknown and unavailable outputs are errors") {
  const Rows rows{
      {"mass_matrx", "E601 1:1 unknown output `mass_matrx` | did you mean `mass_matrix`?\n"},
      {"M", "E601 1:1 unknown output `M` | `M` is `mass_matrix`\n"},
      {"a", "E601 1:1 unknown output `a` | `a` is `forward_dynamics`\n"},
      {"V", "E601 1:1 unknown output `V` | `V` is `potential_energy`\n"},
      {"J", "E601 1:1 unknown output `J`\n"},
      {"eom", "E601 1:1 unknown output `eom`\n"},
      {"bias, tp", "E601 1:7 unknown output `tp` | did you mean `tip`?\n"},
      {"cyclic_rates", "E603 1:1 `cyclic_rates` needs a coordinate in `[routh]`\n"},
      {"reaction", "E603 1:1 `reaction` needs `reaction = true` in an entry of `[lock]`\n"},
      {"place_jacobian",
       "E603 1:1 `place_jacobian` needs `jacobian = true` in the output's entry\n"},
  };
  check_rows(rows, [&](const std::string& outputs) {
    return messages(with_output, {.outputs = {outputs}});
  });
  CHECK(messages(block(), {.outputs = {"input_matrix"}}) ==
        "E603 1:1 `input_matrix` needs inputs, but the model has none\n");
}

TEST_CASE("forces with kinks have no derivatives, and full omits the derivatives") {
  const std::string model = block() + "[[force]]\non = \"x\"\nvalue = \"-k*abs(x)\"\n";
  CHECK(has(names_in_full(block()), "linearization"));
  CHECK_FALSE(has(names_in_full(model), "linearization"));
  CHECK(has(names_in_full(model), "forward_dynamics"));
  CHECK(messages(model, {.outputs = {"forward_dynamics_derivatives"}}) ==
        "E603 1:1 `forward_dynamics_derivatives` needs forces with derivatives, but `abs`, `sign`, "
        "`min` and `max` have none; a smooth approximation is tanh(x/width)\n");
  const CheckedModel kinked = checked(model);
  CHECK(left_out(kinked) == without_derivatives);
  CHECK(covered_text(kinked.scene.omitted_outputs.front().span) == "abs(x)");
}

TEST_CASE("outputs that do not apply to a model are not listed as left out") {
  CHECK(left_out(checked(with_output)).empty());
  CHECK(left_out(checked(block())).empty());
}

TEST_CASE("kinks prevent derivatives only in forces that act on moving coordinates") {
  const std::string unused = block("[define]\nkinked = \"abs(x)\"\n");
  CHECK(has(names_in_full(unused), "linearization"));
  const std::string force = "[[force]]\non = \"x\"\nvalue = \"-k*kinked\"\n";
  CHECK_FALSE(has(names_in_full(unused + force), "linearization"));
  const std::string two =
      unused + "[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"m\"\n" + force;
  CHECK_FALSE(has(names_in_full(two), "linearization"));
  CheckOptions wanted;
  wanted.scene =
      "format = 1\nmodel = \"block.toml\"\nname = \"held\"\n"
      "[lock]\nx = { value = 0 }\n[outputs]\nlinearization = true\n";
  CHECK(messages(two, wanted).empty());
  wanted.scene += "[approximate]\norder = 1\nabout = { y = 0 }\n";
  CHECK(messages(two, wanted).empty());
}

std::string masses(int count) {
  return "format = 1\n[model]\nname = \"a\"\n[sizes]\nn = " + std::to_string(count) +
         "\n[[coordinate]]\nfor = \"i in 1..n\"\nname = \"x[i]\"\n[energy]\n"
         "T = \"sum(i, 1, n, dot(x[i])^2)\"\n";
}

TEST_CASE("large outputs are left out of full, each above its own size limit") {
  CHECK(left_out(checked(masses(32))).empty());
  CHECK(left_out(checked(masses(33))) == "too many entries: linearization\n");
  CHECK(left_out(checked(masses(64))) == "too many entries: linearization\n");
  const CheckedModel big = checked(masses(65));
  CHECK(left_out(big) ==
        "too many entries: mass_matrix, coriolis_matrix, linearization, "
        "inverse_dynamics_derivatives, forward_dynamics_derivatives\n");
  CHECK(covered_text(big.scene.omitted_outputs.front().span) == "a");
  CHECK(big.scene.outputs.front().name == "velocity_force");
}

TEST_CASE("a scene or an option that names a large output gets it") {
  const CheckedModel by_scene = checked(
      masses(65),
      {.scene = "format = 1\nmodel = \"a.toml\"\nname = \"b\"\n[outputs]\nlinearization = true\n"});
  REQUIRE(by_scene.scene.outputs.size() == 1);
  CHECK(by_scene.scene.outputs.front().rows == 130);
  CHECK(by_scene.scene.omitted_outputs.empty());
  CheckOptions option;
  option.outputs = {"mass_matrix"};
  const CheckedModel by_option = checked(masses(65), option);
  CHECK(by_option.scene.outputs.front().rows == 65);
  CHECK(by_option.scene.omitted_outputs.empty());
  option.outputs = {"mass_matrx"};
  CHECK_THAT(
      messages(masses(65), option),
      Catch::EndsWith("E601 1:1 unknown output `mass_matrx` | did you mean `mass_matrix`?\n"));
}

TEST_CASE("a scene without a list of outputs omits the same outputs as full") {
  CHECK(left_out(checked(
            masses(2),
            {.scene = "format = 1\nmodel = \"a.toml\"\nname = \"b\"\n[sizes]\nn = 33\n"})) ==
        "too many entries: linearization\n");
}

TEST_CASE("each output is listed once, and derivatives missing for two reasons under the kink") {
  const std::string kinked = masses(65) + "[[force]]\non = \"x[2]\"\nvalue = \"-sign(x[1])\"\n";
  CHECK(left_out(checked(kinked)) ==
        "too many entries: mass_matrix, coriolis_matrix\n" + without_derivatives);
}

}  // namespace
}  // namespace elgen::test
