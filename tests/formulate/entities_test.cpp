// Named things come after what they need, whatever the order of declaration.
#include "formulate/entities.hpp"

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
