// Options of a run: start values, laws of inputs and values of parameters.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "check/scene/scene.hpp"
#include "check_testing.hpp"
#include "support/models.hpp"

namespace elgen::test {
namespace {

const std::string flying_hull = model_text("flying", R"toml([[coordinate]]
name = "x"
start = { value = 1, rate = 2 }
[[coordinate]]
name = "q[i]"
for = "i in 1..2"
[[coordinate]]
name = "attitude"
kind = "rotation"
[parameters]
m = { value = 1, assume = "positive" }
l = { value = 2, size = 3 }
[[frame]]
name = "hull"
parent = "world"
translate = ["x", "q[1]", "q[2]"]
rotation = "attitude"
[[body]]
name = "hull"
frame = "hull"
mass = "m"
inertia = ["l[1]", "l[2]", "l[3]"]
[[input]]
name = "u"
on = "x"
)toml");

SceneOptions options(const std::string& starts, const std::string& laws = {},
                     const std::string& values = {}) {
  SceneOptions result;
  if (!starts.empty()) result.starts = {make_source("command line", starts)};
  if (!laws.empty()) result.laws = {make_source("command line", laws)};
  if (!values.empty()) result.values = {make_source("command line", values)};
  return result;
}

/// The first error with its column, such as "E612 12 unknown coordinate `y` | did you mean `x`?";
/// empty if there is no error.
std::string answer(const SceneOptions& given) {
  const Limits limits;
  const Result<FileSyntax> syntax = parse_model(make_source("m.toml", flying_hull), limits);
  const Result<CheckedModel> result = check(*syntax, nullptr, given, limits);
  if (result) return "";
  const auto is_error = [](const Diagnostic& diagnostic) {
    return code_row(diagnostic.code).severity == Severity::error;
  };
  const Diagnostic& first = *std::ranges::find_if(result.diagnostics, is_error);
  const std::size_t column = line_column(*first.span.source, first.span.begin).column;
  return std::string(code_row(first.code).name) + " " + std::to_string(column) + " " +
         first.message + (first.hint.empty() ? "" : " | " + first.hint);
}

}  // namespace

TEST_CASE("a start value that looks like degrees is noted") {
  const Limits limits;
  const std::string arm = model_text(
      "arm", "[[coordinate]]\nname = \"q\"\nunit = \"rad\"\n[energy]\nT = \"dot(q)^2\"\n");
  const Result<FileSyntax> syntax = parse_model(make_source("m.toml", arm), limits);
  const auto notes = [&](const std::string& starts) {
    const Result<CheckedModel> result = check(*syntax, nullptr, options(starts), limits);
    REQUIRE(result);
    std::string text;
    for (const Diagnostic& diagnostic : result.diagnostics) {
      if (diagnostic.code == Code::E405) text += diagnostic.message + " | " + diagnostic.hint;
    }
    return text;
  };
  CHECK(notes("q=-45, dot(q)=90") ==
        "`-45` is in rad | a turn is `2*pi`, and as degrees it would be `-pi/4`");
  CHECK(notes("q=5").empty());
  CHECK(notes("q=7").empty());
  CHECK(notes("q=90*pi/180").empty());
}

TEST_CASE("a start names coordinates, rates, rotations and angular velocities") {
  const CheckedModel checked = checked_model(
      flying_hull,
      options("x = 1/2, dot(x)=-3, q[2]=pi, attitude=[0,0.6,0,0.8], dot(attitude[2])=5"));
  const Model& model = checked.model;
  CHECK(model.coordinates[0].start_value == cln::cl_RA(1) / 2);
  CHECK(model.velocities[0].start_rate == -3);
  CHECK(model.coordinates[1].start_value == 0);
  CHECK(cln::double_approx(model.coordinates[2].start_value) == Approx(3.141592653589793));
  CHECK(model.coordinates[3].start_value == 0);
  CHECK(model.coordinates[6].start_value == cln::cl_RA(4) / 5);
  CHECK(model.velocities[4].start_rate == 5);
  CHECK(checked.scene.state_overrides.coordinates ==
        std::set<std::string>{"x", "q[2]", "attitude_w", "attitude_x", "attitude_y", "attitude_z"});
  CHECK(checked.scene.state_overrides.velocities == std::set<std::string>{"x", "attitude[2]"});
  CHECK(checked.scene.state_overrides.others.empty());
}

TEST_CASE("the model gives the start values that the option omits") {
  const Model model = checked_model(flying_hull, options("q[1]=7")).model;
  CHECK(model.coordinates[0].start_value == 1);
  CHECK(model.velocities[0].start_rate == 2);
  CHECK(model.coordinates[3].start_value == 1);
}

TEST_CASE("errors in a start are reported at their position") {
  CHECK(answer(options("x=1,y=2")) == "E612 5 unknown coordinate `y`");
  CHECK(answer(options("x")) == "E606 1 `x` has no value");
  CHECK(answer(options("x=1, dot(x)=1, x =2")) == "E606 16 `x` is given twice");
  CHECK(answer(options("x=m")) == "E319 3 `m` is not a constant number");
  CHECK(answer(options("x=[1,2]")) == "E606 3 `x` takes 1 number");
  CHECK(answer(options("attitude=[1,0,0]")) == "E606 10 `attitude` takes 4 numbers");
  CHECK(answer(options("attitude=[0,0,0,0]")) == "E606 10 a quaternion of length 0 is no rotation");
}

TEST_CASE("a law may use state, time and parameters, and its unit is not checked") {
  const CheckedModel checked =
      checked_model(flying_hull, options("", "u=-m*x - 2*dot(x) + max(t, 0)"));
  const ExpressionId* const law = find_law(checked.scene, checked.model.inputs[0]);
  REQUIRE(law != nullptr);
  CHECK(to_string(checked.model, *law) == "-m*x - 2*dot(x) + max(t, 0)");
  CHECK(checked_model(block("[[input]]\nname = \"u\"\nunit = \"N\"\non = \"x\"\n"),
                      options("", "u=-3*x - dot(x)"))
            .scene.laws.contains("u"));
}

TEST_CASE("errors in a law are reported at their position") {
  CHECK(answer(options("", "w=1")) == "E201 1 unknown input `w`");
  CHECK(answer(options("", "u=-3*xx")) ==
        "E201 6 unknown name `xx` | did you mean `x`? (coordinate, line 5)");
  CHECK(answer(options("", "u=u")).starts_with("E319 3 "));
  CHECK(answer(options("", "u=1,u=2")) == "E606 5 `u` is given twice");
  CHECK(answer(options("", "u=dot(dot(x))")).starts_with("E"));
  CHECK(answer(options("", "u=dot(v2(hull))")).starts_with("E"));
}

TEST_CASE("values may be set for parameters that are not fixed") {
  const Model model = checked_model(flying_hull, options("", "", "m=3,l=1/2,l[2]=5")).model;
  CHECK(model.parameters[0].value == 3);
  CHECK(model.parameters[1].value == cln::cl_RA(1) / 2);
  CHECK(model.parameters[2].value == 5);
  CHECK(answer(options("", "", "k=3")) == "E602 1 unknown parameter `k`");
  CHECK(answer(options("", "", "m=-3")).starts_with("E112 "));
  CHECK(answer(options("", "", "m=3,l=1,m=3")) == "E606 9 `m` is given twice");
  SceneOptions fixed = options("", "", "m=3");
  fixed.fixed = {make_source("command line", "m=2")};
  CHECK(answer(fixed) == "E606 1 `m` is fixed, so it is no parameter");
}

TEST_CASE("a locked coordinate has no start value") {
  const Limits limits;
  const Result<FileSyntax> scene = parse_scene(
      make_source("s.scene.toml",
                  "format = 1\nmodel = \"m.toml\"\nname = \"s\"\n[lock]\nx = { value = 0 }\n"),
      limits);
  const Result<FileSyntax> syntax = parse_model(make_source("m.toml", flying_hull), limits);
  const Result<CheckedModel> result = check(*syntax, &*scene, options("x=1"), limits);
  REQUIRE_FALSE(result);
  CHECK(result.diagnostics.front().message == "`x` is locked by the scene");
}

}  // namespace elgen::test
