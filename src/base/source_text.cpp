// SourceText: maps byte offsets to lines and columns. Columns count code points, as editors do.
#include "elgen/source_text.hpp"

#include <algorithm>
#include <utility>

#include "base/utf8.hpp"

namespace elgen {

namespace {

/// A byte order mark at the start is not counted in columns of the first line.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

SourcePointer make_source(std::string path, std::string text) {
  auto source = std::make_shared<SourceText>();
  source->path = std::move(path);
  source->text = std::move(text);
  source->line_starts.push_back(0);
  for (std::size_t i = 0; i < source->text.size(); ++i) {
    if (source->text[i] == '\n') source->line_starts.push_back(static_cast<std::uint32_t>(i + 1));
  }
  return source;
}

SourcePointer make_permanent_source(std::string path, std::string text) {
  static std::vector<SourcePointer> sources;
  return sources.emplace_back(make_source(std::move(path), std::move(text)));
}

std::string file_name(const SourceText& source) {
  return source.path.substr(source.path.find_last_of("/\\") + 1);
}

LineColumn line_column(const SourceText& source, std::uint32_t offset) {
  const auto end = static_cast<std::uint32_t>(source.text.size());
  offset = std::min(offset, end);
  const auto& starts = source.line_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
  std::uint32_t start = *(next - 1);
  const bool is_marked = std::string_view(source.text).substr(0, 3) == byte_order_mark;
  if (start == 0 && is_marked) start = std::min<std::uint32_t>(3, offset);
  const auto points =
      std::count_if(source.text.begin() + start, source.text.begin() + offset, starts_code_point);
  return {static_cast<std::uint32_t>(next - starts.begin()),
          static_cast<std::uint32_t>(points) + 1};
}

std::string_view line_text(const SourceText& source, std::uint32_t line) {
  const std::string_view text = source.text;
  const std::uint32_t start = source.line_starts.at(line - 1);
  std::string_view rest = text.substr(start);
  if (start == 0 && rest.substr(0, 3) == byte_order_mark) rest.remove_prefix(3);
  rest = rest.substr(0, rest.find('\n'));
  if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
  return rest;
}

std::string_view covered_text(const Span& span) {
  if (span.source == nullptr) return {};
  return std::string_view(span.source->text).substr(span.begin, span.end - span.begin);
}

}  // namespace elgen
