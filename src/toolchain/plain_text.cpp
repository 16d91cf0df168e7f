// plain_text: escape sequences are those of ECMA-48: ESC [ parameters letter, ESC ] text BEL, and
// ESC with one character.
#include "toolchain/plain_text.hpp"

#include "base/utf8.hpp"

namespace elgen {
namespace {

constexpr std::size_t most_bytes = 4000;
constexpr char escape = '\x1b';
constexpr char bell = '\a';

/// The first position behind the sequence that begins at `position`.
std::size_t behind_sequence(std::string_view text, std::size_t position) {
  const char kind = position + 1 < text.size() ? text[position + 1] : '\0';
  if (kind != '[' && kind != ']') return position + 2;
  for (std::size_t i = position + 2; i < text.size(); ++i) {
    const bool ends = kind == '[' ? text[i] >= '@' && text[i] <= '~' : text[i] == bell;
    if (ends) return i + 1;
    if (text[i] == '\n') return i;
    if (kind == ']' && text[i] == escape) return i + 2;  // ESC \ ends it as well
  }
  return text.size();
}

}  // namespace

std::string plain_text(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == escape) {
      i = behind_sequence(text, i);
      continue;
    }
    const CodePoint point = code_point_at(text, i);
    if (point.bytes == 0 || plain.size() > most_bytes) return plain + "…\n";
    if (text[i] == '\n' || !is_hidden(point.value)) plain += text.substr(i, point.bytes);
    i += point.bytes;
  }
  return plain;
}

}  // namespace elgen
