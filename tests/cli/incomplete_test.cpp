// elgen verify --only expect, with fewer equations than accelerations, with identities, and with
// multipliers.
#include <catch2/catch.hpp>
#include <string>

#include "cli/stated_testing.hpp"

namespace elgen::test {
namespace {

Outcome judge_alone(const std::string& model, const std::string& keys) {
  return run_with(model, keys, "verify --only expect");
}

/// A ladder that slides off a wall, in three coordinates.
const std::string ladder = R"toml(format = 1
[model]
name = "ladder"
[[coordinate]]
name = "x"
unit = "m"
start = { value = 0.5 }
[[coordinate]]
name = "y"
unit = "m"
start = { value = 0.9 }
[[coordinate]]
name = "theta"
unit = "rad"
start = { value = 0.5 }
[parameters]
m = { value = 10, unit = "kg" }
L = { value = 2, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
[[frame]]
name = "ladder"
parent = "world"
translate = ["x", "y"]
rotate = [["z", "theta"]]
[[body]]
name = "ladder"
frame = "ladder"
mass = "m"
inertia = "m*L^2/12"
[[point]]
name = "foot"
frame = "ladder"
at = ["0", "-L/2"]
[[point]]
name = "top"
frame = "ladder"
at = ["0", "L/2"]
[gravity]
vector = ["0", "-g"]
[[constraint]]
name = "floor"
equation = "y(foot) = 0"
[[constraint]]
name = "wall"
equation = "x(top) = 0"
[[expect]]
equations = [)toml";

Outcome judge_ladder(const std::string& equations) {
  const Workspace workspace;
  workspace.write("model.toml", ladder + equations + "]\n");
  return workspace.run("elgen verify --only expect model.toml");
}

}  // namespace

TEST_CASE("verify --only expect: the verdict comes first, then every claim") {
  const Outcome right =
      run_with("simple_pendulum", "equations = \"l*dot(dot(theta)) = -g*sin(theta)\"\n",
               "verify --only expect");
  INFO(right.output << right.errors);
  CHECK(right.status == 0);
  CHECK(right.output.rfind("simple_pendulum: 2 checks hold, 0 fail, 0 skipped\n\n[[expect]]\n",
                           0) == 0);
  CHECK(mentions(right.output, "  holds    equations      equal\n"));
  CHECK_FALSE(mentions(right.output, "program vs oracle"));
}

TEST_CASE("verify --only expect: fewer equations than accelerations are judged one by one") {
  const Outcome row = judge_alone("cart_pole", "equations = " + pole_row + "\n");
  INFO(row.output << row.errors);
  CHECK(row.status == 0);
  CHECK(row.output.rfind("cart_pole: 1 check holds, 0 fail, 0 skipped, 1 noted, 1 of 2 equations "
                         "stated\n\n[[expect]]\n",
                         0) == 0);
  CHECK(
      mentions(row.output,
               "  holds    equations      row theta of the equations of motion, times 1/(m*l)\n"));
  CHECK(mentions(row.output, "decided    for every state, by proof\n"));
  CHECK(mentions(row.output, "  noted    accelerations  1 of 2 stated\n"));
  const Outcome solved = judge_alone(
      "cart_pole",
      "equations = \"(M + m*sin(theta)^2)*dot(dot(x)) = u + m*sin(theta)*(l*dot(theta)^2 - "
      "g*cos(theta))\"\n");
  INFO(solved.output);
  CHECK(
      mentions(solved.output, "  holds    equations      follows from the equations of motion\n"));
  const Outcome wrong = judge_alone(
      "cart_pole", "equations = \"l*dot(dot(theta)) + cos(theta)*dot(dot(x)) = g*cos(theta)\"\n");
  INFO(wrong.output << wrong.errors);
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.output, "cart_pole: 0 checks hold, 1 fails, 0 skipped, 1 noted, "));
  CHECK(mentions(wrong.errors, "[E510]: left - right is "));
  CHECK(mentions(wrong.errors, " along the motion at q = ("));
  CHECK(mentions(wrong.errors, "row theta"));
}

