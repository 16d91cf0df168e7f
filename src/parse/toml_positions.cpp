// TomlPositions: one table of code points, because a search along the line for each token would
// take quadratic time on a file of one line.
#include "parse/toml_positions.hpp"

#include <algorithm>
#include <string_view>

namespace elgen {

TomlPositions::TomlPositions(const SourceText& source) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::string_view text = source.text;
  const std::size_t begin = text.substr(0, 3) == byte_order_mark ? 3 : 0;
  line_points_.push_back(0);
  for (std::size_t i = begin; i < text.size(); ++i) {
    const bool continues = (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
    if (!continues) points_.push_back(static_cast<std::uint32_t>(i));
    if (text[i] == '\n') line_points_.push_back(static_cast<std::uint32_t>(points_.size()));
  }
  points_.push_back(static_cast<std::uint32_t>(text.size()));
}

std::uint32_t TomlPositions::offset(std::uint32_t line, std::uint32_t column) const {
  if (line == 0 || line > line_points_.size()) return points_.back();
  const std::size_t point = std::size_t{line_points_[line - 1]} + column - 1;
  return points_[std::min(point, points_.size() - 1)];
}

}  // namespace elgen
