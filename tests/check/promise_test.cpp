// `max_error` and `ranges` of a scene.
#include <catch2/catch.hpp>

#include "check/scene/scene.hpp"
#include "check_testing.hpp"

namespace elgen::test {

TEST_CASE("a scene promises a maximum error inside ranges") {
  CHECK_FALSE(block_scene("").numerics.max_error);
  const Numerics numerics = block_scene(
                                "[numeric]\nmax_error = 1e-6\n"
                                "ranges = { x = [\"-pi\", 0.1], \"dot(x)\" = [0, 0], "
                                "\"dot(dot(x))\" = [-1, 1], t = [0, 1] }\n")
                                .numerics;
  CHECK(numerics.max_error == 1e-6);
  REQUIRE(numerics.ranges.size() == 4);
  CHECK(numerics.ranges[0].low == -3.141592653589793);
  CHECK(numerics.ranges[1].name == "dot(x)");
  CHECK(numerics.ranges[1].high == 0);
}

TEST_CASE("maximum errors that are impossible or not measured are E640") {
  for (const std::string value : {"0", "-1e-6", "\"1 - pi\""}) {
    INFO(value);
    CHECK_THAT(block_scene_messages("[numeric]\nmax_error = " + value + "\n"),
               Catch::Contains("E640") && Catch::Contains(" is not positive"));
  }
  CHECK_THAT(
      block_scene_messages("[numeric]\nscalar = [\"long double\"]\nmax_error = 1e-6\n"),
      Catch::Contains("E640") && Catch::Contains("errors are measured in `float` and `double`"));
}

TEST_CASE("ranges of constants and empty ranges are E630") {
  const auto range_messages = [](const std::string& ranges) {
    return block_scene_messages("[numeric]\nranges = { " + ranges + " }\n");
  };
  CHECK_THAT(range_messages("m = [1, 2]"),
             Catch::Contains("E630") &&
                 Catch::Contains("`m` is no coordinate, rate, acceleration or input"));
  CHECK_THAT(range_messages("x = [1, 0]"),
             Catch::Contains("E630") && Catch::Contains("the range `[1, 0]` is empty"));
}

TEST_CASE("ranges of options follow the ranges of the scene and have the same syntax") {
  CheckOptions wanted{.scene = scene_of_block("[numeric]\nranges = { x = [0, 1] }\n")};
  wanted.ranges = {"x=-pi..2", "dot(x)=0..0"};
  const std::vector<NamedRange> ranges = checked(block(), wanted).scene.numerics.ranges;
  REQUIRE(ranges.size() == 3);
  CHECK(ranges[1].low == -3.141592653589793);
  CHECK(ranges[1].high == 2);
  CHECK(ranges[2].name == "dot(x)");
  const auto range_messages = [](const std::string& range) {
    return messages(block(), {.ranges = {range}});
  };
  CHECK(range_messages("x=1..-1") == "E630 1:3 the range `1..-1` is empty\n");
  CHECK(range_messages("x=a..1").starts_with("E201 1:3 "));
  CHECK(range_messages("x=m..1") == "E319 1:3 `m` is not a constant number\n");
  CHECK(range_messages("x") == "E606 1:1 `x` has no value\n");
  CHECK(range_messages("x=1") == "E606 1:3 `1` is no range | write NAME=LOW..HIGH\n");
  CHECK(range_messages("m=0..1").starts_with(
      "E630 1:1 `m` is no coordinate, rate, acceleration or input"));
}

TEST_CASE("parameters vary over the ranges of an option") {
  const auto varied =
      checked(block(), {.over = {"k=1/2..pi", "m=0.1:10"}}).scene.numerics.varied_parameters;
  REQUIRE(varied.size() == 2);
  CHECK(varied.at(0).high == 10);
  CHECK(varied.at(1).low == cln::cl_RA(1) / 2);
  CHECK(cln::double_approx(varied.at(1).high) == 3.141592653589793);
  const auto over_messages = [](const std::string& over, const std::string& scene = {}) {
    return messages(block(), {.scene = scene, .over = {over}});
  };
  CHECK(over_messages("m=10:0.1") == "E112 1:3 `10` is not below `0.1`\n");
  CHECK(over_messages("m=a:1").starts_with("E201 1:3 "));
  CHECK(over_messages("m=1 kg:2 kg").starts_with("E30"));
  CHECK(over_messages("m=1") == "E606 1:3 `1` is no range | write NAME=LOW..HIGH\n");
  CHECK(over_messages("m=1:2,m=2:3") == "E606 1:7 `m` is given twice\n");
  CHECK(over_messages("x=0:1").starts_with("E602 1:1 unknown parameter `x`"));
  CHECK_THAT(over_messages("m=1:2", scene_of_block("[parameters]\nfixed = { m = 2 }\n")),
             Catch::Contains("E606 1:1 `m` is fixed, so it is no parameter\n"));
}

TEST_CASE("the ends of a parameter's range agree with its declaration") {
  const std::string positive =
      replaced(block(), "unit = \"kg\"", "unit = \"kg\", max = 5, assume = \"positive\"");
  CHECK_THAT(messages(positive, {.over = {"m=0:1"}}), Catch::Contains("E112 1:3 "));
  CHECK_THAT(messages(positive, {.over = {"m=1:6"}}),
             Catch::Contains("E518 1:5 `6` is outside `min` or `max` of `m`"));
}

TEST_CASE("verification of an expansion uses the scene without the expansion") {
  const auto expanded = [](bool is_exact) {
    const auto model = parse_model(make_source("model.toml", block("V = \"1/2*k*x^2\"\n")), {});
    const auto scene = parse_scene(make_source("a.scene.toml",
                                               "format = 1\nmodel = \"model.toml\"\nname = \"a\"\n"
                                               "[approximate]\norder = 1\nabout = { x = 0 }\n"),
                                   {});
    SceneOptions options;
    if (is_exact) options.purpose = purpose::verify_expansion;
    const Result<CheckedModel> checked = check(*model, &*scene, options, {});
    REQUIRE(checked);
    return checked->model.approximation.has_value();
  };
  CHECK(expanded(false));
  CHECK_FALSE(expanded(true));
}

}  // namespace elgen::test
