// Finds `part.part.part…` on one line, parts bare or quoted, wherever it stands: outside of keys
// nobody writes a hundred words with a point between each two.
#include "parse/toml_guard.hpp"

#include "base/ascii.hpp"

namespace elgen {

namespace {

bool is_key_character(char c) { return is_word_character(c) || c == '-'; }

/// Just behind the quoted part at `begin`, or behind its quote where it is not closed on its line.
std::size_t skip_quoted(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  for (std::size_t i = begin + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == quote) return i + 1;
    if (text[i] == '\\' && quote == '"') ++i;
  }
  return begin + 1;
}

}  // namespace

std::optional<std::size_t> find_endless_key(std::string_view text) {
  std::size_t points = 0;
  bool after_part = false;
  bool after_space = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = skip_quoted(text, i);
      after_part = true;
      continue;
    }
    if (c == '.' && after_part) {
      if (++points == most_key_parts) return i;
      after_part = false;
    } else if (is_key_character(c)) {
      if (after_part && after_space) points = 0;  // two words are no key
      after_part = true;
    } else if (c != ' ' && c != '\t') {
      points = 0;
      after_part = false;
    }
    after_space = c == ' ' || c == '\t';
    ++i;
  }
  return std::nullopt;
}

}  // namespace elgen
