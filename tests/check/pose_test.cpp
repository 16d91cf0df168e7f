// Poses: exact at right angles, small over their parents, and turning as their rotation does.
#include "check/entries/pose.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"
#include "model_numbers.hpp"

namespace elgen::test {
namespace {

/// "1 0 0 0 0 -1 0 1 0"
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

TEST_CASE("right angles give the numbers 0, 1 and -1", "[frames]") {
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

TEST_CASE("a turn about a coordinate axis is a sine and a cosine", "[frames]") {
  CHECK(rotation_of("rotate = [[\"z\", \"q\"]]\n") == "cos(q) -sin(q) 0 sin(q) cos(q) 0 0 0 1");
}

TEST_CASE("a pose is written over that of its parent, not over the parent's parent", "[frames]") {
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

}  // namespace
}  // namespace elgen::test
