// utf8: code points of a text, and the position of the first byte that is not UTF-8.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace elgen {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 0;  ///< 0: not UTF-8 at this position
};

/// The code point at `position`, which must be less than the size of `text`.
[[nodiscard]] CodePoint code_point_at(std::string_view text, std::size_t position);

/// True for the first byte of a code point. `byte` must be from UTF-8 text.
[[nodiscard]] constexpr bool starts_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// The position of the first byte that is not UTF-8; none if the whole text is UTF-8.
[[nodiscard]] std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// "U+03C0".
[[nodiscard]] std::string code_point_name(char32_t value);

/// "\x9e"
[[nodiscard]] std::string byte_name(char byte);

/// True for a character that is invisible but has an effect: control characters, line separators,
/// and the format characters of Unicode, which reorder or join other characters.
[[nodiscard]] bool is_hidden(char32_t value);

/// `text` with names in place of hidden characters other than tabs and line ends, and with question
/// marks in place of bytes that are not UTF-8.
[[nodiscard]] std::string visible_text(std::string_view text);

/// `json` with escapes for hidden characters from U+007F on, which JSON has only inside strings.
[[nodiscard]] std::string visible_json(std::string_view json);

void append_utf8(std::string& text, char32_t value);

}  // namespace elgen
