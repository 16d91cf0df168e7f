// Frames, outputs and external forces that a scene adds to a model.
#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

const std::string leg = R"toml(format = 1
[model]
name = "leg"
[[coordinate]]
name = "hip"
unit = "rad"
[parameters]
m = { value = 1, unit = "kg" }
l = { value = 0.3, unit = "m" }
[[frame]]
name = "thigh"
parent = "world"
rotate = [["z", "hip"]]
[[point]]
name = "knee"
frame = "thigh"
at = ["l", "0"]
mass = "m"
[[output]]
name = "tip"
value = "x(knee)"
)toml";

/// A frame on lines 4 to 8 of the scene.
const std::string pen =
    "[[frame]]\nname = \"pen\"\nparent = \"thigh\"\ntranslate = [\"l\", \"0.1*l\"]\n"
    "rotate = [[\"z\", \"pi/2\"]]\n";
const std::string pose = "[[output]]\nname = \"pose\"\nframe = \"pen\"\njacobian = true\n";

const std::string push = "[[input]]\nname = \"push\"\nat = \"knee\"\n";

/// The leg with a motor, and with the lines `more`.
std::string driven_leg(const std::string& more) {
  return leg + "[[input]]\nname = \"motor\"\nunit = \"N*m\"\non = \"hip\"\n" + more;
}

/// A scene of `leg`; the text `more` starts on line 4.
CheckOptions adding(const std::string& more) {
  return {.scene = "format = 1\nmodel = \"leg.toml\"\nname = \"tool\"\n" + more};
}

bool emits(const std::string& scene, const std::string& output) {
  return find_request(checked(leg, adding(scene)).scene, output) != nullptr;
}

}  // namespace

TEST_CASE("the rows of a scene follow the rows of the model") {
  const auto [model, scene] = checked(leg, adding(pen + pose));
  REQUIRE(model.frames.size() == 2);
  CHECK(model.frames[1].name == "pen");
  CHECK(model.frames[1].parent == 0U);
  REQUIRE(model.outputs.size() == 2);
  CHECK(model.outputs[1].name == "pose");
  CHECK(model.outputs[1].frame == 1U);
  CHECK_FALSE(is_of_scene(model, model.outputs[0].span));
  CHECK(is_of_scene(model, model.outputs[1].span));
}

TEST_CASE("additions change the text of the scene, not of the model") {
  const auto [model, scene] = checked(leg, adding(pen + pose));
  CHECK(model.canonical_text == checked(leg).model.canonical_text);
  CHECK(scene.canonical_text != checked(leg, adding("")).scene.canonical_text);
  CHECK(mentions(scene.canonical_text, "[frame]\n  name = pen\n"));
}

TEST_CASE("a scene emits its outputs unless it refuses them") {
  CHECK(emits(pen + pose, "tip"));
  CHECK(emits(pen + pose, "pose_bias"));
  const std::string chosen = "[outputs]\nmass_matrix = true\n";
  CHECK_FALSE(emits(pen + pose + chosen, "tip"));
  CHECK(emits(pen + pose + chosen, "mass_matrix"));
  CHECK(emits(pen + pose + chosen, "pose"));
  CHECK_FALSE(emits(pen + pose + chosen + "pose = false\n", "pose"));
  CHECK(emits(pen + pose + chosen + "pose = false\n", "pose_jacobian"));
  CHECK(emits(pen + pose + chosen + "pose = { rename = \"grip\" }\n", "grip"));
  CHECK_FALSE(emits(pen + pose + chosen + "pose = { rename = \"grip\" }\n", "pose"));
}

TEST_CASE("the inputs of a scene follow the inputs of the model") {
  const std::string rest = "[[equilibrium]]\nname = \"rest\"\nat = { hip = 0 }\n";
  const auto [model, scene] = checked(driven_leg(rest), adding(push));
  REQUIRE(model.inputs.size() == 3);
  CHECK(model.inputs[0].name == "motor");
  CHECK_FALSE(is_of_scene(model, model.inputs[0].span));
  CHECK(is_of_scene(model, model.inputs[1].span));
  CHECK(model.inputs[2].is_external);
  CHECK(model.equilibria[0].inputs.size() == 3);
  REQUIRE(scene.model_alone != nullptr);
  CHECK(scene.model_alone->inputs.size() == 1);
  CHECK(checked(leg, adding(pen + pose)).scene.model_alone == nullptr);
}

