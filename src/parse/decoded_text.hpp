// DecodedText: what a TOML string says, with the way back from each of its bytes to the file.
//
//     file     "1/2\u002ak"     pieces  [0,3) as it stands, [3,4) from the six bytes of the escape,
//     decoded   1/2*k                   [4,5) as it stands
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/source_text.hpp"

namespace elgen {

/// A run of decoded bytes and the bytes of the file it came from. Runs of one length on both sides
/// are copies; others are escapes, which stand or fall as a whole.
struct TextPiece {
  std::size_t begin = 0;  ///< in the decoded text
  std::size_t file_begin = 0;
  std::size_t file_length = 0;
  bool copied = true;
};

struct DecodedText {
  const SourceText* source = nullptr;
  std::string text = {};
  std::vector<TextPiece> pieces = {};
  Span whole = {};  ///< inside the quotes

  /// The bytes of the file behind decoded bytes [begin, end). An empty range lies just after the
  /// byte before it, so that "something is missing here" points behind the last thing written.
  [[nodiscard]] Span span(std::size_t begin, std::size_t end) const;

 private:
  [[nodiscard]] const TextPiece& piece_at(std::size_t position) const;
  [[nodiscard]] std::size_t file_begin(std::size_t position) const;
  [[nodiscard]] std::size_t file_end(std::size_t position) const;
};

/// Bytes of the file as they stand.
[[nodiscard]] DecodedText copied_text(const Span& span);

/// A TOML string of any of the four forms; `token` covers it with its quotes and must be
/// well-formed (toml++ accepted it).
[[nodiscard]] DecodedText decode_string(const Span& token);

}  // namespace elgen
