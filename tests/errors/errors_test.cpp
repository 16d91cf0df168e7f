// Every error code as users see it: the real binary runs tests/errors/*.txt, and its output must
// match exactly. ELGEN_UPDATE=1 rewrites the expected output, whose changes are then reviewed.
//
// A case has input files, a command, and the expected output.
//
//     --- model.toml            any other title names a file to write
//     format = 2
//     --- command
//     elgen generate model.toml
//     --- exit 2
//     --- stderr                stderr and stdout are empty if absent
//     model.toml:1:10: error[E102]: …
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "support/shell.hpp"

namespace elgen::test {
namespace {

struct Section {
  std::string title;
  std::string body;
};

struct CaseFile {
  std::vector<Section> inputs = {};  ///< names and contents of files
  std::string command = {};
  Outcome expected = {};
};

constexpr std::string_view marker = "--- ";

std::vector<Section> split(std::string_view text) {
  std::vector<Section> sections;
  for (const std::string& line : split_lines(text)) {
    if (line.rfind(marker, 0) == 0) {
      sections.push_back({line.substr(marker.size()), ""});
    } else if (sections.empty()) {
      throw std::invalid_argument("a case starts with `--- `");
    } else {
      sections.back().body += line + "\n";
    }
  }
  return sections;
}

void append(std::string& text, const std::string& title, const std::string& body) {
  text += std::string(marker) + title + "\n" + body;
}

/// The parts of a case file. Throws std::invalid_argument if the text has another form.
CaseFile parse_case(std::string_view text) {
  CaseFile parsed;
  bool has_exit = false;
  for (Section& section : split(text)) {
    if (section.title == "command") {
      parsed.command = section.body;
    } else if (section.title == "stdout") {
      parsed.expected.output = section.body;
    } else if (section.title == "stderr") {
      parsed.expected.errors = section.body;
    } else if (section.title.rfind("exit ", 0) == 0) {
      parsed.expected.status = std::stoi(section.title.substr(5));
      has_exit = true;
    } else {
      parsed.inputs.push_back(std::move(section));
    }
  }
  if (parsed.command.empty() || !has_exit) {
    throw std::invalid_argument("a case has a command and an exit code");
  }
  return parsed;
}

std::string to_text(const CaseFile& parsed) {
  std::string text;
  for (const Section& input : parsed.inputs) append(text, input.title, input.body);
  append(text, "command", parsed.command);
  append(text, "exit " + std::to_string(parsed.expected.status), "");
  if (!parsed.expected.output.empty()) append(text, "stdout", parsed.expected.output);
  if (!parsed.expected.errors.empty()) append(text, "stderr", parsed.expected.errors);
  return text;
}

/// Runs the command in a new folder with the input files.
Outcome run_case(const CaseFile& parsed) {
  const Workspace workspace;
  for (const Section& input : parsed.inputs) {
    workspace.write(input.title, input.body);
  }
  return workspace.run(parsed.command);
}

const std::filesystem::path folder = std::filesystem::path(ELGEN_SOURCE_DIR) / "tests/errors";

/// Code -> reason why no command can produce the code.
const std::map<std::string, std::string>& unreachable_codes() {
  static const std::map<std::string, std::string> reasons{
      {"E911", "a derivation that disagrees with the oracle: tests/verify breaks one by hand"},
      {"E912", "a broken invariant of elgen: tests/program and tests/pipeline break some by hand"},
      {"E915", "a page that elgen fails to write: tests/pipeline breaks one by hand"},
  };
  return reasons;
}

/// "E201" of "E201_unknown_name.txt".
std::string code_of(const std::filesystem::path& path) { return path.stem().string().substr(0, 4); }

/// The beginning of the file names of a code: "E201_unknown_name" for E201, "unknown name".
std::string file_stem(const CodeRow& row) {
  std::string stem = std::string(row.name) + "_";
  for (const char letter : row.title) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
      stem += letter;
    } else if (stem.back() != '_') {
      stem += '_';
    }
  }
  return stem;
}

struct BrokenModel {
  std::string name;
  std::string code;
  std::string line;
  std::string column;
};

