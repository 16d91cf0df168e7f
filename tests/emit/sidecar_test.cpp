// SPDX-License-Identifier: GPL-3.0-or-later
// sidecar: the JSON is valid, has the keys in order, and says what the program does.
#include <nlohmann/json.hpp>

#include "emit/pages/page_artifacts.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;
using elgen::testing::Subject;
using Json = nlohmann::ordered_json;

namespace {

std::string text_of(const Subject& subject) {
  return sidecar(emission_input(subject.model, subject.scene, subject.program, {subject.program}));
}

}  // namespace

TEST_CASE("one key order") {
  const Json json = Json::parse(text_of(cart_pole()));
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  CHECK(keys == std::vector<std::string>{"generated", "model", "format", "name", "coordinates",
                                         "inputs", "parameters", "outputs", "hash"});
}

TEST_CASE("what it was made from reads back") {
  Subject subject = cart_pole();
  subject.scene.paths = {"../models/cart_pole.toml", "../models/scenes/balance.scene.toml"};
  const SourcePaths paths = stated_paths(text_of(subject));
  CHECK(paths.model == subject.scene.paths.model);
  CHECK(paths.scene == subject.scene.paths.scene);
  CHECK(stated_paths("{").model.empty());
}

TEST_CASE("outputs") {
  const Json outputs = Json::parse(text_of(cart_pole()))["outputs"];
  CHECK(outputs["mass_matrix"]["shape"] == Json{2, 2});
  CHECK(outputs["mass_matrix"]["entries"][0] == "M + m");
  CHECK(outputs["mass_matrix"]["operations"]["mul"] == 4);
  CHECK(outputs["forward_dynamics"]["fields"]["acceleration"]["shape"] == Json{2, 1});
  CHECK(outputs["dynamics"].size() == 1);
  CHECK(outputs["dynamics"].contains("operations"));
}

TEST_CASE("definitions are listed in order, before the entries that use them") {
  const Subject subject = cart_pole();
  EmissionInput input =
      emission_input(subject.model, subject.scene, subject.program, {subject.program});
  input.equations[1] = {{{"sum", "x + y"}, {"square", "sum^2"}}, {{"square", "0"}}};
  const Json json = Json::parse(sidecar(input));
  const Json& output = json["outputs"]["gravity"];
  CHECK(output["definitions"] == Json::parse(R"([{"name": "sum", "value": "x + y"},
                                                 {"name": "square", "value": "sum^2"}])"));
  CHECK(output["entries"] == Json::parse(R"(["square", "0"])"));
  std::vector<std::string> keys;
  for (const auto& item : output.items()) keys.push_back(item.key());
  CHECK(keys == std::vector<std::string>{"definitions", "shape", "entries", "operations"});
}

TEST_CASE("parameters: exact texts, arrays as one entry, unread ones left out") {
  Subject subject = cart_pole();
  elgen::testing::add_parameter_array(subject.model, "k", {cln::cl_RA(1) / 3, 2});
  elgen::testing::read_parameter(subject, "k[1]");
  elgen::testing::add_parameter(subject.model, "unread", 1, "kg");
  const Json parameters = Json::parse(text_of(subject))["parameters"];
  REQUIRE(parameters.size() == 5);
  CHECK(parameters[1] == Json{{"name", "m"}, {"unit", "kg"}, {"value", "0.1"}});
  CHECK(parameters[4] == Json{{"name", "k"}, {"size", 2}, {"value", {"1/3", "2"}}});
}

TEST_CASE("short lists stand on one line, lines end with LF") {
  const std::string text = text_of(cart_pole());
  CHECK(text.find("      \"shape\": [2, 2],\n") != std::string::npos);
  CHECK(text.find('\r') == std::string::npos);
  CHECK(text.back() == '\n');
}

TEST_CASE("what is left out stands beside the outputs, each with its reason") {
  Subject subject = cart_pole();
  subject.scene.left_out = {{LeftOutReason::too_many_entries, {"mass_matrix", "coriolis_matrix"}},
                            {LeftOutReason::kinked_force, {"linearization"}}};
  const Json left_out = Json::parse(text_of(subject))["left_out"];
  CHECK(left_out.dump() ==
        R"({"mass_matrix":"too many entries","coriolis_matrix":"too many entries",)"
        R"("linearization":"kinked force"})");
}
