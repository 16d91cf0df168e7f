// Points, bodies, forces and outputs that are given in a frame, transformed to the world.
#include "check/entries/in_frame.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "model/requests.hpp"
#include "model_numbers.hpp"

namespace elgen::test {
namespace {

constexpr double m = 2;
constexpr double J = 0.2;

/// The model `with_frames` with two frames on lines 16 to 24, then `entries`. Frame `f` is at
/// (0, s, l) and rotated by q about z. Frame `g` is in `f`, rotated by 0.4 rad about x.
std::string with_two(const std::string& entries) {
  return with_frames(R"([[frame]]
name = "f"
parent = "world"
translate = ["0", "s", "l"]
rotate = [["z", "q"]]
[[frame]]
name = "g"
parent = "f"
rotate = [["x", "0.4"]]
)" + entries);
}

Model two_frames(const std::string& entries) { return checked(with_two(entries)).model; }

ModelNumbers numbers(const Model& model) { return {model, {q, s}, {q_rate, s_rate}}; }

TEST_CASE("points of a frame are transformed to the world", "[frames]") {
  const Model model = two_frames(
      "[[point]]\nname = \"p\"\nframe = \"f\"\nat = [\"l\", \"2*s\", \"0\"]\nmass = \"m\"\n"
      "[[point]]\nname = \"w\"\nframe = \"world\"\nat = [\"l\", \"0\", \"0\"]\n");
  const Triple expected = Triple{0, s, l} + about_z(q) * Triple{l, 2 * s, 0};
  CHECK(close(numbers(model).values(model.points[0].position), listed(expected)));
  REQUIRE(model.points[0].local);
  CHECK(model.points[0].local->frame == 0);
  CHECK(to_string(model, model.points[0].local->position[1]) == "2*s");
  CHECK_FALSE(model.points[1].local);
}

TEST_CASE("bodies rotate with their frame", "[frames]") {
  const Model model = two_frames(
      "[[body]]\nname = \"b\"\nframe = \"g\"\nmass = \"m\"\ncom = [\"l\", \"0\", \"2*l\"]\n"
      "inertia = [\"J\", \"2*J\", \"3*J\", \"J/9\", \"0\", \"J/8\"]\n");
  const Body& body = model.bodies[0];
  const ModelNumbers at = numbers(model);
  const Triple com = Triple{0, s, l} + about_z(q) * (about_x(0.4) * Triple{l, 0, 2 * l});
  CHECK(close(at.values(body.com), listed(com)));
  CHECK(close(at.values(body.spin), listed(about_x(-0.4) * Triple{0, 0, q_rate})));
  CHECK(close(at.values(body.inertia), {J, 2 * J, 3 * J, J / 9, 0, J / 8}));
  CHECK_FALSE(body.local->is_about_origin);
}

TEST_CASE("an inertia about the origin is converted to the centre of mass", "[frames]") {
  const Model model = two_frames(
      "[[body]]\nname = \"b\"\nframe = \"f\"\nmass = \"m\"\n"
      "com = [\"l/7\", \"-2*l/7\", \"3*l/7\"]\n"
      "inertia = [\"9*J\", \"8*J\", \"7*J\", \"J/9\", \"0\", \"J/8\"]\ninertia_about = "
      "\"origin\"\n");
  const Body& body = model.bodies[0];
  const double x = 0.1;
  const double y = -0.2;
  const double z = 0.3;
  CHECK(close(numbers(model).values(body.inertia),
              {9 * J - m * (y * y + z * z), 8 * J - m * (x * x + z * z),
               7 * J - m * (x * x + y * y), J / 9 + m * x * y, m * x * z, J / 8 + m * y * z}));
  REQUIRE(body.local);
  CHECK(body.local->is_about_origin);
  CHECK(to_string(model, body.local->inertia[0]) == "9*J");
}

TEST_CASE("a body without inertia has no spin", "[frames]") {
  const Model model = two_frames(
      "[[body]]\nname = \"b\"\nframe = \"g\"\nmass = \"m\"\ncom = [\"l\", \"0\", \"0\"]\n");
  CHECK(model.bodies[0].spin.empty());
}

TEST_CASE("the default centre of mass is the origin of the frame", "[frames]") {
  const Model model = two_frames("[[body]]\nname = \"b\"\nframe = \"f\"\nmass = \"m\"\n");
  CHECK(close(numbers(model).values(model.bodies[0].com), {0, s, l}));
}

TEST_CASE("components of forces are in the axes of the world or of the frame `in`", "[frames]") {
  const std::string point = "[[point]]\nname = \"p\"\nframe = \"g\"\nat = [\"l\", \"0\", \"0\"]\n";
  const std::string force =
      "[parameters.F]\nvalue = 1\nunit = \"N\"\n"
      "[[force]]\nat = \"p\"\nvalue = [\"F\", \"2*F\", \"3*F\"]\n";
  const Model plain = two_frames(point + force);
  CHECK(close(numbers(plain).values(plain.forces[0].value), {1, 2, 3}));
  CHECK_FALSE(plain.forces[0].declared_axes);
  const Model turned = two_frames(point + force + "in = \"g\"\n");
  CHECK(close(numbers(turned).values(turned.forces[0].value),
              listed(about_z(q) * (about_x(0.4) * Triple{1, 2, 3}))));
  CHECK(turned.forces[0].declared_axes == 1U);
  CHECK(close(numbers(turned).values(turned.forces[0].declared_value), {1, 2, 3}));
  const Model named = two_frames(point + force + "in = \"world\"\n");
  CHECK(close(numbers(named).values(named.forces[0].value), {1, 2, 3}));
}

TEST_CASE("torques are kept in the axes of the frame on which they act", "[frames]") {
  const std::string torque =
      "[parameters.F]\nvalue = 1\nunit = \"N*m\"\n"
      "[[force]]\nframe = \"g\"\nvalue = [\"F\", \"2*F\", \"3*F\"]\n";
  const Model own = two_frames(torque);
  CHECK(own.forces[0].frame == 1U);
  CHECK_FALSE(own.forces[0].reaction_frame);
  CHECK(own.forces[0].reaction.empty());
  CHECK(close(numbers(own).values(own.forces[0].value), {1, 2, 3}));
  const Model world = two_frames(torque + "in = \"world\"\nfrom = \"f\"\n");
  CHECK(world.forces[0].reaction_frame == 0U);
  const Triple in_f = about_z(-q) * Triple{1, 2, 3};
  CHECK(close(numbers(world).values(world.forces[0].value), listed(about_x(-0.4) * in_f)));
  CHECK(close(numbers(world).values(world.forces[0].reaction), listed(in_f)));
  CHECK(two_frames(torque + "from = \"world\"\n").forces[0].reaction.empty());
}

TEST_CASE("the output of a frame is its pose, and its twist in the requested axes", "[frames]") {
  const std::string output = "[[output]]\nname = \"o\"\nframe = \"g\"\njacobian = true\n";
  const Model world = two_frames(output);
  const UserOutput& pose = world.outputs[0];
  CHECK(extent_size(world, Extent::user) == 3);
  CHECK(extent_size(world, Extent::user_columns) == 4);
  CHECK(pose.is_in_world);
  const Rotation3 r = about_z(q) * about_x(0.4);
  CHECK(close(numbers(world).values(pose.values),
              {r[0], r[1], r[2], 0, r[3], r[4], r[5], s, r[6], r[7], r[8], l}));
  CHECK(close(numbers(world).values(pose.twist), {0, 0, q_rate, 0, s_rate, 0}));
  CHECK(two_frames(output + "axes = \"world\"\n").outputs[0].is_in_world);
  const Model own = two_frames(output + "axes = \"g\"\n");
  CHECK_FALSE(own.outputs[0].is_in_world);
  const Triple spin = about_x(-0.4) * Triple{0, 0, q_rate};
  const Triple velocity = about_x(-0.4) * (about_z(-q) * Triple{0, s_rate, 0});
  std::vector<double> twist = listed(spin);
  twist.insert(twist.end(), velocity.begin(), velocity.end());
  CHECK(close(numbers(own).values(own.outputs[0].twist), twist));
}

TEST_CASE("a scalar moment of inertia makes a model planar if it has no vectors yet", "[frames]") {
  CHECK(messages(R"toml(format = 1
[model]
name = "m"
[[coordinate]]
name = "q"
[parameters]
J = 1
[[frame]]
name = "f"
parent = "world"
rotate = [["z", "q"]]
[[body]]
name = "b"
frame = "f"
inertia = "J"
)toml") == "E520 5:9 `q`, `J`: no unit, so expressions with it are not checked\n");
}

TEST_CASE("planar models: two components, one inertia, one torque", "[frames]") {
  const Model model = checked(with_frames(R"toml([[frame]]
name = "f"
parent = "world"
translate = ["s", "l"]
rotate = [["z", "q"]]
[[body]]
name = "b"
frame = "f"
mass = "m"
com = ["l", "0"]
inertia = "9*J"
inertia_about = "origin"
[[force]]
frame = "f"
value = "5*F"
[parameters.F]
value = 1
unit = "N*m"
)toml"))
                          .model;
  const ModelNumbers at = numbers(model);
  const Body& body = model.bodies[0];
  CHECK(body.dimension == 2);
  CHECK(close(at.values(body.com), {s + l * std::cos(q), l + l * std::sin(q), 0}));
  CHECK(close(at.values(body.spin), {q_rate}));
  CHECK(close(at.values(body.inertia), {9 * J - m * l * l}));
  CHECK(close(at.values(model.forces[0].value), {0, 0, 5}));
}

TEST_CASE("refused entries in frames", "[frames]") {
  const Rows rows{
      {"[[point]]\nname = \"p\"\nframe = \"ff\"\nat = [\"l\", \"0\", \"0\"]\n",
       "E201 27:10 unknown frame `ff` | did you mean `f`? (frame, line 17)\n"},
      {"[[point]]\nname = \"p\"\nframe = \"f\"\nat = [\"l\", \"0\"]\n",
       "E516 28:6 2 components, but other vectors of this model have 3\n"},
      {"[[body]]\nname = \"b\"\nframe = \"f\"\nmass = \"m\"\ncom = [\"s\", \"0\", \"0\"]\n",
       "E506 29:9 `s` is a coordinate, but a centre of mass takes none | write a variable term in "
       "`[energy] T`\n"},
      {"[[body]]\nname = \"b\"\nframe = \"f\"\nspin = [\"0\", \"0\", \"dot(q)\"]\ninertia = "
       "[\"J\", \"J\", \"J\"]\n",
       "E112 28:1 a body has `frame` or `spin`, not both\n"},
      {"[[body]]\nname = \"b\"\nframe = \"f\"\ninertia = \"J\"\n",
       "E516 28:12 1 moment of inertia for a spatial body | a planar body has 1, a spatial body 3 "
       "or 6: xx yy zz xy xz yz\n"},
      {"[[force]]\nframe = \"f\"\nvalue = \"0\"\n", "E516 27:10 1 component, but a torque has 3\n"},
      {"[[force]]\nframe = \"h\"\nvalue = [\"0\", \"0\", \"0\"]\n",
       "E201 26:10 unknown frame `h`\n"},
      {"[[force]]\nframe = \"f\"\nfrom = \"q\"\nvalue = [\"0\", \"0\", \"0\"]\n",
       "E201 27:9 unknown frame `q`\n"},
      {"[[force]]\nframe = \"f\"\non = \"q\"\nvalue = [\"0\", \"0\", \"0\"]\n",
       "E112 27:1 a force has exactly one of `on`, `at` and `frame`\n"},
      {"[[force]]\nvalue = [\"0\", \"0\", \"0\"]\n",
       "E112 25:1 the force has none of `on`, `at` and `frame`\n"},
      {"[[force]]\nframe = \"f\"\nvalue = [\"m\", \"0\", \"0\"]\n",
       "E403 27:11 `m` is in kg, but a torque is in N*m\n"},
      {"[[output]]\nname = \"o\"\n",
       "E112 25:1 an output has exactly one of `value`, `point` and `frame`\n"},
      {"[[output]]\nname = \"o\"\nvalue = \"q\"\nframe = \"f\"\n",
       "E112 25:1 an output has exactly one of `value`, `point` and `frame`\n"},
      {"[[output]]\nname = \"o\"\nframe = \"f\"\naxes = \"g\"\n",
       "E112 28:9 `axes` is `world` or the frame itself\n"},
      {"[[output]]\nname = \"o\"\nframe = \"h\"\n", "E201 27:10 unknown frame `h`\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(with_two(entries)); });
}

}  // namespace
}  // namespace elgen::test
