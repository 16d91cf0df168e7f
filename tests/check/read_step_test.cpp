// The method of a step: asked for by name, and by nothing else.
#include "check/scene/read_step.hpp"

#include <catch2/catch.hpp>

#include "check_testing.hpp"

namespace elgen::test {
namespace {

Wanted outputs(const std::string& lines) {
  return {.scene = scene_of_block("[outputs]\n" + lines + "\n")};
}

std::string said_of(const std::string& lines) { return messages(block(""), outputs(lines)); }

}  // namespace

TEST_CASE("a step has the number of its method") {
  const Scene scene =
      checked(block(""), outputs("step = { method = \"verlet\" }\nmass_matrix = true")).scene;
  REQUIRE(scene.outputs.size() == 2);
  CHECK(scene.outputs[1].kind == OutputKind::step);
  CHECK(scene.outputs[1].user == 1);
  CHECK(scene.outputs[1].name == "step");
  const Scene renamed =
      checked(block(""), outputs("step = { method = \"rk4\", rename = \"advance\" }")).scene;
  CHECK(renamed.outputs[0].user == 0);
  CHECK(renamed.outputs[0].name == "advance");
}

TEST_CASE("an implicit method iterates as often as it says, or as is asked for") {
  const auto iterations = [](const std::string& entry) {
    return checked(block(""), outputs("step = " + entry)).scene.outputs[0].iterations;
  };
  CHECK(iterations("{ method = \"midpoint\" }") == 8);
  CHECK(iterations("{ method = \"midpoint\", iterations = 1 }") == 1);
  CHECK(iterations("{ method = \"midpoint\", iterations = 20 }") == 20);
  CHECK(iterations("{ method = \"rk4\" }") == 0);
}

TEST_CASE("iterations out of range, or of an explicit method, are E626") {
  CHECK(said_of("step = { method = \"midpoint\", iterations = 0 }") ==
        "E626 5:44 `iterations` `0` is not one of 1 to 20\n");
  CHECK(said_of("step = { method = \"midpoint\", iterations = 21 }") ==
        "E626 5:44 `iterations` `21` is not one of 1 to 20\n");
  CHECK(said_of("step = { method = \"verlet\", iterations = 2 }") ==
        "E626 5:29 `verlet` is explicit: it iterates nothing\n");
  CHECK_THAT(said_of("bias = { iterations = 2 }"),
             Catch::StartsWith("E103 5:10 `bias` has no `iterations`"));
}

TEST_CASE("a model alone has no step") {
  for (const OutputRequest& output : checked(block("")).scene.outputs) {
    CHECK(output.kind != OutputKind::step);
  }
}

TEST_CASE("a step without a method is E105, a method of anything else E103") {
  const std::string missing = "E105 5:1 `step` needs a `method`, which a scene gives it";
  CHECK_THAT(said_of("step = true"), Catch::StartsWith(missing));
  CHECK_THAT(said_of("step = { rename = \"advance\" }"), Catch::StartsWith(missing));
  CHECK(said_of("step = false\nbias = true").empty());
  Wanted option;
  option.outputs = {"step"};
  CHECK_THAT(messages(block(""), option), Catch::Contains("E105") && Catch::Contains("a scene"));
  CHECK_THAT(said_of("bias = { method = \"rk4\" }"),
             Catch::StartsWith("E103 5:10 `bias` has no `method`"));
}

TEST_CASE("an unknown method is E620, with those there are") {
  CHECK(said_of("step = { method = \"rk5\" }") ==
        "E620 5:20 `step` has no method `rk5` | did you mean `rk4`?\n");
  CHECK(said_of("step = { method = \"dopri5\" }") ==
        "E620 5:20 `step` has no method `dopri5` | one of rk4, verlet, midpoint, which are "
        "straight-line code\n");
}

}  // namespace elgen::test
