// Modules in interpreted languages: scenes that emit them, and the models that are verified in
// every language.
#pragma once

#include <string>
#include <utility>

#include "cli/cli_testing.hpp"
#include "support/installed.hpp"

namespace elgen::test {

/// A folder with scenes that emit modules in one language.
class ModuleFolder : public Workspace {
 public:
  explicit ModuleFolder(std::string language) : language_(std::move(language)) {}

  /// Writes a scene `name` of the model file `model`; the module of a model NAME is NAME_m.
  void write_scene(const std::string& name, const std::string& model,
                   const std::string& more = "") const {
    write(name + ".scene.toml", "format = 1\nmodel = \"" + model + "\"\nname = \"m\"\n" + more +
                                    "[emit]\nlanguage = \"" + language_ + "\"\n");
  }

 private:
  std::string language_;
};

/// Verifies the models of tests/models/interpreted.txt: constraints, rotations, kinks, open
/// functions, series. .ci/run verifies them with more samples.
inline void check_interpreted_models(const std::string& language) {
  std::string command = "elgen verify --samples 4 --language " + language;
  for (const std::string& name :
       split_lines(read_text(ELGEN_SOURCE_DIR "/tests/models/interpreted.txt"))) {
    command += " " + model_path(name);
  }
  const Outcome outcome = run(command);
  CHECK(failure_of(outcome) == "");
  CHECK(count(outcome.output, " 0 fail, ") == 10);
  CHECK_FALSE(mentions(outcome.output, "could not be run"));
}

/// The code block of templates/README.md from the line `start` to the end of the block.
inline std::string readme_code(const std::string& start) {
  const std::string page = read_text(ELGEN_SOURCE_DIR "/templates/README.md");
  const std::size_t first = page.find(start);
  REQUIRE(first != std::string::npos);
  return page.substr(first, page.find("```", first) - first);
}

/// Checks that templates/README.md states the first line of `outcome.output`.
inline void check_readme_output(const Outcome& outcome) {
  INFO(outcome.errors);
  CHECK(mentions(outcome.output, "theta(1) = "));
  CHECK(mentions(read_text(ELGEN_SOURCE_DIR "/templates/README.md"),
                 "prints `" + split_lines(outcome.output).at(0) + "`"));
}

}  // namespace elgen::test
