// Long names are cut on code point boundaries.
#include "base/diagnostic_words.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace elgen {

std::string shortened(std::string_view message) {
  constexpr std::size_t longest = 200;
  std::string text;
  for (bool is_quoted = false; !message.empty(); is_quoted = !is_quoted) {
    const std::size_t size = std::min(message.find('`'), message.size());
    std::size_t shown = is_quoted ? std::min(size, longest) : size;
    while (shown < size && !starts_code_point(message[shown])) --shown;
    text += message.substr(0, shown);
    if (shown < size) text += "…";
    if (size < message.size()) text += '`';
    message.remove_prefix(std::min(size + 1, message.size()));
  }
  return text;
}

}  // namespace elgen
