// UTF-8 as RFC 3629 has it: no overlong forms, no surrogates, nothing beyond U+10FFFF.
#include "utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace elgen {

namespace {

struct Form {
  unsigned char mask;  ///< the bits of the first byte that tell the length
  unsigned char mark;  ///< their value
  std::size_t bytes;
  char32_t smallest;  ///< below, a shorter form exists
};

constexpr std::array<Form, 4> forms{Form{0x80, 0x00, 1, 0x0}, Form{0xE0, 0xC0, 2, 0x80},
                                    Form{0xF0, 0xE0, 3, 0x800}, Form{0xF8, 0xF0, 4, 0x10000}};

bool is_scalar_value(char32_t value) {
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  return !surrogate && value <= 0x10FFFF;
}

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t position) {
  const auto first = static_cast<unsigned char>(text[position]);
  const auto form = std::find_if(forms.begin(), forms.end(),
                                 [&](const Form& f) { return (first & f.mask) == f.mark; });
  if (form == forms.end() || position + form->bytes > text.size()) return {};
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

void append_utf8(std::string& text, char32_t value) {
  const auto form = std::find_if(forms.rbegin(), forms.rend(),
                                 [&](const Form& f) { return value >= f.smallest; });
  const std::size_t bytes = form->bytes;
  text += static_cast<char>(form->mark | (value >> (6 * (bytes - 1))));
  for (std::size_t i = bytes - 1; i > 0; --i) {
    text += static_cast<char>(0x80U | ((value >> (6 * (i - 1))) & 0x3FU));
  }
}

}  // namespace elgen
