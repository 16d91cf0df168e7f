// Source text and spans: the positions of declarations, values and errors.
//
// A SourceText is one input: a model file, a scene file, or the text of a command-line option. A
// Span is a half-open byte range of a SourceText, which must outlive the Span.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace elgen {

struct LineColumn {
  std::uint32_t line = 1;    ///< number of the line, from 1
  std::uint32_t column = 1;  ///< number of the Unicode code point in the line, from 1
};

struct SourceText {
  std::string path;                        ///< as the user wrote it; "command line" for options
  std::string text;                        ///< UTF-8
  std::vector<std::uint32_t> line_starts;  ///< offset in `text` of the first byte of each line
};

using SourcePointer = std::shared_ptr<const SourceText>;

/// A half-open byte range [begin, end) of `source`; a null `source` means no position.
struct Span {
  const SourceText* source = nullptr;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  bool operator==(const Span&) const = default;
};

[[nodiscard]] SourcePointer make_source(std::string path, std::string text);
/// A source that lives until the process ends. Diagnostics refer to sources without owning them.
[[nodiscard]] SourcePointer make_permanent_source(std::string path, std::string text);

[[nodiscard]] LineColumn line_column(const SourceText& source, std::uint32_t offset);

/// The text of 1-based `line`, without its line end.
[[nodiscard]] std::string_view line_text(const SourceText& source, std::uint32_t line);

/// The last component of the path of a source.
[[nodiscard]] std::string file_name(const SourceText& source);

/// The bytes that a span covers.
[[nodiscard]] std::string_view covered_text(const Span& span);

}  // namespace elgen
