// format: diagnostics as text with position, message, source line, caret and hint; as JSON; or as
// commands of GitHub workflows.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "base/diagnostic_words.hpp"
#include "base/json.hpp"
#include "base/utf8.hpp"
#include "elgen/diagnostic.hpp"

namespace elgen {

namespace {

Json json_position(const Span& span) {
  Json json;
  if (span.source == nullptr) return json;
  const LineColumn begin = line_column(*span.source, span.begin);
  const LineColumn end = line_column(*span.source, span.end);
  json["file"] = span.source->path;
  json["line"] = begin.line;
  json["column"] = begin.column;
  json["end_line"] = end.line;
  json["end_column"] = end.column;
  return json;
}

/// A JSON object on one line.
std::string json_line(const Diagnostic& diagnostic) {
  const CodeRow& row = code_row(diagnostic.code);
  Json json;
  json["severity"] = severity_word(row.severity);
  json["code"] = row.name;
  json["message"] = shorten_quotations(diagnostic.message);
  if (!diagnostic.hint.empty()) json["hint"] = shorten_quotations(diagnostic.hint);
  json["position"] = json_position(diagnostic.span);
  if (diagnostic.related) {
    json["related"] = json_position(*diagnostic.related);
    json["related"]["message"] = shorten_quotations(diagnostic.related_message);
  }
  return visible_json(json.dump()) + "\n";
}

// In the order of Severity.
constexpr std::array<std::string_view, 3> github_words{"notice", "warning", "error"};

/// A command of a GitHub workflow: `::error file=m.toml,line=2,col=10,title=E201 unknown name::...`
std::string github_command(const Diagnostic& diagnostic) {
  const CodeRow& row = code_row(diagnostic.code);
  return text_of(WorkflowCommand{github_words.at(static_cast<std::size_t>(row.severity)),
                                 is_in_file(diagnostic.span) ? diagnostic.span : Span{},
                                 fmt::format("{} {}", row.name, row.title),
                                 message_with_hint(diagnostic)});
}

std::string color_text(std::string_view text, std::string_view sgr, bool color) {
  return color ? fmt::format("\x1b[{}m{}\x1b[0m", sgr, text) : std::string(text);
}

std::string position_text(const Span& span) {
  if (span.source == nullptr) return "elgen";
  const LineColumn at = line_column(*span.source, span.begin);
  return fmt::format("{}:{}:{}", visible_text(span.source->path), at.line, at.column);
}

std::size_t count_code_points(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_code_point));
}

/// Text for a terminal. A tab becomes a space, any other hidden character becomes `?`, and a byte
/// that is not UTF-8 becomes its number, such as `\x9e`.
std::string printable_text(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = code_point_at(text, i);
    const std::size_t bytes = std::max<std::size_t>(1, point.bytes);
    if (text[i] == '\t') {
      result += ' ';
    } else if (point.bytes == 0) {
      result += byte_name(text[i]);
    } else if (is_hidden(point.value)) {
      result += '?';
    } else {
      result += text.substr(i, bytes);
    }
    i += bytes;
  }
  return result;
}

struct Excerpt {
  std::string text;        ///< the visible part of the line
  std::size_t column = 0;  ///< code points before the caret
  std::size_t length = 1;  ///< code points under the caret
};

constexpr std::size_t widest_line = 160;

/// The source line of a span. A long line is cut around the caret, at code point boundaries.
Excerpt make_excerpt(const Span& span) {
  const LineColumn at = line_column(*span.source, span.begin);
  const std::string_view line = line_text(*span.source, at.line);
  const auto start = static_cast<std::size_t>(line.data() - span.source->text.data());
  const std::size_t begin =
      std::min<std::size_t>(std::max<std::size_t>(span.begin, start) - start, line.size());
  const std::size_t end =
      std::clamp<std::size_t>(span.end, start + begin, start + line.size()) - start;
  std::size_t from = 0;
  std::size_t to = line.size();
  if (line.size() > widest_line) {
    from = begin > widest_line / 2 ? begin - widest_line / 2 : 0;
    to = std::min(line.size(), from + widest_line);
    const auto inside = [&](std::size_t i) {
      return i > 0 && i < line.size() && !starts_code_point(line[i]);
    };
    while (inside(from)) --from;
    while (inside(to)) --to;
  }
  const std::string_view before = from == 0 ? "" : "...";
  const std::string_view after = to == line.size() ? "" : "...";
  return {
      fmt::format("{}{}{}", before, printable_text(line.substr(from, to - from)), after),
      before.size() + count_code_points(line.substr(from, begin - from)),
      std::max<std::size_t>(1, count_code_points(line.substr(begin, std::min(end, to) - begin)))};
}