TEST_CASE("verify: an identity holds for any motion and proves nothing") {
  const std::string identity = "\"sin(theta)^2*dot(dot(x)) = (1 - cos(theta)^2)*dot(dot(x))\"";
  const std::string told = "an identity: it holds for any motion, so it proves nothing\n";
  const Outcome alone = judge_alone("cart_pole", "equations = " + identity + "\n");
  INFO(alone.output << alone.errors);
  CHECK(alone.status == 2);
  CHECK(mentions(alone.output, "  noted    equations      " + told));
  CHECK(mentions(alone.output, "0 checks hold, 1 fails, 0 skipped, 1 noted, 0 of 2 equations"));
  CHECK(mentions(alone.errors, "[E540]: d(left - right)/da has rank 0, so no acceleration is"));
  const Outcome beside_row =
      judge_alone("cart_pole", "equations = [" + pole_row + ", " + identity + "]\n");
  INFO(beside_row.output << beside_row.errors);
  CHECK(beside_row.status == 2);
  CHECK(mentions(beside_row.output, told));
  CHECK(mentions(beside_row.errors, "[E540]: d(left - right)/da has rank 1 of 2, so"));
}

TEST_CASE("verify --only expect: a model must state something") {
  const Workspace workspace;
  workspace.prepare("sed '/^\\[\\[expect\\]\\]/,$d' " + models + "/cart_pole.toml > model.toml");
  const Outcome none = workspace.run("elgen verify --only expect model.toml");
  CHECK(none.status == 2);
  CHECK(mentions(none.errors, "error[E913]: `model.toml` has no `[[expect]]` to check"));
  CHECK(workspace.run("elgen verify --only expect --quick model.toml").status == 2);
}

// theta is the angle from the wall: the standard result theta'' = 3/2 g/L sin(theta). The
// multipliers are the forces of the wall along x and of the floor along y.
TEST_CASE("verify: multipliers are stated like accelerations") {
  const std::string wall =
      "\"lambda(wall) = 3/4*m*g*sin(theta)*cos(theta) - 1/2*m*L*sin(theta)*dot(theta)^2\"";
  const Outcome all = judge_ladder(
      "\"dot(dot(theta)) = 3/2*g/L*sin(theta)\", " + wall +
      ", \"lambda_floor = m*g - 3/4*m*g*sin(theta)^2 - 1/2*m*L*cos(theta)*dot(theta)^2\"");
  INFO(all.output << all.errors);
  CHECK(all.status == 0);
  CHECK(all.output.rfind("ladder: 4 checks hold, 0 fail, 0 skipped\n", 0) == 0);
  CHECK(mentions(all.output, "  holds    accelerations  full rank\n"));
  const Outcome row = judge_ladder("\"lambda(wall) = m*dot(dot(x))\"");
  INFO(row.output << row.errors);
  CHECK(row.status == 0);
  CHECK(mentions(row.output, "row x of the equations of motion, times -1\n"));
  CHECK(mentions(row.output, ", 1 of 2 equations stated\n"));
  const Outcome reactions =
      judge_ladder("\"m*dot(dot(x)) = lambda(wall)\", \"m*dot(dot(y)) = lambda(floor) - m*g\"");
  INFO(reactions.output << reactions.errors);
  CHECK(mentions(reactions.output, ": 2 checks hold, 0 fail, 0 skipped, 1 noted, 2 of 3 "));
  const Outcome sign = judge_ladder("\"m*dot(dot(x)) = -lambda(wall)\"");
  INFO(sign.output << sign.errors);
  CHECK(sign.status == 1);
  CHECK(mentions(sign.errors,
                 "compared with row x of the equations of motion: the term "
                 "lambda_wall has the opposite sign"));
  const Outcome wrong = judge_ladder(
      "\"lambda(wall) = 3/4*m*g*sin(theta)*cos(theta) + "
      "1/2*m*L*sin(theta)*dot(theta)^2\"");
  INFO(wrong.output << wrong.errors);
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors, "[E510]: left - right is "));
  CHECK(mentions(wrong.errors, " along the motion at q = ("));
  // A multiplier of unknown value leaves the accelerations undetermined.
  const Outcome unknown = judge_ladder(
      "\"m*dot(dot(x)) = lambda(wall)\", "
      "\"m*dot(dot(x)) = lambda_wall\"");
  INFO(unknown.output << unknown.errors);
  CHECK(unknown.status == 2);
  CHECK(mentions(unknown.errors, "[E540]: d(left - right)/da has rank 2 of 3, so"));
}

}  // namespace elgen::test
