// utf8: UTF-8 as in RFC 3629: no overlong forms, no surrogates, nothing beyond U+10FFFF.
#include "base/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/ascii.hpp"

namespace elgen {

namespace {

struct Utf8Length {
  unsigned char mask;  ///< bits of the first byte that encode the length
  unsigned char mark;  ///< the value of these bits
  std::size_t bytes;
  char32_t smallest;  ///< smallest code point that needs this length
};

constexpr std::array<Utf8Length, 4> utf8_lengths{
    Utf8Length{0x80, 0x00, 1, 0x0}, Utf8Length{0xE0, 0xC0, 2, 0x80},
    Utf8Length{0xF0, 0xE0, 3, 0x800}, Utf8Length{0xF8, 0xF0, 4, 0x10000}};

struct CodePointRange {
  char32_t first;
  char32_t last;
};

/// Ranges of the hidden characters: categories Cc, Cf, Zl and Zp of Unicode 15, letters without a
/// visible glyph, and tags.
constexpr std::array hidden_ranges{
    CodePointRange{0x0000, 0x001F},   CodePointRange{0x007F, 0x009F},
    CodePointRange{0x00AD, 0x00AD},   CodePointRange{0x034F, 0x034F},
    CodePointRange{0x0600, 0x0605},   CodePointRange{0x061C, 0x061C},
    CodePointRange{0x06DD, 0x06DD},   CodePointRange{0x070F, 0x070F},
    CodePointRange{0x0890, 0x0891},   CodePointRange{0x08E2, 0x08E2},
    CodePointRange{0x115F, 0x1160},   CodePointRange{0x17B4, 0x17B5},
    CodePointRange{0x180B, 0x180F},   CodePointRange{0x200B, 0x200F},
    CodePointRange{0x2028, 0x202E},   CodePointRange{0x2060, 0x206F},
    CodePointRange{0x3164, 0x3164},   CodePointRange{0xFEFF, 0xFEFF},
    CodePointRange{0xFFA0, 0xFFA0},   CodePointRange{0xFFF9, 0xFFFB},
    CodePointRange{0x110BD, 0x110BD}, CodePointRange{0x110CD, 0x110CD},
    CodePointRange{0x13430, 0x1343F}, CodePointRange{0x1BCA0, 0x1BCA3},
    CodePointRange{0x1D173, 0x1D17A}, CodePointRange{0xE0000, 0xE0FFF}};

bool is_scalar_value(char32_t value) {
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  return !surrogate && value <= 0x10FFFF;
}

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t position) {
  const auto first = static_cast<unsigned char>(text[position]);
  const auto form = std::find_if(utf8_lengths.begin(), utf8_lengths.end(),
                                 [&](const Utf8Length& f) { return (first & f.mask) == f.mark; });
  if (form == utf8_lengths.end() || position + form->bytes > text.size()) return {};
  char32_t value = first & static_cast<unsigned char>(~form->mask);
  for (std::size_t i = 1; i < form->bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[position + i]);
    if ((next & 0xC0U) != 0x80U) return {};
    value = (value << 6U) | (next & 0x3FU);
  }
  if (value < form->smallest || !is_scalar_value(value)) return {};
  return {value, form->bytes};
}

std::optional<std::size_t> find_invalid_utf8(std::string_view text) {
  std::size_t position = 0;
  while (position < text.size()) {
    const CodePoint point = code_point_at(text, position);
    if (point.bytes == 0) return position;
    position += point.bytes;
  }
  return std::nullopt;
}

std::string code_point_name(char32_t value) {
  return fmt::format("U+{:04X}", static_cast<std::uint32_t>(value));
}

std::string byte_name(char byte) {
  return fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
}

bool is_hidden(char32_t value) {
  return std::any_of(
      hidden_ranges.begin(), hidden_ranges.end(),
      [value](const CodePointRange& range) { return value >= range.first && value <= range.last; });
}

std::string visible_text(std::string_view text) {
  std::string visible;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = code_point_at(text, i);
    if (point.bytes == 0) {
      visible += '?';
    } else if (is_hidden(point.value) && !is_space(text[i])) {
      visible += code_point_name(point.value);
    } else {
      visible += text.substr(i, point.bytes);
    }
    i += std::max<std::size_t>(1, point.bytes);
  }
  return visible;
}

std::string visible_json(std::string_view json) {
  std::string visible;
  const auto escape = [&visible](std::uint32_t unit) { visible += fmt::format("\\u{:04x}", unit); };
  for (std::size_t i = 0; i < json.size();) {
    const CodePoint point = code_point_at(json, i);
    const std::size_t bytes = std::max<std::size_t>(1, point.bytes);
    const std::uint32_t value = point.value;
    if (value < 0x7F || !is_hidden(point.value)) {
      visible += json.substr(i, bytes);
    } else if (value < 0x10000) {
      escape(value);
    } else {
      escape(0xD800 + ((value - 0x10000) >> 10U));
      escape(0xDC00 + ((value - 0x10000) & 0x3FFU));
    }
    i += bytes;
  }
  return visible;
}

void append_utf8(std::string& text, char32_t value) {
  const auto form = std::find_if(utf8_lengths.rbegin(), utf8_lengths.rend(),
                                 [&](const Utf8Length& f) { return value >= f.smallest; });
  const std::size_t bytes = form->bytes;
  text += static_cast<char>(form->mark | (value >> (6 * (bytes - 1))));
  for (std::size_t i = bytes - 1; i > 0; --i) {
    text += static_cast<char>(0x80U | ((value >> (6 * (i - 1))) & 0x3FU));
  }
}

}  // namespace elgen
