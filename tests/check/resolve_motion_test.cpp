// Positions and motion of frames in expressions: definitions, units and refusals.
#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "model_numbers.hpp"

namespace elgen::test {

namespace {

/// An arm that rotates about z and carries a slide that rotates about x; `more` starts on line 34.
std::string slide(const std::string& more) {
  return with_frames(R"toml([[frame]]
name = "arm"
parent = "world"
rotate = [["z", "q"]]
[[frame]]
name = "slide"
parent = "arm"
translate = ["s", "0", "l"]
rotate = [["x", "2*q"]]
[[body]]
name = "load"
frame = "slide"
mass = "m"
com = ["0", "l", "0"]
[[body]]
name = "wheel"
inertia = ["J", "J", "J"]
spin = ["dot(q)", "0", "0"]
)toml") + more;
}

std::string force(const std::string& value) {
  return slide("[[force]]\non = \"q\"\nvalue = \"" + value + "\"\n");
}

std::string messages_of(const std::string& value) { return messages(force(value)); }

/// The value of an expression at q, s and their rates.
double number_of(const std::string& value) {
  const std::string unchecked = "[parameters.c]\nvalue = 1\n";
  const Model model =
      checked(slide(unchecked + "[[force]]\non = \"q\"\nvalue = \"" + value + "\"\n")).model;
  const ModelNumbers at(model, {q, s}, {q_rate, s_rate});
  return at.values(model.forces[0].value)[0];
}

}  // namespace

TEST_CASE("x, y and z take points, origins of frames, and bodies in frames", "[frames]") {
  CHECK(dump_lines(force("J*x(arm)*x(slide)*y(load)/s^3*wz(arm)^2"), "force") ==
        "force  on q = [J*x(arm)*x(slide)*y(load)/s^3*wz(arm)^2]\n");
  CHECK(number_of("c*x(slide)/l*1") == Approx(s * std::cos(q) / l));
  const Triple com = about_z(q) * (Triple{s, 0, l} + about_x(2 * q) * Triple{0, l, 0});
  CHECK(number_of("c*y(load)") == Approx(com[1]));
  CHECK(number_of("c*dist2(arm, load)") ==
        Approx(com[0] * com[0] + com[1] * com[1] + com[2] * com[2]));
}

TEST_CASE("components of angular velocities are in the axes of the world or of a frame",
          "[frames]") {
  const Triple own = about_x(-2 * q) * Triple{0, 0, q_rate} + Triple{2 * q_rate, 0, 0};
  const Triple in_world = about_z(q) * (about_x(2 * q) * own);
  CHECK(number_of("c*wx(slide)") == Approx(in_world[0]));
  CHECK(number_of("c*wy(load)") == Approx(in_world[1]));
  CHECK(number_of("c*wz(slide, world)") == Approx(in_world[2]));
  CHECK(number_of("c*wx(slide, slide)") == Approx(own[0]));
  CHECK(number_of("c*wy(slide, load)") == Approx(own[1]));
  CHECK(number_of("c*wz(slide, arm)") == Approx((about_x(2 * q) * own)[2]));
  CHECK(number_of("c*wz(world)") == 0);
  CHECK(dump_lines(force("J*wx(slide)*wy(slide, slide)"), "force") ==
        "force  on q = [J*wx(slide)*wy(slide, slide)]\n");
}

TEST_CASE("components of velocities are in the axes of a frame", "[frames]") {
  const Triple along = about_z(-q) * (Triple{s_rate * std::cos(q) - s * std::sin(q) * q_rate,
                                             s_rate * std::sin(q) + s * std::cos(q) * q_rate, 0});
  CHECK(number_of("c*vx(slide, arm)") == Approx(along[0]));
  CHECK(number_of("c*vy(slide, arm)") == Approx(along[1]));
  CHECK(number_of("c*vz(slide, arm)") == 0);
  CHECK(number_of("c*vx(slide, world)") == number_of("c*dot(x(slide))"));
}

TEST_CASE("axis is the rotation matrix from the axes of a frame to the axes of the world",
          "[frames]") {
  const Rotation3 turn = about_z(q) * about_x(2 * q);
  CHECK(number_of("c*axis(slide, 2, 3)") == Approx(turn[5]));
  CHECK(number_of("sum(i, 1, 3, c*axis(load, i, 1)^2)") == Approx(1));
  CHECK(number_of("c*axis(world, 1, 2) + c*axis(world, 3, 3)") == 1);
  CHECK(dump_lines(slide("[[point]]\nname = \"P\"\nat = [\"l*axis(arm, 1, 1)\", \"0\", \"0\"]\n"),
                   "point") == "point P at [l*axis(arm, 1, 1), 0, 0]\n");
}

TEST_CASE("motion of frames has units, and a model may declare a name such as wx", "[frames]") {
  CHECK(messages_of("m*vx(slide, arm)*x(slide)*wz(arm)") == "");
  CHECK(messages_of("m*wx(slide)") ==
        "E403 36:10 `m*wx(slide)` is in kg/s, but a force is in N*m\n");
  CHECK(messages(slide("[parameters.wx]\nvalue = 2\nunit = \"J*s\"\n[[force]]\non = \"q\"\n"
                       "value = \"wx*wx(slide)\"\n")) == "");
}

TEST_CASE("refused motion of frames", "[frames]") {
  const Rows rows{
      {"J*wx(slid)", "E201 36:15 unknown frame `slid` | did you mean `slide`? (frame, line 21)\n"},
      {"J*wx(wheel)",
       "E201 36:15 `wheel` is in no frame here | a body has the axes of its `frame`\n"},
      {"J*wx(slide, 2)", "E201 36:22 unknown frame `2`\n"},
      {"J*wx(slide, arm, arm)", "E309 36:12 3 arguments, but `wx` takes 1\n"},
      {"J*vx(slide)",
       "E309 36:12 `vx` needs a frame as its second argument, for its axes | along the axes of the "
       "world, write `dot(x(slide))`\n"},
      {"J*vx(slid, arm)", "E201 36:15 unknown place `slid` | did you mean `slide`?\n"},
      {"J*x(wheel)",
       "E201 36:14 `wheel` is not a place here | the com of a body in a frame is a place in "
       "forces, energies, constraints and outputs; elsewhere name a point, or a frame for its "
       "origin\n"},
      {"J*axis(arm, 1)", "E309 36:12 2 arguments, but `axis` takes 3\n"},
      {"J*axis(arm, 1, 4)", "E318 36:25 `4` is not from 1 to 3\n"},
      {"J*axis(arm, q, 1)", "E201 36:22 unknown index `q`\n"},
  };
  check_rows(rows, messages_of);
  CHECK(messages(slide("[[point]]\nname = \"P\"\nat = [\"l*wx(slide)\", \"0\", \"0\"]\n")) ==
        "E319 36:10 `wx(slide)` is a rate, but a position takes none\n");
}

TEST_CASE("planar frames rotate only about z", "[frames]") {
  const std::string plane =
      "[[frame]]\nname = \"f\"\nparent = \"world\"\ntranslate = [\"s\", \"0\"]\n"
      "rotate = [[\"z\", \"q\"]]\n[[force]]\non = \"q\"\nvalue = \"J*";
  CHECK(messages(with_frames(plane + "wz(f)^2\"\n")) == "");
  CHECK(messages(with_frames(plane + "wx(f)^2\"\n")) ==
        "E516 23:12 `f` is planar, so it has no wx\n");
  CHECK(messages(with_frames(plane + "z(f)/l\"\n")) ==
        "E516 23:12 `f` is planar, so it has no z\n");
}

TEST_CASE(
    "an equation for the velocity of a material point is refused with a hint on rolling contact",
    "[frames]") {
  const auto roll = [](const std::string& equations, const std::string& frame) {
    return slide("[[point]]\nname = \"C\"\n" + frame +
                 "at = [\"0\", \"0\", \"l\"]\n[[constraint]]\nname = \"roll\"\n"
                 "kind = \"velocity\"\nequation = [" +
                 equations + "]\n");
  };
  const std::string carried = "frame = \"slide\"\n";
  CHECK(messages(roll("\"dot(x(C)) = 0\", \"dot(y(C)) = 0\"", carried)) ==
        "E541 41:31 `C` turns with `slide`, so the equation fixes one material point, as in a "
        "pivot | for a rolling contact, write the velocity of the centre: `dot(x) = r*wy(F)`\n");
  CHECK(messages(roll("\"dot(x(C)) = 0\"", carried)) == "");
  CHECK(messages(roll("\"dot(x(slide)) = l*wy(slide)\", \"dot(y(slide)) = -l*wx(slide)\"",
                      carried)) == "");
}

}  // namespace elgen::test
