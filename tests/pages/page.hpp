// A page for readers, as its tests see it: prose, and fences that say what they are.
//
//     ```sh                 commands, one a line; each ends with exit code 0
//     ```sh not-run: WHY    commands that no test runs, and why
//     ```console            "$ command", then all that it prints
//     ```LANGUAGE FILE      a file of that name, which commands below it read
//     ```LANGUAGE in FILE   what stands in a file that commands above it wrote
//     ```text               a picture or a formula
//
// In printed output and in files a line "…" is any number of lines.
#pragma once

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace elgen::test {

enum class FenceKind { commands, not_run, console, file, excerpt, picture, unknown };

struct Fence {
  std::size_t line = 0;  ///< of the page, where it opens
  FenceKind kind = FenceKind::unknown;
  std::string info = {};  ///< all that stands beside the backticks
  std::string file = {};  ///< of a file or an excerpt
  std::string text = {};
};

struct Page {
  std::string path = {};   ///< below the folder of the project
  std::string prose = {};  ///< everything outside of fences
  std::vector<Fence> fences = {};
};

/// The folder of the project.
inline const std::filesystem::path source = ELGEN_SOURCE_DIR;

/// The pages of the project; CHANGELOG.md and what programs write are none.
[[nodiscard]] const std::vector<Page>& pages();
[[nodiscard]] const Page& page(const std::string& path);

[[nodiscard]] Page read_page(const std::string& path, const std::string& text);

/// A command and what it prints.
struct Exchange {
  std::string command = {};
  std::string output = {};
};
[[nodiscard]] std::vector<Exchange> exchanges(const std::string& console);

/// Whether `text` is `expected`, where a line "…" is any number of lines.
[[nodiscard]] bool agrees(const std::string& expected, const std::string& text);

/// The first group of every match, in order.
[[nodiscard]] std::vector<std::string> all_matches(const std::string& text,
                                                   const std::regex& pattern);

/// The targets of [text](target), in order.
[[nodiscard]] std::vector<std::string> links(const std::string& prose);

/// Names under which headings can be linked to: "The model language" is "the-model-language".
[[nodiscard]] std::vector<std::string> anchors(const std::string& prose);

/// The texts between single backticks, in order.
[[nodiscard]] std::vector<std::string> code_spans(const std::string& prose);

}  // namespace elgen::test
