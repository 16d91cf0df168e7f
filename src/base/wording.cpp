// Wording: user text made fit for a message, counts and suggestions.
#include "elgen/wording.hpp"

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/diagnostic.hpp"

namespace elgen {

std::string in_backticks(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string shown = "`";
  std::size_t position = 0;
  bool after_blank = false;
  for (std::size_t count = 0; position < text.size();) {
    const CodePoint point = code_point_at(text, position);
    if (count == longest || point.bytes == 0) return shown + "…`";
    const bool blank = is_space(text[position]);
    if (!blank || !after_blank) {
      const bool control = point.value < 0x20 || (point.value >= 0x7F && point.value < 0xA0);
      shown += blank     ? " "
               : control ? code_point_name(point.value)
                         : std::string(text.substr(position, point.bytes));
      ++count;
    }
    after_blank = blank;
    position += point.bytes;
  }
  return shown + "`";
}

std::string in_backticks(const Span& span) { return in_backticks(covered_text(span)); }

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? "" : "did you mean `" + near + "`?";
}

}  // namespace elgen
