// Reads a documentation page: prose, and fences. The info string of a fence determines its kind.
//
//     ```sh                 commands, one per line; each must exit with code 0
//     ```sh not-run: WHY    commands that no test runs, and the reason
//     ```console            "$ command", followed by its complete output
//     ```LANGUAGE FILE      a file of this name, which later commands read
//     ```LANGUAGE in FILE   an excerpt of a file that earlier commands wrote or copied
//     ```text               a picture or a formula
//
// In output and in excerpts a line "…" matches any number of lines.
#pragma once

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace elgen::test {

enum class FenceKind { commands, not_run, console, file, excerpt, picture, unknown };

struct Fence {
  std::size_t line = 0;  ///< line number of the opening backticks
  FenceKind kind = FenceKind::unknown;
  std::string info = {};  ///< the text after the opening backticks
  std::string file = {};  ///< only for the kinds `file` and `excerpt`
  std::string text = {};
};

struct Page {
  std::string path = {};   ///< relative to the project's root
  std::string prose = {};  ///< everything outside fences
  std::vector<Fence> fences = {};
};

/// The root folder of the project.
inline const std::filesystem::path source = ELGEN_SOURCE_DIR;

/// models/REFERENCE.md and the README.md files of the project, without tests/print/books/README.md.
[[nodiscard]] const std::vector<Page>& pages();
[[nodiscard]] const Page& page(const std::string& path);

[[nodiscard]] Page read_page(const std::string& path, const std::string& text);

/// A command of a console fence, without "$ ", and the output that the fence shows for the command.
struct Exchange {
  std::string command = {};
  std::string output = {};
};
[[nodiscard]] std::vector<Exchange> exchanges(const std::string& console);

/// True if `text` equals `expected`; a line "…" of `expected` matches any number of lines.
[[nodiscard]] bool agrees(const std::string& expected, const std::string& text);

/// The first group of every match of `pattern` in `text`, in order.
[[nodiscard]] std::vector<std::string> all_matches(const std::string& text,
                                                   const std::regex& pattern);

/// The targets of [text](target) and <img src="target">, in order.
[[nodiscard]] std::vector<std::string> links(const std::string& prose);

/// The anchors of headings: "the-model-language" for "The model language".
[[nodiscard]] std::vector<std::string> anchors(const std::string& prose);

/// The texts between single backticks, in order.
[[nodiscard]] std::vector<std::string> code_spans(const std::string& prose);

}  // namespace elgen::test
