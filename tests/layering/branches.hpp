// Places that the rules count in a source tree, and the rules about branches on table rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>
#include <vector>

#include "layering/layering.hpp"
#include "support/shell.hpp"

namespace elgen::test {

using Lines = std::vector<std::string>;
using Places = std::vector<std::string>;

/// The places "path:line: result" of the lines of src and include for which judge(lines of the
/// file, index of the line) returns a non-empty result.
template <class Judge>
Places places_where(const SourceTree& tree, const Judge& judge) {
  Places found;
  for (const std::string& path : governed(tree)) {
    const Lines lines = split_lines(tree.at(path));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string said = judge(lines, i);
      if (!said.empty()) found.push_back(path + ":" + std::to_string(i + 1) + ": " + said);
    }
  }
  return found;
}

inline std::size_t indent_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

inline bool begins(const std::string& line, const std::string& word) {
  return line.compare(indent_of(line), word.size(), word) == 0;
}

/// The lines that match `pattern`. Only lines that contain `word` are tried, which is faster.
inline Places matching_lines(const SourceTree& tree, const std::string& word,
                             const std::string& pattern) {
  const std::regex expression(pattern);
  return places_where(tree, [&](const Lines& lines, std::size_t i) -> std::string {
    if (!mentions(lines[i], word) || !std::regex_search(lines[i], expression)) return "";
    return lines[i].substr(indent_of(lines[i]));
  });
}

/// Each function finds the places with `==`, `!=` or `case` and an enumerator of one table.
[[nodiscard]] Places language_branches(const SourceTree& tree);
[[nodiscard]] Places output_branches(const SourceTree& tree);
[[nodiscard]] Places extent_branches(const SourceTree& tree);
[[nodiscard]] Places need_branches(const SourceTree& tree);
[[nodiscard]] Places leaf_branches(const SourceTree& tree);

}  // namespace elgen::test
