// Designs written as scenes.
#include <catch2/catch.hpp>

#include "run/tradeoff/derived.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The text of `design` as a scene, for the model if `scene` is empty, otherwise for the scene with
/// the entries `scene`.
std::string text_of(const Design& design, const std::string& scene = {},
                    const std::string& output = "inverse_dynamics") {
  const Products products = derived(read_model("pushed_pendulum"), output, scene);
  if (scene.empty()) return scene_text({*products.checked}, design, "test.toml");
  const SourcePointer source = make_source(
      "test.scene.toml", "format = 1\nmodel = \"test.toml\"\nname = \"given\"\n" + scene);
  const Result<FileSyntax> syntax = parse_scene(source, Limits{});
  REQUIRE(syntax);
  return scene_text({*products.checked, &*syntax}, design, "test.toml");
}

/// Runs the pipeline with the text as a scene.
Products run(const std::string& text) {
  Products products = run_pipeline({make_source("test.toml", read_model("pushed_pendulum")),
                                    make_source("design.scene.toml", text)},
                                   {.goals = {Goal::emit}});
  INFO(text);
  INFO(format(products.diagnostics));
  REQUIRE(products.files);
  return products;
}

}  // namespace

TEST_CASE("a design of a model is a scene that emits it") {
  const std::string text = text_of({.scalar = ScalarKind::double_precision,
                                    .in_packs = true,
                                    .trigonometry = "1e-7",
                                    .is_fixed = true});
  CHECK(text == R"(format = 1
model = "test.toml"
name = "double_packs_1e7_fixed"

[outputs]
inverse_dynamics = true

[parameters]
fixed = "all"

[numeric]
scalar = ["double"]
trigonometry = { max_error = "1e-7" }

[emit]
batch = true
)");
  const Products products = run(text);
  CHECK(products.files->files.count("pendulum_double_packs_1e7_fixed/"
                                    "pendulum_double_packs_1e7_fixed_batch.hpp") == 1);
}

TEST_CASE("other keys of a scene are kept, and its choices are replaced") {
  const std::string text =
      text_of({.scalar = ScalarKind::single_precision},
              "[outputs]\ninverse_dynamics = { form = \"closed\" }\n"
              "[parameters]\nfixed = { g = 9.8 }\n[numeric]\n"
              "scalar = [\"double\"]\nprefer = \"speed\"\n[emit]\nlanguage = \"c99\"\n");
  CHECK(mentions(text, "name = \"given_float\""));
  CHECK(mentions(text, "inverse_dynamics = { form = \"closed\" }"));
  CHECK(mentions(text, "fixed = { g = \"9.8\" }"));
  CHECK(mentions(text, "scalar = [\"float\"]\nprefer = \"speed\"\n"));
  CHECK_FALSE(mentions(text, "c99"));
  (void)run(text);
}

TEST_CASE("a design as typed demands the recursive form, and rewrites nothing") {
  const std::string closed =
      "[outputs]\ninverse_dynamics = { form = \"closed\" }\n[numeric]\nform = \"closed\"\n";
  for (const std::string& scene : {std::string(), closed}) {
    const std::string text = text_of({.is_typed = true}, scene);
    CHECK(mentions(text, "_typed\"\n"));
    CHECK(mentions(text, "inverse_dynamics = true\n"));
    CHECK(mentions(text, "scalar = [\"double\"]\nform = \"recursive\"\nprefer = \"speed\"\n"));
    CHECK(run(text).program->functions.front().form == Form::recursive);
  }
}

TEST_CASE("a design with a wider scalar is a scene with `inner`") {
  const std::string text = text_of({.inner = InnerScalar::double_double}, {});
  CHECK(mentions(text, "_in_doubledouble\"\n"));
  CHECK(mentions(text, "scalar = [\"double\"]\ninner = \"double-double\"\n"));
  CHECK(run(text).checked->scene.numerics.inner == InnerScalar::double_double);
}

