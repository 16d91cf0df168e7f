// Frames: all keys for translation and rotation, poses, spins, and refusals.
#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "model_numbers.hpp"

namespace elgen::test {

namespace {

/// The pose in the world of a frame with `keys`, at q and s: the rotation by rows, then the origin.
std::vector<double> pose_of(const std::string& keys) {
  const Model model =
      checked(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\n" + keys)).model;
  return ModelNumbers(model, {q, s}, {0, 0}).pose(0);
}

/// The rotation by `angle` about the unit vector n, by Rodrigues' formula: 1 + sin(angle) K + (1 -
/// cos(angle)) K K with K r = n x r.
Rotation3 rotation_about(const Triple& n, double angle) {
  const Rotation3 k{0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0};
  const Rotation3 square = k * k;
  Rotation3 result{1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 9; ++i) {
    result[i] += std::sin(angle) * k[i] + (1 - std::cos(angle)) * square[i];
  }
  return result;
}

/// The rotation of the frame in row-major order, such as "1 0 0 0 0 -1 0 1 0".
std::string rotation_text(const Model& model, std::size_t frame) {
  std::string text;
  for (const ExpressionId id : model.frames[frame].rotation) {
    text += (text.empty() ? "" : " ") + to_string(model, id);
  }
  return text;
}

std::string rotation_of(const std::string& keys) {
  return rotation_text(
      checked(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\n" + keys)).model, 0);
}

/// A model with a planar point and a frame whose keys start on line 22.
std::string planar(const std::string& keys) {
  return with_frames(
      "[[point]]\nname = \"p\"\nat = [\"s\", \"0\"]\n"
      "[[frame]]\nname = \"f\"\nparent = \"world\"\n" +
      keys);
}

}  // namespace

TEST_CASE("the parent of a frame is the world by default", "[frames]") {
  const std::string turn = "rotate = [[\"z\", \"q\"]]\n";
  CHECK(dump(checked(with_frames("[[frame]]\nname = \"f\"\n" + turn)).model) ==
        dump(checked(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\n" + turn)).model));
}

TEST_CASE("a frame without rotation has the axes of its parent", "[frames]") {
  CHECK(close(pose_of(""), as_pose(about_x(0), {0, 0, 0})));
  CHECK(close(pose_of("translate = [\"s\", \"l\", \"0\"]\n"), as_pose(about_x(0), {s, l, 0})));
}

TEST_CASE("successive rotations are about the rotated axes", "[frames]") {
  CHECK(close(pose_of("rotate = [[\"x\", \"q\"]]\n"), as_pose(about_x(q), {0, 0, 0})));
  CHECK(close(pose_of("rotate = [[\"y\", \"q\"]]\n"), as_pose(about_y(q), {0, 0, 0})));
  CHECK(close(pose_of("rotate = [[\"z\", \"q\"]]\n"), as_pose(about_z(q), {0, 0, 0})));
  CHECK(close(pose_of("translate = [\"0\", \"s\", \"l\"]\n"
                      "rotate = [[\"x\", \"q\"], [\"z\", \"2*q\"], [\"y\", \"0.4\"]]\n"),
              as_pose(about_x(q) * about_z(2 * q) * about_y(0.4), {0, s, l})));
}

TEST_CASE("axes may be three constants of any length", "[frames]") {
  CHECK(close(pose_of("rotate = [[[\"1\", \"2\", \"2\"], \"q\"]]\n"),
              as_pose(rotation_about({1.0 / 3, 2.0 / 3, 2.0 / 3}, q), {0, 0, 0})));
  const double h = std::sqrt(0.5);
  CHECK(close(pose_of("rotate = [[[\"0\", \"-1\", \"1\"], \"q\"], [[1, 0, 0], \"q\"]]\n"),
              as_pose(rotation_about({0, -h, h}, q) * about_x(q), {0, 0, 0})));
  CHECK(close(pose_of("rotate = [[[\"0\", \"0\", \"-2\"], \"q\"]]\n"),
              as_pose(about_z(-q), {0, 0, 0})));
}

TEST_CASE("a constant axis has exactly length one", "[frames]") {
  const Model model = checked(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\nrotate = "
                                          "[[[\"2\", \"3\", \"6\"], \"q\"]]\n"))
                          .model;
  const Vector3& axis = model.frames[0].transforms[0].vector;
  CHECK(to_string(model, axis[0]) == "2/7");
  CHECK(to_string(model, axis[1]) == "3/7");
  CHECK(to_string(model, axis[2]) == "6/7");
}

TEST_CASE("irrational components of an axis keep their form", "[frames]") {
  const auto frame = [](const std::string& axis) {
    return checked(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\nrotate = [[" + axis +
                               ", \"q\"]]\n"));
  };
  const Model model = frame("[\"cos(1)\", \"0\", \"2*sqrt(3)\"]").model;
  const Vector3& axis = model.frames[0].transforms[0].vector;
  CHECK(to_string(model, axis[0]) == "cos(1)*(cos(1)*cos(1) + 2*sqrt(3)*(2*sqrt(3)))^(-1/2)");
  CHECK(to_string(model, axis[1]) == "0");
  CHECK(close(pose_of("rotate = [[[\"cos(1)\", \"-sin(1)\", \"0\"], \"q\"]]\n"),
              as_pose(rotation_about({std::cos(1.0), -std::sin(1.0), 0}, q), {0, 0, 0})));
}

TEST_CASE("rpy are rotations about the fixed axes x, y, z in this order", "[frames]") {
  CHECK(close(pose_of("rpy = [\"q\", \"0.2\", \"-q\"]\n"),
              as_pose(about_z(-q) * about_y(0.2) * about_x(q), {0, 0, 0})));
}

TEST_CASE("Denavit-Hartenberg parameters in the standard and the modified convention", "[frames]") {
  const std::string values = "a = \"l\", alpha = \"0.4\", d = \"s\", theta = \"q\" }\n";
  const Rotation3 theta = about_z(q);
  CHECK(close(pose_of("dh = { convention = \"standard\", " + values),
              as_pose(theta * about_x(0.4), Triple{0, 0, s} + theta * Triple{l, 0, 0})));
  const Rotation3 alpha = about_x(0.4);
  CHECK(close(pose_of("dh = { convention = \"modified\", " + values),
              as_pose(alpha * theta, Triple{l, 0, 0} + alpha * Triple{0, 0, s})));
  CHECK(close(pose_of("translate = [\"l\", \"s\", \"0\"]\n"
                      "dh = { convention = \"standard\", theta = \"q\" }\n"),
              as_pose(theta, {l, s, 0})));
}

TEST_CASE("quaternions may have any length except 0, the scalar first", "[frames]") {
  CHECK(close(pose_of("quaternion = [\"cos(q/2)\", \"0\", \"sin(q/2)\", \"0\"]\n"),
              as_pose(about_y(q), {0, 0, 0})));
  CHECK(close(pose_of("quaternion = [\"2\", \"0\", \"0\", \"2\"]\n"),
              as_pose(about_z(std::acos(0.0)), {0, 0, 0})));
  // The quaternion (w, e) rotates by 2 atan(|e|/w) about e.
  const double length = std::sqrt(q * q + 4 + 0.01);
  CHECK(close(
      pose_of("quaternion = [\"3\", \"q\", \"2\", \"0.1\"]\n"),
      as_pose(rotation_about({q / length, 2 / length, 0.1 / length}, 2 * std::atan(length / 3)),
              {0, 0, 0})));
}

TEST_CASE("frames may precede their parents, and may have the names of bodies", "[frames]") {
  const Model model = checked(with_frames(R"toml([[frame]]
name = "f"
parent = "g"
translate = ["l", "0", "0"]
rotate = [["x", "q"]]
[[frame]]
name = "g"
parent = "world"
doc = "the first"
translate = ["0", "s", "0"]
rotate = [["z", "q"]]
[[body]]
name = "f"
frame = "g"
mass = "m"
com = ["0", "0", "0"]
)toml"))
                          .model;
  CHECK(model.frames[0].parent == 1U);
  CHECK(model.frames[1].doc == "the first");
  const Rotation3 parent = about_z(q);
  CHECK(close(ModelNumbers(model, {q, s}, {0, 0}).pose(0),
              as_pose(parent * about_x(q), Triple{0, s, 0} + parent * Triple{l, 0, 0})));
}

TEST_CASE("refused frames", "[frames]") {
  const Rows rows{
      {"name = \"f\"\nparent = \"worl\"\n",
       "E201 18:11 unknown frame `worl` | did you mean `world`?\n"},
      {"name = \"world\"\nparent = \"world\"\n",
       "E204 17:9 `world` is reserved for the frame that does not move | `world_1` is free\n"},
      {"name = \"f\"\nparent = \"f\"\n", "E206 17:9 `f` is defined by itself: f -> f\n"},
      {"name = \"f\"\nparent = \"g\"\n[[frame]]\nname = \"g\"\nparent = \"f\"\n",
       "E206 17:9 `f` is defined by itself: f -> g -> f\n"},
      {"name = \"f\"\nparent = \"world\"\n[[frame]]\nname = \"f\"\nparent = \"world\"\n",
       "E203 20:9 `f` is already a frame | first at line 17\n"},
      {"name = \"first\"\nparent = \"world\"\n[[frame]]\nname = \"g\"\nparent = \"fisrt\"\n",
       "E201 21:11 unknown frame `fisrt` | did you mean `first`? (frame, line 17)\n"},
      {"name = \"f\"\nparent = \"world\"\nrpy = [\"q\", \"0\", \"0\"]\nrotate = [[\"x\", \"q\"]]\n",
       "E112 20:1 a frame has at most one of `rotate`, `rpy`, `dh`, `quaternion` and `rotation`\n"},
      {"name = \"f\"\nparent = \"world\"\nrotate = [[\"w\", \"q\"]]\n",
       "E112 19:13 `w` is no axis: an axis is `x`, `y`, `z` or three constants\n"},
      {"name = \"f\"\nparent = \"world\"\nrotate = [[[\"0\", \"0\", \"0\"], \"q\"]]\n",
       "E112 19:12 an axis of length 0 has no direction\n"},
      {"name = \"f\"\nparent = \"world\"\nrotate = [[[\"q\", \"0\", \"0\"], \"q\"]]\n",
       "E319 19:14 `q` is not a constant number\n"},
      {"name = \"f\"\nparent = \"world\"\nrotate = [[\"x\", \"l\"]]\n",
       "E403 19:18 `l` is in m, but an angle is in 1\n"},
      {"name = \"f\"\nparent = \"world\"\nrotate = [[\"x\", \"dot(q)\"]]\n",
       "E319 19:18 `dot(q)` is a rate, but an angle takes none\n"},
      {"name = \"f\"\nparent = \"world\"\ntranslate = [\"q\", \"0\", \"0\"]\n",
       "E403 19:15 `q` is in 1, but a position is in m\n"},
      {"name = \"f\"\nparent = \"world\"\ntranslate = [\"l\"]\n",
       "E104 19:13 1 component, but a vector has 2 or 3\n"},
      {"name = \"f\"\nparent = \"world\"\nrpy = [\"q\", \"0\"]\n",
       "E104 19:7 2 components, but `rpy` has 3\n"},
      {"name = \"f\"\nparent = \"world\"\nquaternion = [\"1\", \"0\", \"0\"]\n",
       "E104 19:14 3 components, but a quaternion has 4\n"},
      {"name = \"f\"\nparent = \"world\"\nquaternion = [\"0\", \"0\", \"0\", \"0\"]\n",
       "E112 19:14 a quaternion of length 0 is no orientation\n"},
      {"name = \"f\"\nparent = \"world\"\nrotation = \"attitude\"\n",
       "E201 19:13 unknown rotation `attitude`\n"},
  };
  check_rows(rows,
             [&](const std::string& keys) { return messages(with_frames("[[frame]]\n" + keys)); });
}

TEST_CASE("right angles give rotation matrices of 0, 1 and -1", "[frames]") {
  CHECK(rotation_of("") == "1 0 0 0 1 0 0 0 1");
  CHECK(rotation_of("rotate = [[\"x\", \"pi/2\"]]\n") == "1 0 0 0 0 -1 0 1 0");
  CHECK(rotation_of("rotate = [[\"y\", \"pi/2\"]]\n") == "0 0 1 0 1 0 -1 0 0");
  CHECK(rotation_of("rotate = [[\"z\", \"-pi/2\"]]\n") == "0 1 0 -1 0 0 0 0 1");
  CHECK(rotation_of("rotate = [[\"z\", \"pi\"]]\n") == "-1 0 0 0 -1 0 0 0 1");
  CHECK(rotation_of("rpy = [\"pi/2\", \"0\", \"pi/2\"]\n") == "0 0 1 1 0 0 0 1 0");
  CHECK(rotation_of("quaternion = [\"1\", \"1\", \"0\", \"0\"]\n") == "1 0 0 0 0 -1 0 1 0");
  CHECK(rotation_of("dh = { convention = \"standard\", alpha = \"-pi/2\" }\n") ==
        "1 0 0 0 0 1 0 -1 0");
}

TEST_CASE("a rotation about a coordinate axis is a sine and a cosine", "[frames]") {
  CHECK(rotation_of("rotate = [[\"z\", \"q\"]]\n") == "cos(q) -sin(q) 0 sin(q) cos(q) 0 0 0 1");
}

TEST_CASE("a pose refers to the pose of its parent, so that its size does not grow along a chain",
          "[frames]") {
  std::string text;
  for (int i = 1; i <= 30; ++i) {
    const std::string parent = i == 1 ? "world" : "f" + std::to_string(i - 1);
    text += "[[frame]]\nname = \"f" + std::to_string(i) + "\"\nparent = \"" + parent +
            "\"\ntranslate = [\"l\", \"s\", \"0\"]\nrotate = [[\"x\", \"q\"], [\"z\", \"q\"]]\n";
  }
  const auto nodes = [&](std::size_t count) {
    const std::string cut =
        text.substr(0, text.find("[[frame]]\nname = \"f" + std::to_string(count + 1) + "\""));
    return checked(with_frames(cut)).model.expressions.size();
  };
  CHECK(nodes(29) - nodes(19) == nodes(19) - nodes(9));
}

TEST_CASE("the spin is the angular velocity in the axes of the frame", "[frames]") {
  const Model model = checked(with_frames(R"toml([[frame]]
name = "upper"
parent = "world"
rotate = [["z", "q"]]
[[frame]]
name = "lower"
parent = "upper"
translate = ["l", "0", "0"]
rotate = [["x", "s/l"], ["y", "0.4"]]
[[frame]]
name = "rigid"
parent = "world"
rotate = [["z", "pi/3"]]
[[frame]]
name = "tumbling"
parent = "world"
quaternion = ["2*cos(q/2)", "2*sin(q/2)", "0", "0"]
)toml"))
                          .model;
  const ModelNumbers at(model, {q, s}, {q_rate, s_rate});
  const auto spin = [&](std::size_t frame) { return at.values(model.frames[frame].spin); };
  CHECK(close(spin(0), {0, 0, q_rate}));
  const Triple before = about_x(-s / l) * Triple{0, 0, q_rate} + Triple{s_rate / l, 0, 0};
  CHECK(close(spin(1), listed(about_y(-0.4) * before)));
  for (const ExpressionId id : model.frames[2].spin) CHECK(to_string(model, id) == "0");
  CHECK(close(spin(3), {q_rate, 0, 0}));
}

TEST_CASE("angular velocities between frames agree with R^T dR/dt", "[frames]") {
  const Model model = checked(with_frames(R"toml([[frame]]
name = "upper"
parent = "world"
rotate = [["z", "q"], [[1, 2, -2], "q*s/l"]]
[[frame]]
name = "lower"
parent = "upper"
translate = ["l", "0", "s"]
quaternion = ["1 + s/l", "sin(q)", "q*s/l", "cos(2*q)"]
[[frame]]
name = "tip"
parent = "lower"
rpy = ["s/l", "0.3", "q^2"]
)toml"))
                          .model;
  const ModelNumbers at(model, {q, s}, {q_rate, s_rate});
  for (const Frame& frame : model.frames) {
    INFO(frame.name);
    const std::vector<double> spin = at.values(frame.spin);
    const std::vector<double> turn = at.values(frame.rotation);
    CHECK(close(at.values(frame.recursive_spin), spin));
    Rotation3 rotation{};
    std::copy(turn.begin(), turn.end(), rotation.begin());
    CHECK(close(at.values(frame.angular_velocity),
                listed(rotation * Triple{spin[0], spin[1], spin[2]})));
  }
}

TEST_CASE("rotations about z and translations in the plane stay in the plane", "[frames]") {
  for (const char* keys :
       {"translate = [\"l\", \"s\"]\nrotate = [[\"z\", \"q\"]]\n",
        "rotate = [[[\"0\", \"0\", \"-2\"], \"q\"], [\"x\", \"0\"], [\"y\", \"sin(pi)\"]]\n",
        "rpy = [\"0\", \"0\", \"q\"]\n", "quaternion = [\"1\", \"0\", \"0\", \"q\"]\n",
        "dh = { convention = \"standard\", theta = \"q\", a = \"l\" }\n"}) {
    INFO(keys);
    CHECK(messages(planar(keys)) == "");
  }
}

TEST_CASE("motion out of the plane is refused at its position", "[frames]") {
  const Rows rows{
      {"rotate = [[\"z\", \"q\"], [\"x\", \"2*q\"]]\n",
       "E516 22:30 `2*q` turns out of the plane of a model whose vectors have 2 components\n"},
      {"rotate = [[[\"0\", \"1\", \"1\"], \"q\"]]\n",
       "E516 22:30 `q` turns out of the plane of a model whose vectors have 2 components\n"},
      {"rpy = [\"0\", \"pi\", \"q\"]\n",
       "E516 22:14 `pi` turns out of the plane of a model whose vectors have 2 components\n"},
      {"quaternion = [\"1\", \"0\", \"q\", \"0\"]\n",
       "E516 22:26 `q` turns out of the plane of a model whose vectors have 2 components\n"},
      {"dh = { convention = \"modified\", theta = \"q\", d = \"l\" }\n",
       "E516 22:51 `l` shifts out of the plane of a model whose vectors have 2 components\n"},
      {"translate = [\"l\", \"0\", \"0\"]\n",
       "E516 18:6 2 components, but other vectors of this model have 3\n"},
  };
  check_rows(rows, [&](const std::string& keys) { return messages(planar(keys)); });
}

TEST_CASE("frames of spatial models may have any rotation", "[frames]") {
  CHECK(messages(with_frames("[[frame]]\nname = \"f\"\nparent = \"world\"\n"
                             "translate = [\"l\", \"0\", \"0\"]\nrpy = [\"q\", \"q\", \"q\"]\n")) ==
        "");
}

}  // namespace elgen::test
