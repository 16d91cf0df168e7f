// The rules of src/layers.txt, checked on a source tree: the order of folders, no include cycles,
// GiNaC where it may be, a test for every source, files of readable length.
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

/// src/, include/ and tests/ below `root`: files that end in .cpp, .hpp, .def or .txt.
[[nodiscard]] SourceTree read_tree(const std::filesystem::path& root);

/// The folder or room a file stands in: "check" of src/check/check.cpp, "check/names" of
/// src/check/names/symbols.cpp.
[[nodiscard]] std::string room_of(const std::string& path);
[[nodiscard]] std::string folder_of(const std::string& room);

/// The project's files that each file includes.
[[nodiscard]] Includes includes_of(const SourceTree& tree);

/// The files that layers.txt speaks about.
[[nodiscard]] std::vector<std::string> governed(const SourceTree& tree);

/// One sentence per broken rule, each starting with the file; empty where all hold.
[[nodiscard]] std::vector<std::string> later_includes(const SourceTree& tree);
[[nodiscard]] std::vector<std::string> include_cycles(const SourceTree& tree);
[[nodiscard]] std::vector<std::string> misplaced_ginac(const SourceTree& tree);
/// Types of one name, in any two files: two meanings to a reader, and in one namespace one type to
/// the linker.
[[nodiscard]] std::vector<std::string> types_of_two_meanings(const SourceTree& tree);
/// Includes of the project are paths from include/ or src/.
[[nodiscard]] std::vector<std::string> includes_beside(const SourceTree& tree);
/// Everything is in namespace elgen, except what stands beside the pipeline: urdf, oracle, cli.
[[nodiscard]] std::vector<std::string> unusual_namespaces(const SourceTree& tree);
/// Files that write fmt::join without fmt's header of ranges, which has it from version 11 on.
[[nodiscard]] std::vector<std::string> joins_without_ranges(const SourceTree& tree);
[[nodiscard]] std::vector<std::string> long_files(const SourceTree& tree, std::size_t most_lines);

}  // namespace elgen::test
