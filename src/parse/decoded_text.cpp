// TOML strings re-read from the file: basic "…" and """…""" with escapes, literal '…' and '''…'''.
// Every decoded byte keeps its position, so that an error inside an expression is shown at its
// place in the file.
#include "parse/decoded_text.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"

namespace elgen {

namespace {

Span make_span(const SourceText* source, std::size_t begin, std::size_t end) {
  return {source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

/// Decodes the bytes inside the quotes of one string.
class StringDecoder {
 public:
  explicit StringDecoder(const Span& token) {
    const std::string_view bytes = covered_text(token);
    is_multi_line_ = bytes.size() >= 6 && bytes[1] == bytes[0] && bytes[2] == bytes[0];
    has_escapes_ = bytes[0] == '"';
    const std::uint32_t quotes = is_multi_line_ ? 3 : 1;
    result_.source = token.source;
    position_ = token.begin + quotes;
    end_ = token.end - quotes;
    if (is_multi_line_) skip_line_end();
    result_.content_span = make_span(token.source, position_, end_);
  }

  DecodedText decode() && {
    while (position_ < end_) {
      if (has_escapes_ && current_byte() == '\\') {
        read_escape();
      } else if (current_byte() == '\r') {
        ++position_;  // \r\n is decoded as one line feed
      } else {
        copy_byte();
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] char current_byte() const { return result_.source->text[position_]; }

  void skip_line_end() {
    if (position_ < end_ && current_byte() == '\r') ++position_;
    if (position_ < end_ && current_byte() == '\n') ++position_;
  }

  void copy_byte() {
    auto& pieces = result_.pieces;
    const bool continues = !pieces.empty() && pieces.back().is_verbatim &&
                           pieces.back().file_begin + pieces.back().file_length == position_;
    if (!continues) pieces.push_back({result_.text.size(), position_, 0, true});
    ++pieces.back().file_length;
    result_.text += current_byte();
    ++position_;
  }

  void read_escape() {
    const std::size_t begin = position_++;
    const char letter = current_byte();
    if (is_space(letter)) {
      while (position_ < end_ && is_space(current_byte())) ++position_;
      return;
    }
    ++position_;
    const std::size_t decoded = result_.text.size();
    if (letter == 'u' || letter == 'U') {
      read_code_point(letter == 'u' ? 4 : 8);
    } else {
      result_.text += decode_simple_escape(letter);
    }
    result_.pieces.push_back({decoded, begin, position_ - begin, false});
  }

  void read_code_point(std::size_t digits) {
    const char* first = result_.source->text.data() + position_;
    std::uint32_t value = 0;
    std::from_chars(first, first + digits, value, 16);
    append_utf8(result_.text, value);
    position_ += digits;
  }

  /// The character of the escape \`letter`: a control character, or `letter` itself for \" and \\.
  static char decode_simple_escape(char letter) {
    const std::size_t at = std::string_view("btnfre").find(letter);
    return at == std::string_view::npos ? letter : "\b\t\n\f\r\x1b"[at];
  }

  DecodedText result_;
  bool is_multi_line_ = false;
  bool has_escapes_ = false;
  std::size_t position_ = 0;
  std::size_t end_ = 0;
};

}  // namespace

const TextPiece& DecodedText::piece_at(std::size_t position) const {
  const auto next =
      std::upper_bound(pieces.begin(), pieces.end(), position,
                       [](std::size_t p, const TextPiece& piece) { return p < piece.begin; });
  return *(next - 1);
}

std::size_t DecodedText::file_begin(std::size_t position) const {
  const TextPiece& piece = piece_at(position);
  return piece.file_begin + (piece.is_verbatim ? position - piece.begin : 0);
}

std::size_t DecodedText::file_end(std::size_t position) const {
  const TextPiece& piece = piece_at(position - 1);
  return piece.file_begin + (piece.is_verbatim ? position - piece.begin : piece.file_length);
}

Span DecodedText::span(std::size_t begin, std::size_t end) const {
  if (end == 0) return make_span(source, content_span.begin, content_span.begin);
  const std::size_t last = file_end(end);
  return make_span(source, begin == end ? last : file_begin(begin), last);
}

DecodedText verbatim_text(const Span& span) {
  const std::string_view bytes = covered_text(span);
  return {span.source, std::string(bytes), {{0, span.begin, bytes.size(), true}}, span};
}

DecodedText decode_string(const Span& token) { return StringDecoder(token).decode(); }

}  // namespace elgen
