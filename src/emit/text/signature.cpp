// signature: arguments stand below the first one, or indented where the start leaves too little
// room.
#include "emit/text/signature.hpp"

#include <algorithm>

#include "emit/text/layout.hpp"

namespace elgen {

std::string signature(const std::string& start, const std::vector<std::string>& arguments,
                      const std::string& end) {
  constexpr std::size_t widest_alignment = 60;
  const auto fits = [&](const std::string& argument) {
    return start.size() + argument.size() + end.size() + 4 <= line_width;
  };
  const bool is_aligned =
      start.size() < widest_alignment && std::all_of(arguments.begin(), arguments.end(), fits);
  const std::string indent(is_aligned ? start.size() + 1 : 4, ' ');
  std::string text = start + "(" + (is_aligned ? "" : "\n" + indent);
  std::size_t column = indent.size();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_last = i + 1 == arguments.size();
    const std::string piece = arguments[i] + (is_last ? ")" + end : ",");
    const std::size_t needed = 1 + piece.size() + (is_last ? 2 : 0);  // the brace follows the last
    const bool breaks = i > 0 && column + needed > line_width;
    if (breaks) text += "\n" + indent;
    if (i > 0 && !breaks) text += ' ';
    column = (breaks ? indent.size() : column + (i > 0 ? 1 : 0)) + piece.size();
    text += piece;
  }
  return text;
}

}  // namespace elgen
