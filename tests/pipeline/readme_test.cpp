// The README names everything the tables of the code have, so that neither outgrows the other.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <sstream>

#include "elgen/functions.hpp"
#include "elgen/limits.hpp"
#include "elgen/outputs.hpp"
#include "elgen/syntax.hpp"
#include "elgen/units.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string& readme() {
  static const std::string text = read_text(std::string(ELGEN_SOURCE_DIR) + "/README.md");
  return text;
}

/// What the first block that `fence` opens holds.
std::string block(const std::string& fence) {
  const std::size_t start = readme().find("\n" + fence) + 1 + fence.size();
  return readme().substr(start, readme().find("```", start) - start);
}

bool is_part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Whether a text has a word that is not part of a longer one.
bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool starts = at == 0 || !is_part_of_word(text[at - 1]);
    if (starts && (end == text.size() || !is_part_of_word(text[end]))) return true;
  }
  return false;
}

/// The line of the README that starts with `words`, and the next.
std::string lines_from(const std::string& words) {
  const std::size_t start = readme().find("\n" + words);
  REQUIRE(start != std::string::npos);
  const std::size_t end = readme().find('\n', readme().find('\n', start + 1) + 1);
  return readme().substr(start, end - start);
}

/// "-o", "--output-directory" of each line of a help text that explains an option.
std::vector<std::vector<std::string>> options_of(const std::string& help) {
  std::vector<std::vector<std::string>> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (!starts_with(line, "  -")) continue;
    options.emplace_back();
    std::istringstream names(line.substr(2, line.find(' ', 2) - 2));
    for (std::string name; std::getline(names, name, ',');) options.back().push_back(name);
  }
  return options;
}

/// The README's table row that explains an entry of a model or scene.
std::string row_of(const std::string& entry) {
  const bool is_scene = starts_with(entry, "scene");
  const std::size_t scenes = readme().find("A scene (");
  std::string name = is_scene && entry != "scene" ? entry.substr(6) : entry;
  name = name.substr(0, name.find('.'));
  const std::size_t from = is_scene ? scenes : 0;
  for (const std::string& header : {"| `[[" + name + "]]`", "| `[" + name + "]`"}) {
    const std::size_t start = readme().find(header, from);
    if (start != std::string::npos) {
      return readme().substr(start, readme().find('\n', start) - start);
    }
  }
  const std::size_t top = readme().find("| top level", scenes);
  return readme().substr(top, readme().find('\n', top) - top);
}

}  // namespace

TEST_CASE("the README explains every key of the format that is supported") {
  for (const KeyRow& row : key_table()) {
    if (!row.supported || row.key == "*" || row.entry.empty()) continue;
    INFO("[" << row.entry << "] " << row.key);
    CHECK(has_word(row_of(std::string(row.entry)), std::string(row.key)));
  }
}

TEST_CASE("the README names every function, unit, output and limit") {
  for (const FunctionRow& row : function_table) {
    INFO(row.name);
    CHECK(mentions(readme(), "`" + std::string(row.name) + "`"));
  }
  for (const OutputRow& row : output_table()) {
    if (row.of_user) continue;
    INFO(row.name);
    CHECK(mentions(readme(), "`" + std::string(row.name) + "`"));
  }
  const std::string units = lines_from("**Units**");
  for (const UnitRow& row : unit_table()) {
    INFO(row.name);
    CHECK(has_word(units, std::string(row.name)));
  }
  for (const LimitRow& row : limit_table()) {
    INFO(row.name);
    CHECK(mentions(readme(), "`" + std::string(row.name) + "`"));
  }
}

TEST_CASE("the README's model gives the README's header") {
  const Workspace workspace;
  write_text(workspace.path() / "cart_pole.toml", block("```toml\n"));
  const Outcome outcome = shell("elgen generate --stdout cart_pole.toml", workspace.path());
  CHECK(outcome.status == 0);
  std::istringstream excerpt(block("```cpp\n"));
  for (std::string line; std::getline(excerpt, line);) {
    INFO(line);
    CHECK((line == "…" || mentions(outcome.output, line + "\n")));
  }
}

TEST_CASE("the README's mistake gives the README's message") {
  const Workspace workspace;
  std::string model = block("```toml\n");
  model.replace(model.find("cos(theta)"), 10, "cos(tehta)");
  write_text(workspace.path() / "cart_pole.toml", model);
  const Outcome outcome = shell("elgen generate cart_pole.toml", workspace.path());
  CHECK(outcome.errors == block("```text\n"));
}

TEST_CASE("every option of the command line is in the README") {
  const Workspace workspace;
  for (const std::string command : {"", "generate", "show", "verify", "import", "explain"}) {
    const std::string help = shell("elgen " + command + " --help", workspace.path()).output;
    REQUIRE(mentions(help, "--help"));
    for (const std::vector<std::string>& names : options_of(help)) {
      INFO(command << " " << names.front());
      CHECK(std::any_of(names.begin(), names.end(),
                        [](const std::string& name) { return has_word(readme(), "`" + name); }));
    }
  }
}

}  // namespace elgen::test
