// Frames become elementary transforms in order from the root; frames without contents are omitted.
#include <catch2/catch.hpp>

#include "derive/formulate/expressions.hpp"
#include "derive/formulate/written_out.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Lagrangian with_frames(const std::string& entries) {
  const std::string text = model_text("frames", R"toml(
[[coordinate]]
name = "q"
[[coordinate]]
name = "s"
[parameters]
m = 2
l = 3
[energy]
T = "dot(q)^2 + dot(s)^2"
[[input]]
name = "u"
)toml" + entries);
  Result<UnreducedLagrangian> lagrangian = formulate(checked_model(text).model);
  REQUIRE(lagrangian);
  return std::move(*lagrangian);
}

/// A body of mass m at the origin of a frame.
std::string body_in(const std::string& frame) {
  return "[[body]]\nname = \"body_" + frame + "\"\nframe = \"" + frame +
         "\"\nmass = \"m\"\ncom = [\"0\", \"0\", \"0\"]\n";
}

std::string text(const Lagrangian& lagrangian, const GiNaC::ex& value) {
  std::ostringstream out;
  out << written_out(lagrangian.definitions, value);
  return out.str();
}

/// The transforms, such as "shift(l,0,0) turn(0,0,1;q)". If the parent of a transform is not the
/// transform before, the parent is appended: "^world", or "^" and the number of the parent.
std::string steps(const Lagrangian& lagrangian) {
  std::string result;
  const std::vector<TreeTransform>& list = lagrangian.tree.transforms;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const TreeTransform& step = list[i];
    const auto three = [&](const ExVector3& x) {
      return text(lagrangian, x[0]) + "," + text(lagrangian, x[1]) + "," + text(lagrangian, x[2]);
    };
    result += i == 0 ? "" : " ";
    if (step.kind == TransformKind::translation) {
      result += "shift(" + three(step.vector) + ")";
    } else if (step.kind == TransformKind::turn) {
      result += "turn(" + three(step.vector) + ";" + text(lagrangian, step.angle) + ")";
    } else {
      result += "quaternion";
    }
    const bool follows = i == 0 ? !step.parent : step.parent == i - 1;
    if (!follows) result += step.parent ? "^" + std::to_string(*step.parent) : "^world";
  }
  return result;
}

std::string steps_of(const std::string& entries) { return steps(with_frames(entries)); }

}  // namespace

TEST_CASE("a frame is a translation followed by its rotations", "[frames]") {
  const Lagrangian lagrangian = with_frames(
      "[[frame]]\nname = \"f\"\nparent = \"world\"\ntranslate = [\"l\", \"s\", \"0\"]\n"
      "rotate = [[\"x\", \"1/3\"], [\"y\", \"q\"]]\n" +
      body_in("f"));
  CHECK(steps(lagrangian) == "shift(l,s,0) turn(1,0,0;1/3) turn(0,1,0;q)");
  CHECK(lagrangian.tree.transforms[2].name == "f");
  CHECK(lagrangian.tree.transforms[2].origin.kind == EntityKind::frame);
  REQUIRE(lagrangian.tree.bodies.size() == 1);
  CHECK(lagrangian.tree.bodies[0].transform == 2U);
  CHECK(lagrangian.masses.empty());
}

TEST_CASE("identity steps are omitted", "[frames]") {
  const std::string frame = "[[frame]]\nname = \"f\"\nparent = \"world\"\n";
  CHECK(steps_of(frame + "translate = [\"0\", \"0\", \"0\"]\nrpy = [\"0\", \"q\", \"0\"]\n" +
                 body_in("f")) == "turn(0,1,0;q)");
  const Lagrangian fixed = with_frames(frame + body_in("f"));
  CHECK(fixed.tree.transforms.empty());
  CHECK_FALSE(fixed.tree.bodies[0].transform);
}

TEST_CASE("a translation along the axis of a rotation comes after the rotation", "[frames]") {
  const std::string frame = "[[frame]]\nname = \"f\"\nparent = \"world\"\n";
  const std::string body = body_in("f");
  CHECK(steps_of(frame + "translate = [\"l\", \"2*l\", \"s\"]\nrotate = [[\"z\", \"q\"]]\n" +
                 body) == "shift(l,2*l,0) turn(0,0,1;q) shift(0,0,s)");
  CHECK(steps_of(frame + "translate = [\"0\", \"0\", \"s\"]\nrotate = [[\"z\", \"q\"]]\n" + body) ==
        "turn(0,0,1;q) shift(0,0,s)");
  // x_parent = (x, z, -y): the y axis of the parent is the z axis of the frame.
  CHECK(steps_of(frame +
                 "translate = [\"l\", \"s\", \"0\"]\nrotate = [[\"x\", \"-pi/2\"], [\"z\", "
                 "\"q\"]]\n" +
                 body) == "shift(l,0,0) turn(1,0,0;-1/2*Pi) turn(0,0,1;q) shift(0,0,s)");
  CHECK(steps_of(frame +
                 "translate = [\"l\", \"s\", \"0\"]\nrotate = [[\"x\", \"pi/2\"], [\"z\", "
                 "\"q\"]]\n" +
                 body) == "shift(l,0,0) turn(1,0,0;1/2*Pi) turn(0,0,1;q) shift(0,0,-s)");
  // s does not move across the turn by 1 rad about x, because cos(1) and sin(1) are irrational.
  CHECK(steps_of(frame +
                 "translate = [\"l\", \"s\", \"0\"]\nrotate = [[\"x\", \"1\"], [\"z\", "
                 "\"q\"]]\n" +
                 body) == "shift(l,s,0) turn(1,0,0;1) turn(0,0,1;q)");
}

