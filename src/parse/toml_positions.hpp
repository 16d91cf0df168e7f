// TomlPositions: line and column as toml++ counts them, to bytes of the file.
#pragma once

#include <cstdint>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// toml++ counts columns in code points and does not count a byte order mark.
class TomlPositions {
 public:
  explicit TomlPositions(const SourceText& source);

  /// The byte offset of 1-based `line` and `column`; the end of the file for what lies beyond it.
  [[nodiscard]] std::uint32_t offset(std::uint32_t line, std::uint32_t column) const;

 private:
  std::vector<std::uint32_t> points_;       ///< byte offset of each code point
  std::vector<std::uint32_t> line_points_;  ///< index of the first code point of each line
};

}  // namespace elgen
