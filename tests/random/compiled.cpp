// Compiles the emitted code and compares the returned numbers. All trials of a language are one
// program, which is bisected if it does not compile.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "random/driver_text.hpp"
#include "support/shell.hpp"

namespace elgen::test::random {

namespace {

namespace fs = std::filesystem;

/// The permitted error in units of epsilon * scale: thousands of operations round by 1/2 each.
constexpr double roundings = 4096;

/// "base/output" -> the returned numbers.
using Printed = std::map<std::string, std::vector<double>>;

Printed parsed(const std::string& output) {
  Printed numbers;
  std::istringstream lines(output);
  std::string name;
  std::string number;
  while (lines >> name >> number) numbers[name].push_back(std::strtod(number.c_str(), nullptr));
  return numbers;
}

struct Program {
  const std::vector<Trial>& trials;
  const fs::path& folder;
  Language language;
  std::vector<std::vector<Finding>>& findings;
};

std::string source(const Program& program, const std::vector<std::size_t>& members) {
  std::string includes;
  std::string functions;
  std::string calls;
  for (const std::size_t i : members) {
    const std::string base = base_name(program.trials[i].system);
    const std::string file = "out/" + base + "/" + base;
    const Language declaring = program.language == Language::c ? Language::c : Language::cpp;
    const std::string declared =
        test::read_text(program.folder / (file + header_suffix(declaring)));
    includes += "#include \"" + file + header_suffix(program.language) + "\"\n";
    functions += driver_function(program.trials[i], program.language, declared);
    calls += "  run_" + base + "();\n";
  }
  return includes + driver_prelude(program.language) + functions + "int main(void) {\n" + calls +
         "  return 0;\n}\n";
}

std::string compared(const Trial& trial, const std::string& output, bool by_columns,
                     const std::vector<double>& printed) {
  const auto& truth = trial.given.at(output);
  const ShownOutput& shown = trial.shown.at(output);
  if (printed.size() != truth.size()) return "another number of entries\n";
  const Number epsilon = trial.system.scene.is_float ? 0x1p-23 : 0x1p-52;
  // Terms that cancel completely in the shown equations may round in compiled code. The scale is at
  // least 1, the magnitude of states.
  Number scale = 1;
  for (const ScaledValue& entry : shown.entries) scale = std::max(scale, entry.size);
  const std::size_t rows = truth.size() / std::max<std::size_t>(shown.columns, 1);
  std::string text;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::size_t at = by_columns ? i % shown.columns * rows + i / shown.columns : i;
    if (abs(truth[i] - printed[at]) <= roundings * epsilon * scale) continue;
    text += fmt::format("{} entry {}: compiled {:.17g}, true {}\n", output, i, printed[at],
                        truth[i].str(20));
  }
  return text;
}

void compare(const Program& program, std::size_t member, const Printed& numbers) {
  const Trial& trial = program.trials[member];
  const bool by_columns = trial.system.scene.is_column_major && program.language != Language::eigen;
  for (const auto& [output, truth] : trial.given) {
    const auto printed = numbers.find(base_name(trial.system) + "/" + output);
    if (printed == numbers.end() || !trial.shown.contains(output)) continue;
    const std::string text = compared(trial, output, by_columns, printed->second);
    if (!text.empty()) program.findings[member].push_back({"compiled " + output, text});
  }
}

void run(const Program& program, const std::vector<std::size_t>& members) {
  if (members.empty()) return;
  const bool is_c = program.language == Language::c;
  const std::string file = is_c ? "driver.c" : "driver.cpp";
  test::write_text(program.folder / file, source(program, members));
  const std::string compiler =
      is_c ? "gcc -std=c99" : "g++ -std=c++17 -isystem /usr/include/eigen3";
  const test::Outcome outcome =
      test::shell(compiler + " -O0 -ffp-contract=off -I. -o driver " + file + " -lm && ./driver",
                  program.folder);
  if (outcome.status == 0) {
    const Printed numbers = parsed(outcome.output);
    for (const std::size_t i : members) compare(program, i, numbers);
  } else if (members.size() == 1) {
    constexpr std::size_t kept = 1500;
    program.findings[members[0]].push_back(
        {"compile " + header_suffix(program.language), outcome.errors.substr(0, kept)});
  } else {
    const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
    run(program, {members.begin(), middle});
    run(program, {middle, members.end()});
  }
}

bool is_emitted(const Scene& scene, Language language) {
  if (language == Language::eigen) return scene.has_eigen;
  return scene.is_c99 == (language == Language::c);
}

}  // namespace

std::vector<std::vector<Finding>> compare_compiled(const std::vector<Trial>& trials,
                                                   const fs::path& folder) {
  std::vector<std::vector<Finding>> findings(trials.size());
  for (const Language language : {Language::cpp, Language::eigen, Language::c}) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const bool is_generated = !trials[i].shown.empty();
      if (is_generated && is_emitted(trials[i].system.scene, language)) members.push_back(i);
    }
    run({trials, folder, language, findings}, members);
  }
  return findings;
}

}  // namespace elgen::test::random
