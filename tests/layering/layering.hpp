// Checks a source tree against src/layers.txt: order of folders, include cycles, use of GiNaC,
// names of types, namespaces, and lengths of files.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace elgen::test {

/// Path relative to the project ("src/base/units.cpp") -> text.
using SourceTree = std::map<std::string, std::string>;

/// One line of layers.txt: a folder ("check"), or one of its rooms ("check/names").
struct Layer {
  std::string folder;
  std::vector<std::string> nouns = {};  ///< headers of include/elgen/ without their extension
  bool all_ginac = false;
  std::set<std::string> ginac_files = {};
  std::set<std::string> published = {};  ///< headers that other folders may include; "*" = all
};

using Includes = std::map<std::string, std::vector<std::string>>;

[[nodiscard]] std::vector<Layer> parse_layers(std::string_view text);

/// Reads the .cpp, .hpp and .def files below src/, include/ and tests/, and src/layers.txt.
[[nodiscard]] SourceTree read_tree(const std::filesystem::path& root);

/// The folder or room of a file: "check" for src/check/check.cpp, "check/names" for
/// src/check/names/symbols.cpp.
[[nodiscard]] std::string room_of(const std::string& path);
[[nodiscard]] std::string folder_of(const std::string& room);

/// For each file, the project's files that it includes directly.
[[nodiscard]] Includes includes_of(const SourceTree& tree);

/// The paths of the code in src/ and include/elgen/, which layers.txt describes.
[[nodiscard]] std::vector<std::string> governed(const SourceTree& tree);

/// Each function returns one sentence per breach of a rule; each sentence starts with the file.
[[nodiscard]] std::vector<std::string> later_includes(const SourceTree& tree);
[[nodiscard]] std::vector<std::string> include_cycles(const SourceTree& tree);
[[nodiscard]] std::vector<std::string> misplaced_ginac(const SourceTree& tree);
/// Types defined in two files under one name: confusing, and in one namespace an ODR violation.
[[nodiscard]] std::vector<std::string> types_of_two_meanings(const SourceTree& tree);
/// #include paths that are not found from include/ or src/, only from the folder of the file.
[[nodiscard]] std::vector<std::string> includes_beside(const SourceTree& tree);
/// Namespaces other than elgen. Only urdf, oracle and cli may have their own (elgen::urdf, ...).
[[nodiscard]] std::vector<std::string> unusual_namespaces(const SourceTree& tree);
/// Files that use fmt::join without <fmt/ranges.h>, which declares it from fmt 11 on.
[[nodiscard]] std::vector<std::string> joins_without_ranges(const SourceTree& tree);
[[nodiscard]] std::vector<std::string> long_files(const SourceTree& tree, std::size_t most_lines);

}  // namespace elgen::test
