// language = "matlab": a classdef for Octave, without names reserved in MATLAB or Octave.
#include <catch2/catch.hpp>
#include <string>

#include "cli/modules.hpp"

namespace elgen::test {
namespace {

bool has_octave() { return is_installed("octave", "octave-cli --version"); }

/// A folder with scenes that emit MATLAB.
class Matlab : public ModuleFolder {
 public:
  Matlab() : ModuleFolder("matlab") {}

  /// Runs `statements` in Octave, in the folder of the module `name`.
  [[nodiscard]] Outcome octave(const std::string& name, const std::string& statements) const {
    write("generated/" + name + "/asked.m", "1;\n" + statements + "\n");
    return run("cd generated/" + name + " && octave-cli --norc --quiet asked.m");
  }
};

/// A model with names that are words of MATLAB and of Octave, an array parameter, kinks, a series,
/// and a coordinate `angle`. The sine of a long `angle` has a name of more than 63 characters.
std::string odd_model(const std::string& angle) {
  return "format = 1\n[model]\nname = \"odd\"\n"
         "[[coordinate]]\nname = \"" +
         angle +
         "\"\nunit = \"rad\"\n[[coordinate]]\nname = \"end\"\nunit = \"m\"\n"
         "[parameters]\nfunction = { value = 2, unit = \"kg\" }\n"
         "until = { size = 2, value = [3, 4], unit = \"m\" }\n"
         "otherwise = { value = 5, unit = \"N\" }\ng = { value = 9.81, unit = \"m/s^2\" }\n"
         "[energy]\nT = \"1/2*function*(until[1]^2*dot(" +
         angle + ")^2 + dot(end)^2 + until[2]*sinc(" + angle + ")*dot(" + angle +
         ")*dot(end))\"\nV = \"function*g*until[1]*cos(" + angle +
         ")\"\n[[force]]\non = \"end\"\n"
         "value = \"-otherwise*sign(dot(end)) - otherwise*max(sin(" +
         angle + "), 0.5)\"\n";
}

}  // namespace

TEST_CASE("matlab: ten models agree with the program") {
  if (has_octave()) check_interpreted_models("matlab");
}

TEST_CASE("matlab: a changed module is found, and a missing octave is a skipped row") {
  const Matlab folder;
  folder.write_scene("cart_pole", models + "/cart_pole.toml", "[outputs]\nmass_matrix = true\n");
  const Outcome without =
      folder.run("OCTAVE=/nonexistent/octave elgen verify --samples 4 cart_pole.scene.toml");
  INFO(without.output + without.errors);
  CHECK(without.status == 0);
  CHECK(mentions(without.output, "`/nonexistent/octave` could not be run"));
  if (!has_octave()) return;
  // Runs Octave with the sign of the first cosine reversed.
  folder.write("wrong",
               "#!/bin/sh\nsed -i '0,/= cos(/s//= -cos(/' \"$(dirname \"$1\")/cart_pole_m.m\"\n"
               "exec octave-cli --norc --quiet \"$1\"\n");
  const Outcome wrong = folder.run(
      "chmod +x wrong && OCTAVE=\"$PWD/wrong\" elgen verify --samples 4 cart_pole.scene.toml");
  INFO(wrong.output + wrong.errors);
  CHECK(wrong.status == 1);
}

TEST_CASE("matlab: reserved words get an underscore, and long names of values are cut") {
  const Matlab folder;
  const std::string name = "an_angle_whose_name_has_sixty_two_characters_of_the_sixty_three";
  folder.write("odd.toml", odd_model(name));
  folder.write_scene("odd", "odd.toml");
  folder.prepare("elgen generate -q odd.scene.toml");
  const std::string text = folder.read("generated/odd_m/odd_m.m");
  CHECK(mentions(text, "p.function_ * "));
  CHECK(mentions(text, "p.until_(1)"));
  CHECK(mentions(text, "\n  result.until_ = [3.0; 4.0];"));
  CHECK(mentions(text, "coordinate_names = {'" + name + "', 'end'};"));
  CHECK(mentions(text, "odd_m.sign_of("));
  CHECK(mentions(text, "\nfunction result = forward_dynamics(p, q, v, u)\n"));
  for (const std::string& line : split_lines(text)) {
    INFO(line);
    if (!mentions(line, "%")) CHECK(line.size() <= 100);
    CHECK_FALSE(mentions(line, "sin_" + name + " ="));
  }
  if (!has_octave()) return;
  CHECK(failure_of(folder.run("elgen verify --samples 4 odd.scene.toml")) == "");
}

TEST_CASE("matlab: functions that a module or its driver calls may name values, but no module") {
  const Matlab folder;
  const auto rotor = [](const std::string& model, const std::string& coordinate,
                        const std::string& parameter) {
    return "format = 1\n[model]\nname = \"" + model + "\"\n[[coordinate]]\nname = \"" + coordinate +
           "\"\n[parameters]\n" + parameter + " = 2\n[energy]\nT = \"1/2*" + parameter + "*dot(" +
           coordinate + ")^2\"\nV = \"" + parameter + "*cos(" + coordinate + ")\"\n";
  };
  for (const std::string name : {"size", "numel", "all", "mod", "printf", "methods", "parameters",
                                 "digits_left", "coordinate_names"}) {
    INFO(name);
    folder.write(name + ".toml", rotor(name, "q", "J"));
    const Outcome refused = folder.run("elgen generate --language matlab -o x " + name + ".toml");
    CHECK(refused.status == 2);
    CHECK(mentions(refused.errors, "[E701]: `" + name + "` cannot name a module"));
  }
  if (!has_octave()) return;
  folder.write("values.toml", rotor("rotor", "size", "numel"));
  // The driver's functions have names such as flat__, so `flat` may be the name of a model.
  folder.write("elgen_driver.toml", rotor("elgen_driver", "q", "J"));
  folder.write("flat.toml", rotor("flat", "q", "J"));
  folder.write("functions.toml", rotor("functions", "q", "J"));
  const Outcome judged = folder.run(
      "elgen verify --samples 2 --language matlab values.toml elgen_driver.toml flat.toml "
      "functions.toml");
  INFO(judged.output + judged.errors);
  CHECK(judged.status == 0);
  CHECK(count(judged.output, " 0 fail, 0 skipped") == 4);
}

TEST_CASE(
    "matlab: vectors are columns, several results a struct, and empty results keep their shape") {
  if (!has_octave()) return;
  const Matlab folder;
  folder.write_scene("pendulum", models + "/simple_pendulum.toml");
  folder.write_scene("cart", models + "/cart_pole.toml");
  folder.prepare("elgen generate -q pendulum.scene.toml cart.scene.toml");
  const Outcome said = folder.octave(
      "cart_pole_m",
      "addpath('../simple_pendulum_m');\np = cart_pole_m.parameters();\n"
      "q = cart_pole_m.start_coordinates; v = cart_pole_m.start_rates;\n"
      "disp(size(cart_pole_m.gravity(p, q)))\ndisp(size(cart_pole_m.mass_matrix(p, q)))\n"
      "disp(fieldnames(cart_pole_m.forward_dynamics(p, q, v, 0)).')\n"
      "disp(size(simple_pendulum_m.input_limits))\ndisp(size(simple_pendulum_m.input_names))\n"
      "p.m = 0.2;\nm = cart_pole_m.mass_matrix(p, [0; 0]);\nprintf('%.3f\\n', m(1, 1))\n"
      "disp(cart_pole_m.is_regular(cart_pole_m.forward_dynamics(p, q, v, 0).relative_pivots))\n"
      "left = @(x) cart_pole_m.digits_left(x);\n"
      "printf('%.2f ', left([1; 1]), left([200 * eps; 1]), left([1; NaN]), left([0; 1]))");
  INFO(said.errors);
  CHECK(said.output ==
        "   2   1\n   2   2\n{\n  [1,1] = acceleration\n  [1,2] = relative_pivots\n}\n"
        "   0   2\n   1   0\n1.200\n1\n15.35 2.00 0.00 0.00 ");
}

TEST_CASE("matlab: ode45 integrates as templates/README.md shows") {
  const std::string code = readme_code("p = cart_pole.parameters();\n");
  if (!has_octave()) return;
  const Matlab folder;
  folder.prepare("elgen generate -q --language matlab -o generated " + models + "/cart_pole.toml");
  check_readme_output(folder.octave("cart_pole", code));
}

TEST_CASE("matlab: keys of compiled code and names of members of the module are refused") {
  const Matlab folder;
  folder.write("odd.toml", odd_model("theta"));
  folder.write("stored.scene.toml",
               "format = 1\nmodel = \"odd.toml\"\nname = \"s\"\n[emit]\nlanguage = \"matlab\"\n"
               "storage = \"column-major\"\n");
  const Outcome stored = folder.run("elgen generate stored.scene.toml");
  CHECK(stored.status == 2);
  CHECK(mentions(stored.errors, "[E611]"));
  folder.write_scene("renamed", "odd.toml",
                     "[outputs]\ngravity = { rename = \"sign_of\" }\n"
                     "momentum = { rename = \"odd_m\" }\n"
                     "mass_matrix = { rename = \"digits_left\" }\n");
  const Outcome renamed = folder.run("elgen generate renamed.scene.toml");
  CHECK(renamed.status == 2);
  CHECK(count(renamed.errors, "[E701]") == 3);
}

}  // namespace elgen::test