std::vector<BrokenModel> broken_models() {
  std::vector<BrokenModel> models;
  for (const std::string& line : split_lines(read_text(folder / "broken_models.tsv"))) {
    if (line.rfind('#', 0) == 0) continue;
    std::istringstream cells(line);
    BrokenModel model;
    cells >> model.name >> model.code >> model.line >> model.column;
    models.push_back(model);
  }
  return models;
}

}  // namespace

TEST_CASE("a case is parsed section by section and written back unchanged") {
  const std::string text =
      "--- model.toml\nformat = 1\n--- scenes/a.toml\nformat = 1\n--- command\nelgen x\n"
      "--- exit 2\n--- stdout\nout\n--- stderr\nerror\n  | ^\n";
  const CaseFile parsed = parse_case(text);
  REQUIRE(parsed.inputs.size() == 2);
  CHECK(parsed.inputs[1].title == "scenes/a.toml");
  CHECK(parsed.inputs[1].body == "format = 1\n");
  CHECK(parsed.command == "elgen x\n");
  CHECK(parsed.expected.status == 2);
  CHECK(parsed.expected.output == "out\n");
  CHECK(parsed.expected.errors == "error\n  | ^\n");
  CHECK(to_text(parsed) == text);
}

TEST_CASE("a case without title, command or exit code is refused") {
  CHECK_THROWS_AS(parse_case("format = 1\n"), std::invalid_argument);
  CHECK_THROWS_AS(parse_case("--- exit 2\n"), std::invalid_argument);
  CHECK_THROWS_AS(parse_case("--- command\nelgen\n"), std::invalid_argument);
}

TEST_CASE("a case runs in its own folder, and stdout, stderr and exit code are separate") {
  CaseFile sample;
  sample.inputs = {{"in/put.txt", "text\n"}};
  sample.command = "cat in/put.txt; echo error >&2; ls; exit 7";
  const Outcome outcome = run_case(sample);
  CHECK(outcome.status == 7);
  CHECK(outcome.output == "text\nin\n");
  CHECK(outcome.errors == "error\n");
}

TEST_CASE("every error file matches the output exactly") {
  const bool update = std::getenv("ELGEN_UPDATE") != nullptr;
  for (const auto& path : files_in(folder, ".txt")) {
    CaseFile sample = parse_case(read_text(path));
    const Outcome outcome = run_case(sample);
    if (update) {
      sample.expected = outcome;
      write_text(path, to_text(sample));
      continue;
    }
    INFO(path.filename().string());
    CHECK(outcome.status == sample.expected.status);
    CHECK(outcome.output == sample.expected.output);
    CHECK(outcome.errors == sample.expected.errors);
  }
}

TEST_CASE("every error file shows the code in its name") {
  for (const auto& path : files_in(folder, ".txt")) {
    INFO(path.filename().string());
    const CodeRow* row = find_code(code_of(path));
    REQUIRE(row != nullptr);
    const CaseFile sample = parse_case(read_text(path));
    CHECK(mentions(sample.expected.errors, "[" + std::string(row->name) + "]"));
    CHECK(sample.expected.status == static_cast<int>(row->exit_code));
    CHECK(path.stem().string().rfind(file_stem(*row), 0) == 0);
  }
}

TEST_CASE("every code has an error file or a reason why no command can produce it") {
  std::set<std::string> shown;
  for (const auto& path : files_in(folder, ".txt")) shown.insert(code_of(path));
  for (const CodeRow& row : code_table()) {
    INFO(row.name);
    const bool is_unreachable = unreachable_codes().count(std::string(row.name)) > 0;
    CHECK((shown.count(std::string(row.name)) > 0) != is_unreachable);
  }
}

TEST_CASE("errors in broken models point to the character of the mistake") {
  const std::vector<BrokenModel> models = broken_models();
  REQUIRE(models.size() >= 25);
  for (const BrokenModel& model : models) {
    const std::string file = model.name + ".toml";
    INFO(file);
    const Outcome outcome = shell("elgen generate --stdout " + file, folder / "broken_models");
    const std::string start =
        file + ":" + model.line + ":" + model.column + ": error[" + model.code + "]: ";
    CHECK(outcome.errors.substr(0, start.size()) == start);
    CHECK(outcome.errors.find("error[", start.size()) == std::string::npos);
    CHECK(outcome.output.empty());
    CHECK(outcome.status == 2);
  }
}

}  // namespace elgen::test
