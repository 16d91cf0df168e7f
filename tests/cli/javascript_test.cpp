// language = "javascript": node runs the module, names and texts are valid, and no text ends the
// script of a page.
#include <catch2/catch.hpp>
#include <string>

#include "cli/modules.hpp"

namespace elgen::test {
namespace {

/// A folder with scenes that emit JavaScript.
class JavaScript : public ModuleFolder {
 public:
  JavaScript() : ModuleFolder("javascript") {}

  /// Runs `statements` in node, in the folder of the module `name`.
  [[nodiscard]] Outcome node(const std::string& name, const std::string& statements) const {
    write("generated/" + name + "/asked.mjs", statements + "\n");
    return run("cd generated/" + name + " && node asked.mjs");
  }
};

/// A model with names that are reserved words or library objects of JavaScript, an array parameter,
/// kinks, a series, and texts that could end strings, comments and scripts.
const std::string model_of_words = R"text(format = 1
[model]
name = "odd"
title = 'A </script> and <!-- of "quotes" \'
description = 'x */ y ${z} `w`'
[[coordinate]]
name = "theta"
unit = "rad"
doc = 'angle </script> */ "q" \'
[[coordinate]]
name = "let"
unit = "m"
[parameters]
function = { value = 2, unit = "kg", doc = '</script> <!-- */ \' }
yield = { size = 2, value = [3, 4], unit = "m" }
eval = { value = 5, unit = "N" }
Math = { value = 9.81, unit = "m/s^2" }
[energy]
T = "1/2*function*(yield[1]^2*dot(theta)^2 + dot(let)^2 + yield[2]*sinc(theta)*dot(theta)*dot(let))"
V = "function*Math*yield[1]*cos(theta)*Math/(Math + Math*theta^2)"
[[force]]
on = "let"
value = "-eval*sign(dot(let)) - eval*max(sin(theta), 0.5)"
)text";

/// Outputs of model_of_words. Accelerations are omitted, because their sums cancel and lose digits.
const std::string odd_outputs =
    "[outputs]\nmass_matrix = true\ngravity = true\napplied_force = true\n"
    "momentum = { rename = \"await\" }\n";

}  // namespace

TEST_CASE("javascript: ten models agree with the program") {
  if (has_node()) check_interpreted_models("javascript");
}

// At equal angles of 1000 rad the bars are parallel, so the pivot of `projected` is a rounding
// error. The result is a number with sines of the C library, and 0/0 with sines of node.
TEST_CASE("javascript: NaN is accepted if a pivot is only a rounding error") {
  if (!has_node()) return;
  const JavaScript folder;
  folder.write_scene("four_bar", models + "/four_bar.toml", "[outputs]\nprojected = true\n");
  CHECK(failure_of(folder.run("elgen verify four_bar.scene.toml")) == "");
}

TEST_CASE("javascript: a changed module is found, and a missing node is a skipped row") {
  const JavaScript folder;
  folder.write_scene("cart_pole", models + "/cart_pole.toml", "[outputs]\nmass_matrix = true\n");
  const Outcome without =
      folder.run("NODE=/nonexistent/node elgen verify --samples 4 cart_pole.scene.toml");
  INFO(without.output + without.errors);
  CHECK(without.status == 0);
  CHECK(mentions(without.output, "`/nonexistent/node` could not be run"));
  if (!has_node()) return;
  CHECK(failure_of(folder.run("elgen verify --samples 4 cart_pole.scene.toml")) == "");
  // Runs node with the sign of the first cosine reversed.
  folder.write("wrong",
               "#!/bin/sh\nmodule=\"$(dirname \"$1\")/cart_pole_m.mjs\"\n"
               "sed -i '0,/= Math.cos(/s//= -Math.cos(/' \"$module\"\nexec node \"$1\"\n");
  const Outcome wrong = folder.run(
      "chmod +x wrong && NODE=\"$PWD/wrong\" elgen verify --samples 4 cart_pole.scene.toml");
  INFO(wrong.output + wrong.errors);
  CHECK(wrong.status == 1);
}

TEST_CASE(
    "javascript: reserved words get an underscore, and texts do not end strings or comments") {
  const JavaScript folder;
  folder.write("odd.toml", model_of_words);
  folder.write_scene("odd", "odd.toml", odd_outputs);
  folder.prepare("elgen generate -q odd.scene.toml");
  const std::string text = folder.read("generated/odd_m/odd_m.mjs");
  CHECK(mentions(text, "p.function_"));
  CHECK(mentions(text, "p.yield_[0]"));
  CHECK(mentions(text, "\n  yield_: [3.0, 4.0],"));
  CHECK(mentions(text, "\n  Math: 9.81,"));
  CHECK(mentions(text, "export const coordinate_names = [\"theta\", \"let\"];"));
  CHECK(mentions(text, "\nexport function await_(p, q, v) {\n"));
  CHECK_FALSE(mentions(text, "const Math ="));
  CHECK_FALSE(mentions(text, "\n\n\n"));
  CHECK_FALSE(mentions(text, "\n\n */"));
  for (const std::string& line : split_lines(text)) {
    INFO(line);
    if (!starts_with(line, " *") && !mentions(line, "//")) CHECK(line.size() <= 100);
  }
  if (!has_node()) return;
  folder.prepare("node --check generated/odd_m/odd_m.mjs");
  CHECK(failure_of(folder.run("elgen verify --samples 4 odd.scene.toml")) == "");
  const Outcome said =
      folder.node("odd_m",
                  "import * as m from './odd_m.mjs';\n"
                  "console.log(m.parameter_names.join(' '), m.parameter_units.join(' '));\n"
                  "console.log(m.coordinate_names.join(' '), m.coordinate_units.join(' '));");
  CHECK(said.output == "function yield eval Math kg m N m/s^2\ntheta let rad m\n");
}

TEST_CASE("javascript: texts of a model do not end the script of a page") {
  const JavaScript folder;
  folder.write("odd.toml", model_of_words);
  folder.prepare("elgen simulate odd.toml --time 1 --method rk4 --step 0.01 -o odd.html");
  const std::string page = folder.read("odd.html");
  CHECK(count(page, "</script>") == count(page, "<script>"));
  // A line separator would end a comment, so models with line separators are refused.
  folder.write("parted.toml", replaced(model_of_words, "A </script>", "A \u2028</script>"));
  const Outcome parted = folder.run("elgen generate --language javascript -o out parted.toml");
  CHECK(parted.status == 2);
  CHECK(mentions(parted.errors, "[E113]: U+2028"));
}

TEST_CASE("javascript: vectors are arrays, matrices arrays of rows, also if empty") {
  if (!has_node()) return;
  const JavaScript folder;
  folder.write_scene("pendulum", models + "/simple_pendulum.toml");
  folder.write_scene("cart", models + "/cart_pole.toml");
  folder.prepare("elgen generate -q pendulum.scene.toml cart.scene.toml");
  const Outcome said = folder.node(
      "cart_pole_m",
      "import * as cart from './cart_pole_m.mjs';\n"
      "import * as pendulum from '../simple_pendulum_m/simple_pendulum_m.mjs';\n"
      "const p = cart.parameters();\nconst q = cart.start_coordinates, v = cart.start_rates;\n"
      "const kind = (x) => `${x.constructor.name} ${x.length}`;\n"
      "const M = cart.mass_matrix({ ...p, m: 0.2 }, [0, 0]);\n"
      "const a = cart.forward_dynamics(p, q, v, [0]);\n"
      "console.log(kind(cart.gravity(p, q)));\nconsole.log(kind(M), kind(M[0]));\n"
      "console.log(M[0][0].toFixed(3), typeof cart.kinetic_energy(p, q, v));\n"
      "console.log(kind(cart.linearization(p, q, v, [0]).B));\n"
      "console.log(kind(cart.gravity(p, Float64Array.of(0, 1))));\n"
      "console.log(Object.keys(a).join(' '), cart.is_regular(a.relative_pivots));\n"
      "const left = [[1, 1], [200 * 2 ** -52, 1], [1, NaN], [0, 1]].map((x) => "
      "cart.digits_left(x));\n"
      "console.log(left.map((x) => x.toFixed(2)).join(' '));\n"
      "console.log(kind(pendulum.input_limits), kind(pendulum.input_names));");
  INFO(said.errors);
  CHECK(said.output ==
        "Array 2\nArray 2 Array 2\n1.200 number\nArray 4\nArray 2\n"
        "acceleration relative_pivots true\n15.35 2.00 0.00 0.00\nArray 0 Array 0\n");
}

TEST_CASE("javascript: rk4 runs as templates/README.md shows") {
  const std::string code = readme_code("import * as cart from \"./cart_pole.mjs\";\n");
  if (!has_node()) return;
  const JavaScript folder;
  folder.prepare("elgen generate -q --language javascript -o generated " + models +
                 "/cart_pole.toml");
  check_readme_output(folder.node("cart_pole", code));
}

TEST_CASE("javascript: an output may not have the name of a member of the module") {
  const JavaScript folder;
  folder.write_scene("renamed", models + "/cart_pole.toml",
                     "[outputs]\ngravity = { rename = \"Math\" }\n"
                     "momentum = { rename = \"sign_of\" }\n"
                     "bias = { rename = \"parameter_names\" }\n"
                     "mass_matrix = { rename = \"digits_left\" }\n");
  const Outcome renamed = folder.run("elgen generate renamed.scene.toml");
  CHECK(renamed.status == 2);
  CHECK(count(renamed.errors, "[E701]") == 4);
}

}  // namespace elgen::test
