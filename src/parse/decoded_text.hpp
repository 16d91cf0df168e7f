// DecodedText: the decoded value of a TOML string, and the position in the file of each decoded
// byte.
//
//     file     "1/2\u002ak"     pieces  [0,3) copied, [3,4) from the six bytes of the escape,
//     decoded   1/2*k                   [4,5) copied
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// A run of decoded bytes, and the bytes of the file from which they come. A copied run has equally
/// many bytes in the file; an escape is a piece that cannot be divided.
struct TextPiece {
  std::size_t begin = 0;  ///< in the decoded text
  std::size_t file_begin = 0;
  std::size_t file_length = 0;
  bool is_verbatim = true;
};

struct DecodedText {
  const SourceText* source = nullptr;
  std::string text = {};
  std::vector<TextPiece> pieces = {};
  Span content_span = {};  ///< inside the quotes

  /// The bytes of the file from which the decoded bytes [begin, end) come. The span of an empty
  /// range is just behind the preceding byte, so that an error about a missing token points behind
  /// the last character.
  [[nodiscard]] Span span(std::size_t begin, std::size_t end) const;

 private:
  [[nodiscard]] const TextPiece& piece_at(std::size_t position) const;
  [[nodiscard]] std::size_t file_begin(std::size_t position) const;
  [[nodiscard]] std::size_t file_end(std::size_t position) const;
};

/// The text of a span, copied byte by byte.
[[nodiscard]] DecodedText verbatim_text(const Span& span);

/// Decodes a TOML string of any of the four forms. `token` includes the quotes and must be
/// well-formed (toml++ has accepted it).
[[nodiscard]] DecodedText decode_string(const Span& token);

}  // namespace elgen