TEST_CASE("a wrong expectation of the model is one error, also if the scene adds inputs") {
  const std::string wrong = driven_leg("[[expect]]\ninput_matrix = [[\"1\", \"2\"]]\n");
  CHECK(mentions(messages(wrong), "E517 27:16 "));
  CHECK(messages(wrong, adding(push)) == messages(wrong));
}

TEST_CASE("the expectations of a scene have the shapes of the scene") {
  const std::string pair =
      "format = 1\n[model]\nname = \"pair\"\n[[coordinate]]\nname = \"x\"\n[[coordinate]]\n"
      "name = \"y\"\n[energy]\nT = \"dot(x)^2 + x^2*dot(y)^2\"\n"
      "[[expect]]\nmomentum = [\"2*dot(x)\", \"2*x^2*dot(y)\"]\n";
  const std::string locked = "[lock]\nx = { value = \"t\" }\n[[expect]]\n";
  const auto [model, scene] = checked(pair, adding(locked + "mass_matrix = [[\"2*x^2\"]]\n"));
  REQUIRE(model.expectations.size() == 1);
  CHECK(model.expectations[0].output == "mass_matrix");
  CHECK(to_string(model, model.expectations[0].entries[0]) == "2*x^2");
  const std::string unchecked =
      "E520 5:9 `x`, `y`: no unit, so expressions with it are not checked\n";
  check_rows(
      {
          {"mass_matrix = [[\"2\", \"0\"], [\"0\", \"2*x^2\"]]\n",
           "E517 7:15 2 x 2 entries, but `mass_matrix` is 1 x 1 | a matrix is a list of rows: "
           "[[…], […]]\n"},
          {"conserved = [\"p(y)\"]\n", unchecked},
          {"conserved = [\"p(x)\"]\n",
           "E319 7:15 `p(x)` is the momentum of a coordinate that the scene removes\n"},
          {"equations = [\"dot(dot(y)) = 0\"]\n", unchecked},
          {"mass_matrix = [[1]]\nat = { x = 1 }\n", "E201 8:8 unknown name `x`\n"},
      },
      [&](const std::string& claim) { return messages(pair, adding(locked + claim)); });
  const std::string cyclic = "[routh]\ny = true\n[[expect]]\nconserved = [\"p(y)\"]\n";
  CHECK(mentions(messages(pair, adding(cyclic)),
                 "E319 7:15 `p(y)` is the momentum of a coordinate that the scene removes\n"));
}

TEST_CASE("mistakes in additions are reported in the scene") {
  const auto answer = [](const std::string& more) { return messages(leg, adding(more)); };
  const std::string frame = "[[frame]]\nname = \"pen\"\nparent = \"thigh\"\n";
  check_rows(
      {
          {pen + pose, ""},
          {"[[frame]]\nname = \"thigh\"\nparent = \"world\"\n",
           "E203 5:9 `thigh` is already a frame | first in `model.toml`\n"},
          {"[[output]]\nname = \"m\"\nvalue = \"hip\"\n",
           "E203 5:9 `m` is already a parameter | first in `model.toml`\n"},
          {"[[input]]\nname = \"u\"\nunit = \"N*m\"\non = \"hip\"\n",
           "E112 4:1 an input of a scene has `wrench` or `at`\n"},
          {"[[input]]\nname = \"m\"\nat = \"knee\"\n",
           "E203 5:9 `m[1]` is already a parameter | first in `model.toml`\n"},
          {frame + "rotate = [[\"z\", \"hip\"]]\n",
           "E319 7:18 `hip` is a coordinate, but a frame of a scene takes none\n"},
          {frame + "translate = [\"l*sin(hip)\", 0]\n",
           "E319 7:21 `hip` is a coordinate, but a frame of a scene takes none\n"},
          {frame + "rotate = [[\"z\", \"t\"]]\n",
           "E319 7:18 `t` is time, but a frame of a scene takes none\n"},
      },
      answer);
}

TEST_CASE("a frame of a scene is not turned by a rotation") {
  const std::string top =
      "format = 1\n[model]\nname = \"top\"\n[[coordinate]]\nname = \"attitude\"\n"
      "kind = \"rotation\"\n[[frame]]\nname = \"hull\"\nparent = \"world\"\n"
      "rotation = \"attitude\"\n[energy]\n"
      "T = \"1/2*(dot(attitude[1])^2 + dot(attitude[2])^2 + dot(attitude[3])^2)\"\n";
  CHECK(messages(top, adding("[[frame]]\nname = \"tool\"\nparent = \"hull\"\n"
                             "rotation = \"attitude\"\n")) ==
        "E319 7:13 `attitude` is a rotation, but a frame of a scene takes none\n");
}

}  // namespace elgen::test
