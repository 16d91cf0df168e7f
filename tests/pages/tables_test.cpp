// The pages name every row of the tables in the code.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <regex>
#include <sstream>

#include "elgen/functions.hpp"
#include "elgen/outputs.hpp"
#include "elgen/syntax.hpp"
#include "elgen/units.hpp"
#include "pages/page.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string& language() { return page("models/README.md").prose; }

bool is_part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// True if the text contains the word as a whole word.
bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool starts = at == 0 || !is_part_of_word(text[at - 1]);
    if (starts && (end == text.size() || !is_part_of_word(text[end]))) return true;
  }
  return false;
}

/// The text of models/README.md below `heading`, up to the next heading.
std::string section(const std::string& heading) {
  const std::size_t start = language().find("\n" + heading + "\n");
  REQUIRE(start != std::string::npos);
  return language().substr(start, language().find("\n#", start + 1) - start);
}

/// The names of each option that a help text explains: "-o", "--output-directory".
std::vector<std::vector<std::string>> options_of(const std::string& help) {
  std::vector<std::vector<std::string>> options;
  for (const std::string& line : split_lines(help)) {
    if (!starts_with(line, "  -")) continue;
    options.emplace_back();
    std::istringstream names(line.substr(2, line.find(' ', 2) - 2));
    for (std::string name; std::getline(names, name, ',');) options.back().push_back(name);
  }
  return options;
}

/// The start of an entry's table row: "[lock]" for "scene.lock", "[[point]]" for "point".
std::string row_start(const EntryRow& row) {
  const bool is_scenes = starts_with(std::string(row.entry), "scene.");
  const std::string name = std::string(row.entry).substr(is_scenes ? 6 : 0);
  return row.repeated ? "| `[[" + name + "]]` |" : "| `[" + name + "]` |";
}

}  // namespace

TEST_CASE("the language page lists every entry of models and scenes") {
  const std::string models = section("### The entries of a model");
  const std::string scenes = section("### The entries of a scene");
  for (const EntryRow& row : entry_table()) {
    if (!row.supported || row.entry.empty() || row.entry == "scene") continue;
    INFO(row.entry);
    const bool is_scenes = starts_with(std::string(row.entry), "scene.");
    CHECK(mentions(is_scenes ? scenes : models, row_start(row)));
  }
}

TEST_CASE("the language page names every function, unit and output") {
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    CHECK(mentions(language(), "`" + std::string(row.name) + "`"));
  }
  for (const OutputRow& row : output_table()) {
    if (row.is_user_output) continue;
    INFO(row.name);
    CHECK(mentions(language(), "`" + std::string(row.name) + "`"));
  }
  const std::string units = section("## Units");
  for (const UnitRow& row : unit_table()) {
    INFO(row.name);
    CHECK(has_word(units, std::string(row.name)));
  }
}

TEST_CASE("the source page lists every folder") {
  for (const auto& entry : std::filesystem::directory_iterator(ELGEN_SOURCE_DIR "/src")) {
    if (!entry.is_directory()) continue;
    const std::string folder = entry.path().filename();
    INFO(folder);
    CHECK(mentions(page("src/README.md").prose, "| `src/" + folder + "/` |"));
  }
}

TEST_CASE("the source page lists every room with its input and output") {
  const std::string& prose = page("src/README.md").prose;
  const std::size_t begin = prose.find("\n| rooms | take | make |\n");
  REQUIRE(begin != std::string::npos);
  const std::string table = prose.substr(begin, prose.find("\n\n", begin) - begin);
  for (const std::string& line : split_lines(read_text(ELGEN_SOURCE_DIR "/src/layers.txt"))) {
    if (line.empty() || line.front() == '#') continue;
    const std::string room = line.substr(0, line.find_first_of(" :"));
    INFO(room);
    CHECK(mentions(table, "`" + room + "`"));
  }
}

TEST_CASE("the command-line page lists the words of show --what in the order of its help") {
  // Line breaks of the help text are ignored.
  const std::string help =
      std::regex_replace(Workspace().run("elgen show --help").output, std::regex("\\s+"), " ");
  std::smatch list;
  REQUIRE(std::regex_search(help, list, std::regex("--what LIST .*?; or (.*?) --as")));
  const std::string listed = std::regex_replace(list[1].str(), std::regex(" or "), ", ");
  const std::string& prose = page("src/cli/README.md").prose;
  const std::string head = "\n| `--what` | |\n|---|---|\n";
  const std::size_t table = prose.find(head);
  REQUIRE(table != std::string::npos);
  std::istringstream rows(prose.substr(table + head.size()));
  std::string words;
  for (std::string row; std::getline(rows, row) && starts_with(row, "| `");) {
    words += (words.empty() ? "" : ", ") + row.substr(3, row.find('`', 3) - 3);
  }
  CHECK(words == listed);
}

TEST_CASE("the command-line page lists every option") {
  const Workspace workspace;
  for (const std::string command : {"", "generate", "show", "verify", "import", "explain"}) {
    const std::string help = workspace.run("elgen " + command + " --help").output;
    REQUIRE(mentions(help, "--help"));
    for (const std::vector<std::string>& names : options_of(help)) {
      INFO(command << " " << names.front());
      CHECK(std::any_of(names.begin(), names.end(), [](const std::string& name) {
        return has_word(page("src/cli/README.md").prose, "`" + name);
      }));
    }
  }
}

}  // namespace elgen::test
