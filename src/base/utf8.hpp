// UTF-8: code points of a text, and where it stops being UTF-8.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace elgen {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 0;  ///< 0: the bytes here are not UTF-8
};

/// The code point at `position`, which lies inside `text`.
[[nodiscard]] CodePoint code_point_at(std::string_view text, std::size_t position);

/// The text is UTF-8.
[[nodiscard]] constexpr bool starts_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// The first byte that is not part of UTF-8 text.
[[nodiscard]] std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// "U+03C0".
[[nodiscard]] std::string code_point_name(char32_t value);

/// "\x9e"
[[nodiscard]] std::string byte_name(char byte);

/// Whether it is not seen but does something: control characters, line separators, and the format
/// characters of Unicode, which reorder or join what is seen.
[[nodiscard]] bool is_hidden(char32_t value);

/// Hidden characters other than tabs and line ends become their names, and bytes that are not UTF-8
/// question marks.
[[nodiscard]] std::string visible_text(std::string_view text);

/// Hidden characters of a JSON text, which stand in its strings, become its escapes.
[[nodiscard]] std::string visible_json(std::string_view json);

void append_utf8(std::string& text, char32_t value);

}  // namespace elgen