void append_excerpt(std::string& text, const Diagnostic& diagnostic, bool color) {
  const Span& span = diagnostic.span;
  if (span.source == nullptr || span.source->text.empty()) {
    if (!diagnostic.hint.empty())
      text += fmt::format("      {}\n", shorten_quotations(diagnostic.hint));
    return;
  }
  const Excerpt shown = make_excerpt(span);
  const std::string number = std::to_string(line_column(*span.source, span.begin).line);
  const std::string gutter(std::max<std::size_t>(5, number.size()), ' ');
  std::string caret = "^" + std::string(shown.length - 1, '~');
  text += fmt::format("{:>5} | {}\n", number, shown.text);
  text += fmt::format("{} | {}{}", gutter, std::string(shown.column, ' '),
                      color_text(caret, "1;32", color));
  if (!diagnostic.hint.empty()) text += " " + shorten_quotations(diagnostic.hint);
  text += '\n';
}

std::string text_of(const Diagnostic& diagnostic, bool color) {
  const CodeRow& row = code_row(diagnostic.code);
  const std::string_view sgr = row.severity == Severity::error ? "1;31" : "1;33";
  std::string text = fmt::format(
      "{}: {}: {}\n", color_text(position_text(diagnostic.span), "1", color),
      color_text(fmt::format("{}[{}]", severity_word(row.severity), row.name), sgr, color),
      shorten_quotations(diagnostic.message));
  append_excerpt(text, diagnostic, color);
  if (diagnostic.related) {
    text += fmt::format("{}: {}\n", position_text(*diagnostic.related),
                        shorten_quotations(diagnostic.related_message));
  }
  return text;
}

std::string diagnostic_text(const Diagnostic& diagnostic, const DiagnosticStyle& style) {
  switch (style.format) {
    case DiagnosticFormat::text:
      return text_of(diagnostic, style.color);
    case DiagnosticFormat::json:
      return json_line(diagnostic);
    case DiagnosticFormat::github:
      return github_command(diagnostic);
  }
  return {};
}

}  // namespace

const std::vector<DiagnosticFormatRow>& diagnostic_formats() {
  static const std::vector<DiagnosticFormatRow> rows{
      {DiagnosticFormat::text, "text"},
      {DiagnosticFormat::json, "json"},
      {DiagnosticFormat::github, "github"},
  };
  return rows;
}

const DiagnosticFormatRow& format_row(DiagnosticFormat format) {
  return diagnostic_formats()[static_cast<std::size_t>(format)];
}

std::string format(const Diagnostics& diagnostics, const DiagnosticStyle& style) {
  // Programs read JSON, so it contains all diagnostics.
  const std::size_t maximum = style.format == DiagnosticFormat::json
                                  ? std::numeric_limits<std::size_t>::max()
                                  : style.maximum;
  std::string text;
  std::array<std::size_t, 3> found{};  // per severity
  for (const Diagnostic& diagnostic : diagnostics) {
    const Severity severity = code_row(diagnostic.code).severity;
    if (++found.at(static_cast<std::size_t>(severity)) > maximum) continue;
    text += diagnostic_text(diagnostic, style);
  }
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    const std::size_t count = found.at(static_cast<std::size_t>(severity));
    if (count <= maximum) continue;
    text += fmt::format("elgen: {} more {}s not shown\n", count - maximum, severity_word(severity));
  }
  return text;
}

}  // namespace elgen
