// Keys of a scene for the emitted code: [emit], batches, steps and files.
#include <catch2/catch.hpp>

#include "check/scene/scene.hpp"
#include "check_testing.hpp"
#include "elgen/artifacts.hpp"

namespace elgen::test {

namespace {

const std::string batch = "[emit]\nbatch = true\n";

CheckOptions outputs(const std::string& lines) {
  return {.scene = scene_of_block("[outputs]\n" + lines + "\n")};
}

std::string outputs_messages(const std::string& lines) {
  return messages(block(""), outputs(lines));
}

std::vector<std::string> paths(const Emission& emission) {
  Scene scene;
  scene.base_name = "arm";
  scene.emission = emission;
  std::vector<std::string> result;
  for (const Artifact& artifact : requested_artifacts(scene)) result.push_back(artifact.path);
  return result;
}

}  // namespace

TEST_CASE("without [emit] the code is C++, row-major, without Eigen") {
  const Scene scene = block_scene("");
  CHECK(scene.emission.language == LanguageId::cpp);
  CHECK(scene.emission.storage == Storage::row_major);
  CHECK_FALSE(scene.emission.has_eigen_header);
}

TEST_CASE("[emit] sets language, storage and Eigen") {
  const Scene c = block_scene("[emit]\nstorage = \"column-major\"\nlanguage = \"c99\"\n");
  CHECK(c.emission.language == LanguageId::c99);
  CHECK(c.emission.storage == Storage::column_major);
  CHECK(block_scene("[emit]\neigen = true\n").emission.has_eigen_header);
}

TEST_CASE("`files` omits the sidecar and the page, but no code") {
  CHECK(block_scene("").emission.has_sidecar);
  CHECK(block_scene("").emission.has_page);
  const Scene bare = block_scene("[emit]\nfiles = [\"header\"]\n");
  CHECK_FALSE(bare.emission.has_sidecar);
  CHECK_FALSE(bare.emission.has_page);
  CHECK(requested_artifacts(bare).size() == 1);
  CHECK(block_scene("[emit]\nfiles = [\"page\", \"header\"]\n").emission.has_page);
  CHECK(mentions(block_scene_messages("[emit]\nfiles = [\"page\"]\n"),
                 "`files` has no `header`, which is always written"));
}

TEST_CASE("C code has one scalar, float or double") {
  const std::string language = "[emit]\nlanguage = \"c99\"\n";
  CHECK(block_scene("[numeric]\nscalar = [\"float\"]\n" + language).numerics.scalars.size() == 1);
  for (const char* list : {"[\"long double\"]", "[\"float\", \"double\"]"}) {
    INFO(list);
    CHECK(
        mentions(block_scene_messages(std::string("[numeric]\nscalar = ") + list + "\n" + language),
                 "code in `c99` has one scalar"));
  }
}

TEST_CASE("Eigen needs C++") {
  CHECK(mentions(block_scene_messages("[emit]\nlanguage = \"c99\"\neigen = true\n"),
                 "`eigen` needs C++, but `language` is `c99`"));
}

TEST_CASE("a batch is optional, and its accuracy is the best or a given one") {
  CHECK_FALSE(block_scene("").emission.has_batch_header);
  const Scene best = block_scene(batch);
  CHECK(best.emission.has_batch_header);
  CHECK(trigonometry_error(best.numerics, ScalarKind::double_precision) ==
        cln::expt(cln::cl_RA(2), -52));
  CHECK(trigonometry_error(best.numerics, ScalarKind::single_precision) ==
        cln::expt(cln::cl_RA(2), -23));
  const Scene given = block_scene(batch + "[numeric]\ntrigonometry = { max_error = 1e-7 }\n");
  CHECK(given.numerics.trigonometry_error == cln::cl_RA(1) / 10'000'000);
}

TEST_CASE("accuracies that no scalar can reach are E625") {
  const std::string range = "`max_error` is at least 2^-52";
  for (const std::string value : {"0", "-1e-7", "2.2e-16", "1", "\"sqrt(2)/2\""}) {
    INFO(value);
    const std::string said =
        block_scene_messages(batch + "[numeric]\ntrigonometry = { max_error = " + value + " }\n");
    CHECK_THAT(said, Catch::Contains("E625") && Catch::Contains(range));
  }
  const std::string floats =
      "[numeric]\nscalar = [\"float\"]\ntrigonometry = { max_error = 1e-7 }\n";
  CHECK_THAT(block_scene_messages(batch + floats), Catch::Contains("in float is at least 2^-23"));
}

TEST_CASE("without batches, accuracies that lone sines cannot reach are E625") {
  const auto messages = [](const std::string& scalar, const std::string& sines) {
    return block_scene_messages("[numeric]\nscalar = [" + scalar + "]\ntrigonometry = { " + sines +
                                " }\n");
  };
  CHECK(messages("\"double\"", "max_error = 4e-16").empty());
  CHECK_THAT(messages("\"double\"", "max_error = 3.9e-16"),
             Catch::Contains("E625") && Catch::Contains("`max_error` is at least 4e-16"));
  CHECK(messages("\"float\"", "max_error = 2.2e-7").empty());
  CHECK_THAT(messages("\"float\", \"double\"", "max_error = 2.1e-7"),
             Catch::Contains("`max_error` in float is at least 2.2e-7"));
  CHECK_THAT(messages("\"double\"", "max_error = 1e-7, scalar = \"library\""),
             Catch::Contains("`max_error` does not apply to sines of the library"));
}

TEST_CASE("batches need C++ with float and double") {
  CHECK_THAT(block_scene_messages(batch + "language = \"c99\"\n"), Catch::Contains("E611"));
  CHECK_THAT(block_scene_messages(batch + "[numeric]\nscalar = [\"double\", \"long double\"]\n"),
             Catch::Contains("E625") && Catch::Contains("`float` or `double`"));
}

TEST_CASE("sines are emitted in line or called from the library, with or without batches") {
  CHECK_FALSE(block_scene("").numerics.has_library_sines);
  const std::string in_line = "[numeric]\ntrigonometry = { scalar = \"in-line\" }\n";
  CHECK_FALSE(block_scene(in_line).numerics.has_library_sines);
  const std::string library = "[numeric]\ntrigonometry = { scalar = \"library\" }\n";
  CHECK(block_scene(library).numerics.has_library_sines);
  CHECK(block_scene("[emit]\nlanguage = \"c99\"\n" + library).numerics.has_library_sines);
  const Scene both =
      block_scene(batch + "[numeric]\ntrigonometry = { max_error = 1e-7, scalar = \"library\" }\n");
  CHECK(both.numerics.has_library_sines);
  CHECK(both.numerics.trigonometry_error == cln::cl_RA(1) / 10'000'000);
}

TEST_CASE("functions of doubles may compute in another scalar inside, in batches only in float") {
  CHECK(block_scene("").numerics.inner == InnerScalar::same);
  for (const InnerScalarRow& row : inner_scalar_table) {
    const bool is_for_steps = row.kind == InnerScalar::single_precision;
    const std::string inner = (is_for_steps ? "[outputs]\nstep = { method = \"rk4\" }\n" : "") +
                              ("[numeric]\ninner = \"" + std::string(row.name) + "\"\n");
    CHECK(block_scene(inner).numerics.inner == row.kind);
    const bool is_same = row.kind == InnerScalar::same;
    CHECK(block_scene_messages(inner + batch).empty() == (is_same || is_for_steps));
  }
}

TEST_CASE("a wider inner scalar needs C++, double, and no batches or Eigen") {
  const std::string inner = "[numeric]\ninner = \"double-double\"\n";
  for (const char* const header : {"batch", "eigen"}) {
    CHECK_THAT(block_scene_messages(inner + "[emit]\n" + header + " = true\n"),
               Catch::Contains("E628") && Catch::Contains("computes in its own scalars"));
  }
  CHECK_THAT(block_scene_messages(inner + "scalar = [\"float\"]\n"), Catch::Contains("E628"));
  CHECK_THAT(block_scene_messages(inner + "scalar = [\"long double\"]\n"), Catch::Contains("E628"));
  CHECK_THAT(block_scene_messages(inner + "[emit]\nlanguage = \"c99\"\n"),
             Catch::Contains("E611") && Catch::Contains("`inner` needs C++"));
}

TEST_CASE("an inner scalar float is only for accelerations of explicit steps") {
  const std::string inner = "[numeric]\ninner = \"float\"\n";
  const auto messages = [&inner](const std::string& outputs) {
    return block_scene_messages("[outputs]\n" + outputs + inner);
  };
  CHECK(messages("step = { method = \"rk4\" }\n").empty());
  CHECK(messages("step = { method = \"verlet\" }\n").empty());
  CHECK_THAT(messages("step = { method = \"rk4\" }\nbias = true\n"),
             Catch::Contains("E628") && Catch::Contains("`bias` is no `step`"));
  CHECK_THAT(messages("step = { method = \"midpoint\" }\n"),
             Catch::Contains("E628") && Catch::Contains("`midpoint` calls no accelerations"));
  CHECK_THAT(block_scene_messages(inner), Catch::Contains("E628"));
}

TEST_CASE("a step needs a method") {
  const Scene scene =
      checked(block(""), outputs("step = { method = \"verlet\" }\nmass_matrix = true")).scene;
  REQUIRE(scene.outputs.size() == 2);
  CHECK(scene.outputs[1].kind == OutputKind::step);
  CHECK(scene.outputs[1].step == default_step(StepMethod::verlet));
  CHECK_FALSE(scene.outputs[0].step);
  CHECK(scene.outputs[1].name == "step");
  const Scene renamed =
      checked(block(""), outputs("step = { method = \"rk4\", rename = \"advance\" }")).scene;
  CHECK(renamed.outputs[0].step == default_step(StepMethod::rk4));
  CHECK(renamed.outputs[0].name == "advance");
}

TEST_CASE("an implicit method has its default number of iterations, or the number in the scene") {
  const auto iterations = [](const std::string& entry) {
    return checked(block(""), outputs("step = " + entry)).scene.outputs[0].step->iterations;
  };
  CHECK(iterations("{ method = \"midpoint\" }") == 8);
  CHECK(iterations("{ method = \"midpoint\", iterations = 1 }") == 1);
  CHECK(iterations("{ method = \"midpoint\", iterations = 20 }") == 20);
  CHECK(iterations("{ method = \"rk4\" }") == 0);
}

TEST_CASE("iterations out of range or for an explicit method are E626") {
  CHECK(outputs_messages("step = { method = \"midpoint\", iterations = 0 }") ==
        "E626 5:44 `iterations` `0` is not one of 1 to 20\n");
  CHECK(outputs_messages("step = { method = \"midpoint\", iterations = 21 }") ==
        "E626 5:44 `iterations` `21` is not one of 1 to 20\n");
  CHECK(outputs_messages("step = { method = \"verlet\", iterations = 2 }") ==
        "E626 5:29 `verlet` is explicit, so it has no iterations\n");
  CHECK_THAT(outputs_messages("bias = { iterations = 2 }"),
             Catch::StartsWith("E103 5:10 `bias` has no `iterations`"));
}

TEST_CASE("a step has the order of its method, or a higher order by composition") {
  const auto order = [](const std::string& entry) {
    return checked(block(""), outputs("step = " + entry)).scene.outputs[0].step->composed_order;
  };
  CHECK(order("{ method = \"verlet\" }") == 0);
  CHECK(order("{ method = \"verlet\", order = 2 }") == 0);
  CHECK(order("{ method = \"verlet\", order = 4 }") == 4);
  CHECK(order("{ method = \"midpoint\", order = 8, iterations = 5 }") == 8);
  CHECK(order("{ method = \"rk4\", order = 4 }") == 0);
}

TEST_CASE("orders that a method cannot have are E647") {
  CHECK(outputs_messages("step = { method = \"verlet\", order = 3 }") ==
        "E647 5:37 `verlet` has no order `3` | it has 2, 4, 8\n");
  CHECK(outputs_messages("step = { method = \"midpoint\", order = 6 }") ==
        "E647 5:39 `midpoint` has no order `6` | it has 2, 4, 8\n");
  CHECK(outputs_messages("step = { method = \"verlet\", order = -8 }") ==
        "E647 5:37 `verlet` has no order `-8` | it has 2, 4, 8\n");
  CHECK(outputs_messages("step = { method = \"rk4\", order = 8 }") ==
        "E647 5:34 `rk4` has no order `8` | it has 4\n");
  CHECK_THAT(outputs_messages("bias = { order = 4 }"),
             Catch::StartsWith("E103 5:10 `bias` has no `order`"));
}

TEST_CASE("a step of a model with constraints may project, other outputs may not") {
  const std::string wall = block("[[constraint]]\nname = \"wall\"\nequation = \"x = 0\"\n");
  const auto projects = [&](const std::string& more) {
    const std::string entry = "step = { method = \"rk4\"" + more + " }";
    return checked(wall, outputs(entry)).scene.outputs[0].step->projects;
  };
  CHECK_FALSE(projects(""));
  CHECK_FALSE(projects(", projected = false"));
  CHECK(projects(", projected = true"));
  CHECK(outputs_messages("step = { method = \"rk4\", projected = true }") ==
        "E539 5:26 `projected` needs a `[[constraint]]`, but the model has none\n");
  CHECK(outputs_messages("step = { method = \"rk4\", projected = false }").empty());
  CHECK(outputs_messages("step_derivatives = { method = \"rk4\", projected = true }") ==
        "E103 5:38 `step_derivatives` has no `projected`: `step` has one\n");
  CHECK_THAT(outputs_messages("step_derivatives = { projected = true }"),
             Catch::Contains("E103 5:22 `step_derivatives` has no `projected`: `step` has one\n"));
  CHECK_THAT(outputs_messages("bias = { projected = true }"),
             Catch::StartsWith("E103 5:10 `bias` has no `projected`"));
}

TEST_CASE("a model without a scene has no step") {
  for (const OutputRequest& output : checked(block("")).scene.outputs) {
    CHECK(output.kind != OutputKind::step);
  }
}

TEST_CASE("a step without a method is E105, a method for another output E103") {
  const std::string missing = "E105 5:1 `step` needs a `method`: give it in a scene";
  CHECK_THAT(outputs_messages("step = true"), Catch::StartsWith(missing));
  CHECK_THAT(outputs_messages("step = { rename = \"advance\" }"), Catch::StartsWith(missing));
  CHECK(outputs_messages("step = false\nbias = true").empty());
  CHECK_THAT(messages(block(""), {.outputs = {"step"}}),
             Catch::Contains("E105") && Catch::Contains("a scene"));
  CHECK_THAT(outputs_messages("bias = { method = \"rk4\" }"),
             Catch::StartsWith("E103 5:10 `bias` has no `method`"));
}

TEST_CASE("an unknown method is E620, with the list of methods") {
  CHECK(outputs_messages("step = { method = \"rk5\" }") ==
        "E620 5:20 `step` has no method `rk5` | did you mean `rk4`?\n");
  CHECK(outputs_messages("step = { method = \"dopri5\" }") ==
        "E620 5:20 `step` has no method `dopri5` | one of rk4, verlet, midpoint, which are "
        "straight-line code\n");
}

TEST_CASE("the names of all files are known before the derivation, the header first") {
  Emission emission;
  CHECK(paths(emission) ==
        std::vector<std::string>{"arm/arm.hpp", "arm/arm.equations.json", "arm/arm.md"});
  emission.has_eigen_header = true;
  CHECK(paths(emission) == std::vector<std::string>{"arm/arm.hpp", "arm/arm_eigen.hpp",
                                                    "arm/arm.equations.json", "arm/arm.md"});
  emission = {};
  emission.language = LanguageId::c99;
  CHECK(paths(emission) ==
        std::vector<std::string>{"arm/arm.h", "arm/arm.equations.json", "arm/arm.md"});
}

}  // namespace elgen::test
