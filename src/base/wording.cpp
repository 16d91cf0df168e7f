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

std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (!is_space(c)) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

std::string shown_path(std::string_view path) {
  std::string shown;
  for (std::size_t i = 0; i < path.size();) {
    const CodePoint point = code_point_at(path, i);
    const std::size_t bytes = std::max<std::size_t>(1, point.bytes);
    const bool is_seen = point.bytes != 0 && !is_hidden(point.value);
    for (const char c : path.substr(i, bytes)) {
      shown += is_seen ? std::string(1, c) : byte_name(c);
    }
    i += bytes;
  }
  return shown;
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
