// ascii: classes of characters, independent of the locale.
#pragma once

#include <cstddef>
#include <string_view>

namespace elgen {

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

[[nodiscard]] constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// True if `c` may follow the first character of a name.
[[nodiscard]] constexpr bool is_word_character(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}

[[nodiscard]] constexpr char to_upper_case(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

[[nodiscard]] constexpr char to_lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// True for a blank or a line end.
[[nodiscard]] constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// True if `words`, a list with a space before and after each word, contains `word`.
[[nodiscard]] constexpr bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at < words.size(); at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool is_whole = at > 0 && words[at - 1] == ' ' && end < words.size() && words[end] == ' ';
    if (is_whole) return true;
  }
  return false;
}

}  // namespace elgen
