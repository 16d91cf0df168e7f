// Named things come after what they need, whatever the order of declaration.
#include "formulate/entities.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("definitions, prescribed motions and points are ordered by need") {
  const CheckedModel checked = checked_model(model_text("ordered", R"toml(
[[coordinate]]
name = "x"
[parameters]
m = 1
[define]
late = "early*x(tip)"
early = "2*phi"
[[prescribed]]
name = "phi"
value = "m*t^2"
[[point]]
name = "tip"
at = ["x(base) + early", "x"]
[[point]]
name = "base"
at = ["x", "0"]
mass = "m"
)toml"));
  std::vector<std::string> names;
  for (const Entity& entity : entities_in_order(checked.model)) {
    const Model& model = checked.model;
    names.push_back(entity.kind == EntityKind::point        ? model.points[entity.index].name
                    : entity.kind == EntityKind::prescribed ? model.prescribed[entity.index].name
                                                            : model.definitions[entity.index].name);
  }
  CHECK(names == std::vector<std::string>{"phi", "early", "base", "tip", "late"});
}

TEST_CASE("frames come before what is placed in them, after their parents", "[frames]") {
  const CheckedModel checked = checked_model(model_text("ordered", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 1
[define]
angle = "2*q"
height = "z(tip)"
[[point]]
name = "tip"
frame = "lower"
at = ["m", "0", "0"]
mass = "m"
[[frame]]
name = "lower"
parent = "upper"
rotate = [["z", "angle"]]
[[frame]]
name = "upper"
parent = "world"
translate = ["0", "0", "m"]
)toml"));
  std::vector<std::string> names;
  for (const Entity& entity : entities_in_order(checked.model)) {
    const Model& model = checked.model;
    names.push_back(entity.kind == EntityKind::point   ? model.points[entity.index].name
                    : entity.kind == EntityKind::frame ? model.frames[entity.index].name
                                                       : model.definitions[entity.index].name);
  }
  CHECK(names == std::vector<std::string>{"angle", "upper", "lower", "tip", "height"});
}

TEST_CASE("a point that only a step of a frame or a body mentions is needed", "[frames]") {
  const std::string arm = R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 1
[[frame]]
name = "arm"
parent = "world"
rotate = [["z", "q"]]
[[point]]
name = "tip"
frame = "arm"
at = ["m", "0", "0"]
)toml";
  const auto tips = [&](const std::string& rest) {
    const Model model = checked_model(model_text("needed", arm + rest)).model;
    const std::vector<Entity> order = entities_in_order(model);
    return std::count_if(order.begin(), order.end(),
                         [](const Entity& entity) { return entity.kind == EntityKind::point; });
  };
  const std::string bob = "[[body]]\nname = \"bob\"\nmass = \"m\"\n";
  CHECK(tips(bob + "com = [\"q\", \"0\", \"0\"]\n") == 0);
  CHECK(tips(bob + "com = [\"x(tip)\", \"0\", \"0\"]\n") == 1);
  CHECK(tips(bob + "com = [\"q\", \"0\", \"0\"]\ninertia = [\"m\", \"m\", \"m\"]\n"
                   "spin = [\"0\", \"0\", \"dot(y(tip))\"]\n") == 1);
  const std::string hung = "[[frame]]\nname = \"hung\"\nparent = \"world\"\n";
  CHECK(tips(hung + "translate = [\"x(tip)\", \"0\", \"0\"]\n" + bob +
             "frame = \"hung\"\ncom = [\"0\", \"0\", \"m\"]\n") == 1);
  CHECK(tips(hung + "rotate = [[\"x\", \"x(tip)/m\"]]\n" + bob +
             "frame = \"hung\"\ncom = [\"0\", \"0\", \"m\"]\n") == 1);
}

TEST_CASE("expressions with shared parts are read once") {
  // As a tree the rotation of fourteen slanted axes has 9^14 nodes.
  std::string axes;
  for (int i = 0; i < 14; ++i) axes += R"toml([["1", "2", "2"], "q"], )toml";
  const Model model = checked_model(model_text("slanted", R"toml(
[[coordinate]]
name = "q"
[parameters]
m = 1
[[frame]]
name = "arm"
parent = "world"
rotate = [)toml" + axes + R"toml(]
[[body]]
name = "bob"
frame = "arm"
mass = "m"
com = ["1", "2", "3"]
[[output]]
name = "pose"
frame = "arm"
)toml"))
                          .model;
  CHECK(entities_in_order(model).size() == 1);
  CHECK(formulate(model));
}

TEST_CASE("a long chain declared backwards is ordered without recursion") {
  std::string text =
      "[[coordinate]]\nname = \"x\"\n[parameters]\nk = 1\n[energy]\nT = \"k*dot(x)^2\"\n[define]\n";
  for (int i = 4000; i > 0; --i) {
    text += "d" + std::to_string(i) + " = \"d" + std::to_string(i - 1) + " + 1\"\n";
  }
  text += "d0 = \"x\"\n";
  const auto order = entities_in_order(checked_model(model_text("chain", text)).model);
  REQUIRE(order.size() == 4001);
  CHECK(order.front().index == 4000);
  CHECK(order.back().index == 0);
}
