// Scenes: outputs, fixed parameters, scalars and names.
#include <catch2/catch.hpp>

#include "check/scene/scene.hpp"
#include "check_testing.hpp"
#include "numbers/exact_number.hpp"

namespace elgen::test {
namespace {

const std::string arrays = block("[parameters.l]\nvalue = [1, 2]\nsize = 2\nunit = \"m\"\n");

Scene arrays_scene(const std::string& more, CheckOptions wanted = {}) {
  wanted.scene = scene_of_block(more);
  return checked(arrays, wanted).scene;
}

std::string arrays_messages(const std::string& more) {
  return messages(arrays, {.scene = scene_of_block(more)});
}

std::string output_names(const Scene& scene) {
  std::string names;
  for (const OutputRequest& output : scene.outputs) {
    names += (names.empty() ? "" : " ") + output.name;
  }
  return names;
}

std::string fixed(const Scene& scene) {
  std::string text;
  for (const auto& [parameter, value] : scene.specialisation.fixed) {
    text += std::to_string(parameter) + "=" + number_text(value.number) + " ";
  }
  return text;
}

TEST_CASE("a model without a scene file gets a default scene, named like the model") {
  const Scene full = checked(arrays).scene;
  CHECK(full.name.empty());
  CHECK(full.base_name == "block");
  CHECK(full.emission.name_space == "block");
  CHECK(full.canonical_text.empty());
  CHECK_FALSE(full.has_options);
}

TEST_CASE("the base name of a scene consists of model and scene") {
  const Scene scene = arrays_scene("doc = \"quick\"\n[emit]\nnamespace = \"quick\"\n");
  CHECK(scene.base_name == "block_fast");
  CHECK(scene.emission.name_space == "quick");
  CHECK(scene.doc == "quick");
}

TEST_CASE("outputs are in the order of the table, without duplicates") {
  CHECK(
      output_names(arrays_scene("[outputs]\nbias = true\nmass_matrix = true\ngravity = false\n")) ==
      "mass_matrix bias");
  const Scene scene = checked(arrays, {.outputs = {"bias,mass_matrix", "bias"}}).scene;
  CHECK(output_names(scene) == "mass_matrix bias");
  CHECK(scene.has_options);
  CHECK(scene.base_name == "block");
}

TEST_CASE("options replace the outputs of the scene") {
  CHECK(output_names(arrays_scene("[outputs]\nbias = true\n", {.outputs = {"drift"}})) == "drift");
}

TEST_CASE("outputs may be renamed, but not to a used name") {
  const Scene scene = arrays_scene("[outputs]\nbias = { rename = \"h\" }\n");
  CHECK(output_names(scene) == "h");
  CHECK(arrays_messages("[outputs]\nmass_matrix = { rename = \"bias\" }\nbias = true\n") ==
        "E609 5:27 another output is already called `bias`\n");
  CHECK(arrays_messages("[outputs]\nbias = { rename = \"double\" }\n") ==
        "E204 5:20 `double` is reserved: it is a keyword of C++ | `double_1` is free\n");
}

TEST_CASE("forward dynamics gives pivots unless the model or the scene disables them") {
  const auto without = [](const std::string& model, const CheckOptions& wanted) {
    const Scene scene = checked(model, wanted).scene;
    return find_request(scene, "forward_dynamics")->omits_pivots;
  };
  const std::string fast = arrays + "[outputs]\nforward_dynamics = { pivots = false }\n";
  const std::string own = arrays + "[outputs.forward_dynamics]\n";
  const std::string with = scene_of_block("[outputs]\nforward_dynamics = { pivots = true }\n");
  const std::string usual = scene_of_block("[outputs]\nforward_dynamics = true\n");
  const std::string none = scene_of_block("[outputs]\nforward_dynamics = { pivots = false }\n");
  CHECK_FALSE(without(arrays, {}));
  CHECK_FALSE(without(own, {}));
  CHECK_FALSE(without(arrays, {.scene = usual}));
  CHECK(without(arrays, {.scene = none}));
  CHECK(without(fast, {}));
  CHECK(without(fast, {.scene = usual}));
  CHECK(without(fast, {.outputs = {"forward_dynamics"}}));
  CHECK_FALSE(without(fast, {.scene = with}));
  CHECK_FALSE(find_request(checked(fast).scene, "bias")->omits_pivots);
  CHECK(arrays_messages("[outputs]\nbias = { pivots = false }\n") ==
        "E103 5:10 `bias` has no `pivots`: `forward_dynamics` has them\n");
}

TEST_CASE("an output refuses options of other outputs, and the message names such an output") {
  const auto refused = [](const std::string& output, const std::string& value) {
    return arrays_messages("[outputs]\n" + output + " = { " + value + " }\n");
  };
  CHECK(refused("bias", "independent = [\"x\"]") ==
        "E103 5:10 `bias` has no `independent`: `completed` has it\n");
  CHECK(refused("forward_dynamics", "pivots = false, order = 4") ==
        "E103 5:38 `forward_dynamics` has no `order`: `step` has one\n");
  CHECK(refused("step", "method = \"rk4\", pivots = false") ==
        "E103 5:26 `step` has no `pivots`: `forward_dynamics` has them\n");
}

TEST_CASE("parameters are fixed by name, by element, or all") {
  CHECK(fixed(arrays_scene("[parameters]\nfixed = { k = \"1/2\", l = 3 }\n")) == "1=1/2 2=3 3=3 ");
  CHECK(fixed(arrays_scene("[parameters]\nfixed = \"all\"\n")) == "0=1 1=2 2=1 3=2 ");
  const Scene scene = checked(arrays, {.fixed = {"m,l[2]=7", "k=pi/4"}}).scene;
  CHECK(fixed(scene) == "0=1 1=7.85398163397448309615660845820e-1 3=7 ");
}

TEST_CASE("refused values of fixed parameters") {
  CHECK(arrays_messages("[parameters]\nfixed = { kk = 1 }\n") ==
        "E602 5:11 unknown parameter `kk` | did you mean `k`? (parameter, line 9)\n");
  CHECK(arrays_messages("[parameters]\nfixed = { all = 3 }\n") ==
        "E602 5:11 unknown parameter `all` | `all` fixes every parameter at its own value\n");
  const Rows rows{
      {"all=3",
       "E602 1:1 unknown parameter `all` | `all` fixes every parameter at its own value\n"},
      {"m, h=2", "E602 1:4 unknown parameter `h`\n"},
      {"m=", "E606 1:1 `m=` has no value\n"},
      {"m=1/0", "E312 1:5 `0` is zero\n"},
      {"m=(1", "E304 1:5 `(` is not closed\n"},
      {"m=k", "E319 1:3 `k` is not a constant number\n"},
      {"m, k=2, m=3", "E606 1:9 `m` is given twice\n"},
  };
  check_rows(rows,
             [&](const std::string& option) { return messages(arrays, {.fixed = {option}}); });
}

TEST_CASE("the default preference is balanced") {
  const auto preference = [](const std::string& text) {
    return arrays_scene(text).numerics.prefer;
  };
  CHECK(preference("") == Preference::balanced);
  CHECK(preference("[numeric]\nprefer = \"balanced\"\n") == Preference::balanced);
  CHECK(preference("[numeric]\nprefer = \"speed\"\n") == Preference::speed);
}

TEST_CASE("scalars are in a fixed order") {
  const Scene scene = arrays_scene("[numeric]\nscalar = [\"double\", \"float\"]\n");
  CHECK(scene.numerics.scalars ==
        std::vector{ScalarKind::single_precision, ScalarKind::double_precision});
}

TEST_CASE("a form is set for one output or for all") {
  const Scene scene = arrays_scene(
      "[outputs]\nmass_matrix = { form = \"recursive\" }\nbias = true\n"
      "[numeric]\nform = \"closed\"\n");
  REQUIRE(scene.outputs.size() == 2);
  CHECK(scene.outputs[0].form == Form::recursive);
  CHECK(scene.outputs[1].form == Form::closed);
  CHECK_FALSE(arrays_scene("[outputs]\nbias = true\n").outputs[0].form);
}

TEST_CASE("dynamics needs other outputs without a and u") {
  CHECK(arrays_messages("[outputs]\ninverse_dynamics = true\ndynamics = true\n") ==
        "E603 6:1 `dynamics` returns the requested outputs that take neither a nor u, but the "
        "scene requests none\n");
}

TEST_CASE("the stamp of a scene covers its file and the options, without blanks") {
  const std::string sized = arrays + "[sizes]\nn = 2\n";
  CheckOptions wanted;
  wanted.outputs = {"bias, drift"};
  wanted.fixed = {"k = pi / 4"};
  wanted.sizes = {"n=4"};
  CHECK(checked(sized, wanted).scene.canonical_text ==
        "--outputs bias\n--outputs drift\n--fix k=pi/4\n--size n=4\n");
  wanted.scene = scene_of_block("");
  CHECK(checked(sized, wanted).scene.canonical_text ==
        "[]\n  format = 1\n  model = \"block.toml\"\n  name = fast\n"
        "--outputs bias\n--outputs drift\n--fix k=pi/4\n--size n=4\n");
}

TEST_CASE("the stamp of a model covers its file, independent of the scene") {
  CheckOptions wanted;
  wanted.fixed = {"k"};
  wanted.scene = scene_of_block("[lock]\nx = { value = 0 }\n");
  const std::string two = arrays + "[[coordinate]]\nname = \"y\"\nunit = \"m\"\narmature = \"m\"\n";
  CHECK(checked(two, wanted).model.canonical_text == checked(two).model.canonical_text);
  CHECK(checked(two).model.canonical_text != checked(arrays).model.canonical_text);
}

TEST_CASE("errors of model and scene are reported together, each at its position") {
  const std::string text =
      messages(block("V = \"kk*x^2\"\n"), {.scene = scene_of_block("[outputs]\nbiass = true\n")});
  CHECK(mentions(text, "E201 12:6 unknown name `kk`"));
  CHECK(mentions(text, "E601 5:1 unknown output `biass` | did you mean `bias`?"));
}

}  // namespace
}  // namespace elgen::test