TEST_CASE("only a design with the library's sines has the key `trigonometry`") {
  const std::string library = "[numeric]\ntrigonometry = { scalar = \"library\" }\n";
  const std::string text = text_of({.trigonometry = "library"});
  CHECK(mentions(text, "_library\"\n"));
  CHECK(mentions(text, "\ntrigonometry = { scalar = \"library\" }\n"));
  CHECK(run(text).checked->scene.numerics.has_library_sines);
  CHECK_FALSE(mentions(text_of({}, library), "library"));
  CHECK(mentions(text_of({.step = default_step(StepMethod::rk4)}, library), "\"library\""));
  const std::string rough = "[numeric]\ntrigonometry = { max_error = 1e-9 }\n";
  const std::string step = text_of({.step = default_step(StepMethod::rk4)}, rough);
  CHECK(run(step).checked->scene.numerics.trigonometry_error == cln::cl_RA(1) / 1'000'000'000);
}

TEST_CASE("a design with fixed parameters fixes all, and keeps the scene's fixed values") {
  const std::string text = text_of({.is_fixed = true}, "[parameters]\nfixed = { g = \"1/3\" }\n");
  CHECK(mentions(text, "fixed = { m = 2, l = \"sqrt(2)\", g = \"1/3\", k = 1 }"));
  CHECK(run(text).checked->scene.specialisation.fixed.size() == 4);
}

TEST_CASE("an expansion is about the start, and an exact design omits the scene's expansion") {
  const std::string output = "gravity";
  CHECK(mentions(text_of({.order = "3"}, {}, output), "order = 3\nabout = { q = \"0.5\" }"));
  const std::string small = "[approximate]\norder = 1\nabout = { q = 0 }\n";
  CHECK(mentions(text_of({}, small, output), "order = 1\nabout = { q = 0 }"));
  CHECK(mentions(text_of({.order = "3"}, small, output), "order = 3\nabout = { q = 0 }"));
  CHECK_FALSE(mentions(text_of(exact_design, small, output), "approximate"));
}

TEST_CASE("the step of a run is a scene with its method and order, and a doc of its step size") {
  const std::string text = text_of({.in_packs = true,
                                    .step = default_step(StepMethod::verlet, 8),
                                    .doc = "For steps of 0.01 s."});
  CHECK(mentions(text, "name = \"double_packs_verlet_8\"\ndoc = \"For steps of 0.01 s.\"\n"));
  CHECK(mentions(text, "[outputs]\nstep = { method = \"verlet\", order = 8 }\n"));
  CHECK(mentions(text, "[emit]\nbatch = true\n"));
  CHECK(mentions(text_of({.step = default_step(StepMethod::rk4)}),
                 "[outputs]\nstep = { method = \"rk4\" }\n"));
}

TEST_CASE("a scene contains max_error, its own ranges and the given ranges") {
  const Products products = derived(read_model("pushed_pendulum"), "inverse_dynamics");
  const SourcePointer source = make_source("test.scene.toml",
                                           "format = 1\nmodel = \"test.toml\"\nname = \"given\"\n"
                                           "[numeric]\nmax_error = 1e-3\n"
                                           "ranges = { q = [-1, \"pi/2\"], t = [0, 1] }\n");
  const Result<FileSyntax> syntax = parse_scene(source, Limits{});
  REQUIRE(syntax);
  CHECK_FALSE(mentions(scene_text({*products.checked, &*syntax}, {}, "test.toml"), "max_error"));
  const std::vector<SourcePointer> given = {make_source("command line", "t=0..1e-05"),
                                            make_source("command line", "dot(dot(q))=1..1")};
  const std::string text = scene_text({*products.checked, &*syntax, 1e-6, given}, {}, "test.toml");
  CHECK(mentions(
      text,
      "max_error = \"1e-06\"\n"
      "ranges = { \"dot(dot(q))\" = [1, 1], q = [\"-1\", \"pi/2\"], t = [0, \"1e-05\"] }\n"));
  const Numerics numerics = run(text).checked->scene.numerics;
  CHECK(numerics.max_error == 1e-6);
  REQUIRE(numerics.ranges.size() == 3);
  CHECK(numerics.ranges[2].name == "t");
  CHECK(numerics.ranges[2].high == 1e-5);
}

TEST_CASE("the path of a model is escaped as in TOML") {
  const Products products = derived(read_model("pushed_pendulum"), "inverse_dynamics");
  CHECK(mentions(scene_text({*products.checked}, {}, "a\t\"b\".toml"),
                 R"(model = "a\u0009\"b\".toml")"));
}