TEST_CASE("frames without contents are omitted, with their descendants", "[frames]") {
  const std::string frames =
      "[[frame]]\nname = \"f\"\nparent = \"world\"\nrotate = [[\"x\", \"q\"]]\n"
      "[[frame]]\nname = \"g\"\nparent = \"f\"\nrotate = [[\"y\", \"s\"]]\n";
  CHECK(steps_of(frames) == "");
  CHECK(steps_of(frames + body_in("f")) == "turn(1,0,0;q)");
  const std::string both = "turn(1,0,0;q) turn(0,1,0;s)";
  CHECK(steps_of(frames + body_in("g")) == both);
  CHECK(steps_of(frames + "[[output]]\nname = \"o\"\nframe = \"g\"\n") == both);
  CHECK(steps_of(frames +
                 "[[force]]\nframe = \"f\"\nfrom = \"g\"\nvalue = [\"u\", \"0\", \"0\"]\n") ==
        both);
  const std::string point = "[[point]]\nname = \"p\"\nframe = \"g\"\nat = [\"0\", \"l\", \"0\"]\n";
  CHECK(steps_of(frames + point) == "");
  CHECK(steps_of(frames + point + "mass = \"m\"\n") == both);
  CHECK(steps_of(frames + point + "[[force]]\nat = \"p\"\nvalue = [\"u\", \"0\", \"0\"]\n") ==
        both);
}

TEST_CASE("parents come first in any order of declaration", "[frames]") {
  CHECK(steps_of("[[frame]]\nname = \"f\"\nparent = \"g\"\nrotate = [[\"x\", \"q\"]]\n"
                 "[[frame]]\nname = \"h\"\nparent = \"g\"\nrotate = [[\"y\", \"q\"]]\n"
                 "[[frame]]\nname = \"g\"\nparent = \"world\"\nrotate = [[\"z\", \"s\"]]\n" +
                 body_in("f") + body_in("h")) == "turn(0,0,1;s) turn(1,0,0;q) turn(0,1,0;q)^0");
}

TEST_CASE("a point that slides in its frame has its own step", "[frames]") {
  const std::string entries =
      "[[frame]]\nname = \"f\"\nparent = \"world\"\nrotate = [[\"x\", \"q\"]]\n"
      "[[point]]\nname = \"p\"\nframe = \"f\"\nat = [\"s\", \"l\", \"0\"]\n";
  const std::string force = "[[force]]\nat = \"p\"\nvalue = [\"u\", \"0\", \"0\"]\n";
  const Lagrangian with_mass = with_frames(entries + "mass = \"m\"\n" + force + force);
  CHECK(steps(with_mass) == "turn(1,0,0;q) shift(s,l,0)");
  CHECK(with_mass.tree.bodies[0].transform == 1U);
  REQUIRE(with_mass.tree.wrenches.size() == 2);
  CHECK(with_mass.tree.wrenches[1].transform == 1U);
  CHECK(with_mass.tree.wrenches[1].at[0].is_zero());
  CHECK(steps(with_frames(entries + force)) == "turn(1,0,0;q) shift(s,l,0)");
}

TEST_CASE("wrenches and outputs refer to their steps and axes", "[frames]") {
  const Lagrangian lagrangian = with_frames(
      "[[frame]]\nname = \"f\"\nparent = \"world\"\nrotate = [[\"x\", \"q\"]]\n"
      "[[frame]]\nname = \"g\"\nparent = \"f\"\nrotate = [[\"y\", \"s\"]]\n"
      "[[force]]\nframe = \"g\"\nfrom = \"f\"\nvalue = [\"u\", \"0\", \"0\"]\n"
      "[[output]]\nname = \"o\"\nframe = \"g\"\naxes = \"g\"\n"
      "[[output]]\nname = \"w\"\nframe = \"f\"\n");
  const std::vector<Wrench>& wrenches = lagrangian.tree.wrenches;
  REQUIRE(wrenches.size() == 2);
  CHECK(wrenches[0].transform == 1U);
  CHECK(wrenches[0].axes == 1U);
  CHECK(wrenches[1].transform == 0U);
  CHECK(wrenches[1].axes == 1U);
  CHECK(wrenches[1].moment[0].is_equal(-wrenches[0].moment[0]));
  REQUIRE(lagrangian.outputs[0].twist);
  CHECK(lagrangian.outputs[0].twist->transform == 1U);
  CHECK_FALSE(lagrangian.outputs[0].twist->is_in_world);
  CHECK(lagrangian.outputs[1].twist->is_in_world);
}
