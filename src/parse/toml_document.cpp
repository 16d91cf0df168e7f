// Converts TOML text to TomlValue: toml++ parses, then every value is re-read at its span. toml++
// sorts tables by key, so entries are sorted back into file order. Keys that would overflow the
// stack of toml++ are found before toml++ parses. Each error of toml++ gets a hint on the probable
// mistake.
#include "parse/toml_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/source_text.hpp"
#include "elgen/syntax.hpp"
#include "elgen/wording.hpp"

namespace elgen {

namespace {

/// Converts positions of toml++ to byte offsets. toml++ counts columns in code points and does not
/// count a byte order mark.
class TomlPositions {
 public:
  explicit TomlPositions(const SourceText& source) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    const std::string_view text = source.text;
    const std::size_t begin = text.substr(0, 3) == byte_order_mark ? 3 : 0;
    line_points_.push_back(0);
    for (std::size_t i = begin; i < text.size(); ++i) {
      if (starts_code_point(text[i])) points_.push_back(static_cast<std::uint32_t>(i));
      if (text[i] == '\n') line_points_.push_back(static_cast<std::uint32_t>(points_.size()));
    }
    points_.push_back(static_cast<std::uint32_t>(text.size()));
  }

  /// The byte offset of 1-based `line` and `column`; a position beyond the file gives its end.
  [[nodiscard]] std::uint32_t offset(std::uint32_t line, std::uint32_t column) const {
    if (line == 0 || line > line_points_.size()) return points_.back();
    const std::size_t point = std::size_t{line_points_[line - 1]} + column - 1;
    return points_[std::min(point, points_.size() - 1)];
  }

 private:
  std::vector<std::uint32_t> points_;       ///< byte offset of each code point
  std::vector<std::uint32_t> line_points_;  ///< index of the first code point of each line
};

constexpr std::size_t most_key_parts = 100;

bool is_key_character(char c) { return is_word_character(c) || c == '-'; }

/// The position just behind the quoted part at `begin`. If no quote closes this part on the same
/// line, the position just behind its opening quote.
std::size_t skip_quoted(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  for (std::size_t i = begin + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == quote) return i + 1;
    if (text[i] == '\\' && quote == '"') ++i;
  }
  return begin + 1;
}

/// The position at which a dotted key exceeds most_key_parts parts. toml++ limits the depth of
/// nested values, but not the length of `a.b.c…`, and frees the nested tables recursively.
std::optional<std::size_t> find_too_long_key(std::string_view text) {
  std::size_t points = 0;
  bool after_part = false;
  bool after_space = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = skip_quoted(text, i);
      after_part = true;
      continue;
    }
    if (c == '.' && after_part) {
      if (++points == most_key_parts) return i;
      after_part = false;
    } else if (is_key_character(c)) {
      if (after_part && after_space) points = 0;  // `a b.c`: a new key begins at `b`
      after_part = true;
    } else if (c != ' ' && c != '\t') {
      points = 0;
      after_part = false;
    }
    after_space = c == ' ' || c == '\t';
    ++i;
  }
  return std::nullopt;
}

bool is_token_character(char c) { return is_word_character(c) || c == '.' || c == '+' || c == '-'; }

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// "Error while parsing key-value pair: cannot redefine existing integer 'a'" to
/// "cannot redefine existing integer `a`".
std::string short_toml_message(std::string_view description) {
  const std::size_t colon = description.find(": ");
  std::string message(colon == std::string_view::npos ? description
                                                      : description.substr(colon + 2));
  std::ranges::replace(message, '\'', '`');
  return message;
}

/// The word at `offset` or just before `offset`: toml++ stops inside or behind a number that is out
/// of range.
Span word_at(const SourceText& source, std::uint32_t offset) {
  std::uint32_t begin = offset;
  std::uint32_t end = offset;
  while (begin > 0 && is_token_character(source.text[begin - 1])) --begin;
  while (end < source.text.size() && is_token_character(source.text[end])) ++end;
  return {&source, begin, end};
}

/// The span of one character; empty at the end of the file.
Span character_at(const SourceText& source, std::uint32_t offset) {
  if (offset >= source.text.size()) return {&source, offset, offset};
  const std::size_t bytes = std::max<std::size_t>(1, code_point_at(source.text, offset).bytes);
  return {&source, offset, offset + static_cast<std::uint32_t>(bytes)};
}

/// The span for a redefinition: the key of the second value, because toml++ gives the position of
/// the value. For a redefined header, the position of toml++.
Span redefinition_span(const SourceText& source, std::uint32_t offset) {
  std::uint32_t end = offset;
  while (end > 0 && (source.text[end - 1] == ' ' || source.text[end - 1] == '=')) --end;
  const Span key = word_at(source, end);
  return end < offset && key.begin < key.end ? key : character_at(source, offset);
}

/// The span of `key` in the last earlier line that defines `key` in the same table; none if no
/// earlier line of this table defines `key`.
std::optional<Span> find_first_definition(const SourceText& source, const Span& key) {
  const std::string_view name = covered_text(key);
  std::optional<Span> found;
  for (std::size_t line = 0; line < key.begin; ++line) {
    const std::size_t begin =
        std::min(source.text.find_first_not_of(" \t", line), source.text.size());
    const std::string_view rest = std::string_view(source.text).substr(begin);
    const std::string_view after = rest.substr(std::min(name.size(), rest.size()));
    if (rest.starts_with('[')) found = std::nullopt;
    if (begin < key.begin && rest.starts_with(name) &&
        after.substr(std::min(after.find_first_not_of(" \t"), after.size())).starts_with('=')) {
      const auto first = static_cast<std::uint32_t>(begin);
      found = Span{&source, first, first + static_cast<std::uint32_t>(name.size())};
    }
    line = std::min(source.text.find('\n', line), source.text.size());
  }
  return found;
}

/// E107 at the first header in single brackets of an entry that needs double brackets; none if all
/// headers have the right brackets.
std::optional<Diagnostic> find_single_header(const SourceText& source) {
  for (const std::uint32_t begin : source.line_starts) {
    const std::string_view line = std::string_view(source.text).substr(begin);
    for (const EntryRow& row : entry_table()) {
      const std::string header = fmt::format("[{}]", row.entry);
      if (!row.repeated || !line.starts_with(header)) continue;
      const auto end = begin + static_cast<std::uint32_t>(header.size());
      return Diagnostic{Code::E107,
                        {&source, begin, end},
                        quote_text(header) + " is the wrong kind of table",
                        fmt::format("write `[{}]`", header)};
    }
  }
  return std::nullopt;
}

Diagnostic redefinition_error(const SourceText& source, std::uint32_t offset,
                              std::string_view description) {
  if (auto single = find_single_header(source)) return *std::move(single);
  Diagnostic error{Code::E101, redefinition_span(source, offset), short_toml_message(description)};
  if (const auto first = find_first_definition(source, error.span)) {
    error.hint = "rename one of them";
    error.related = *first;
    error.related_message = "first given here";
  } else if (source.text[error.span.begin] == '[') {
    error.hint = "join the two tables";
  }
  return error;
}

/// The error at the first marker of git, if the file has one.
std::optional<Diagnostic> find_merge_marker(const SourceText& source) {
  for (const std::uint32_t begin : source.line_starts) {
    const std::string_view line = std::string_view(source.text).substr(begin);
    if (!line.starts_with("<<<<<<< ") && !line.starts_with(">>>>>>> ")) continue;
    return Diagnostic{Code::E101,
                      {&source, begin, begin + 7},
                      "a merge is not finished",
                      "keep one version, and remove the lines `<<<<<<<`, `=======`, `>>>>>>>`"};
  }
  return std::nullopt;
}

/// The error of `0,5`: toml++ stops at the comma or, in a table, behind the key `5`.
std::optional<Diagnostic> find_decimal_comma(const SourceText& source, std::uint32_t offset,
                                             std::string_view description) {
  const std::string_view text = source.text;
  const bool is_behind = contains(description, "expected '='") && offset > 0;
  const std::size_t comma = is_behind ? text.rfind(',', offset - 1) : offset;
  if (comma == 0 || comma == std::string_view::npos) return std::nullopt;
  const std::string_view around = text.substr(comma - 1, 3);
  const bool is_decimal =
      around.size() == 3 && is_digit(around[0]) && around[1] == ',' && is_digit(around[2]);
  if (!is_decimal) return std::nullopt;
  const auto at = static_cast<std::uint32_t>(comma);
  const Span number{&source, word_at(source, at).begin, word_at(source, at + 1).end};
  std::string point(covered_text(number));
  std::ranges::replace(point, ',', '.');
  return Diagnostic{Code::E306, number, in_backticks(number) + " has a decimal comma",
                    fmt::format("write `{}`", point)};
}

bool is_at_line_end(const SourceText& source, std::uint32_t offset) {
  return offset >= source.text.size() || source.text[offset] == '\n' || source.text[offset] == '\r';
}

bool is_range_error(std::string_view description) {
  return contains(description, "not representable") || contains(description, "length limit") ||
         contains(description, "could not be interpreted") || contains(description, "too long");
}

std::string hint_of(std::string_view description) {
  if (contains(description, "escape sequence")) {
    return "a backslash is written twice; expressions have none: `dot(x)`, `theta`";
  }
  const bool lacks_quotes = contains(description, "decimal integer") ||
                            contains(description, "floating-point") ||
                            contains(description, "could not determine value type");
  return lacks_quotes ? "texts and expressions are written in quotes" : "";
}

/// True if the text of a token is a decimal number as TOML writes it: `-1_000`, `+0.5e-3`.
bool is_decimal_token(std::string_view token) {
  const std::size_t sign = token.substr(0, 1) == "+" || token.substr(0, 1) == "-" ? 1 : 0;
  const std::string_view digits = token.substr(sign);
  const bool radix = digits.size() > 1 && digits[0] == '0' &&
                     (digits[1] == 'x' || digits[1] == 'o' || digits[1] == 'b');
  constexpr std::string_view characters = "0123456789_.eE+-";
  return !digits.empty() && is_digit(digits[0]) && !radix &&
         digits.find_first_not_of(characters) == std::string_view::npos;
}

/// The error for toml++'s message `description` at the byte `offset`: E109 for a decimal outside
/// TOML's range, E306 for a decimal comma, E107 for a repeated header, else E101.
Diagnostic toml_error(const SourceText& source, std::uint32_t offset,
                      std::string_view description) {
  if (auto error = find_merge_marker(source)) return *std::move(error);
  if (auto error = find_decimal_comma(source, offset, description)) return *std::move(error);
  const Span word = word_at(source, offset);
  if (is_range_error(description) && is_decimal_token(covered_text(word))) {
    return {Code::E109, word, quote_text(covered_text(word)) + " is wider than TOML's numbers",
            "write it as a string, in quotes"};
  }
  if (contains(description, "parsing string") && is_at_line_end(source, offset)) {
    return {Code::E101, character_at(source, offset), "string is not closed",
            "a string over several lines has three quotes at each end"};
  }
  if (contains(description, "cannot redefine"))
    return redefinition_error(source, offset, description);
  return {Code::E101, character_at(source, offset), short_toml_message(description),
          hint_of(description)};
}

class DocumentBuilder {
 public:
  explicit DocumentBuilder(const SourceText& source) : source_(source), positions_(source) {}

  [[nodiscard]] TomlValue build_value(const toml::node& node) const {
    TomlValue result;
    result.span = span(node.source());
    if (node.is_string()) {
      result.kind = TomlKind::string;
      result.text = decode_string(result.span);
    } else if (const auto* boolean = node.as_boolean()) {
      result.kind = TomlKind::boolean;
      result.boolean = boolean->get();
    } else if (const auto* array = node.as_array()) {
      result.kind = TomlKind::array;
      for (const toml::node& item : *array) result.items.push_back(build_value(item));
    } else if (const auto* table = node.as_table()) {
      result.entries = build_entries(*table);
    } else {
      result.text = verbatim_text(result.span);
      const bool decimal = node.is_number() && is_decimal_token(result.text.text);
      result.kind = decimal ? TomlKind::number : TomlKind::other;
    }
    return result;
  }

  [[nodiscard]] std::uint32_t offset(const toml::source_position& position) const {
    return positions_.offset(position.line, position.column);
  }

 private:
  [[nodiscard]] Span span(const toml::source_region& region) const {
    return {&source_, offset(region.begin), offset(region.end)};
  }
  [[nodiscard]] std::vector<TomlEntry> build_entries(const toml::table& table) const {
    std::vector<TomlEntry> result;
    for (const auto& [key, node] : table) {
      result.push_back({std::string(key.str()), span(key.source()), build_value(node)});
    }
    std::ranges::sort(result, [](const TomlEntry& a, const TomlEntry& b) {
      return a.key_span.begin < b.key_span.begin;
    });
    return result;
  }

  const SourceText& source_;
  TomlPositions positions_;
};

}  // namespace

const TomlEntry* find_entry(const std::vector<TomlEntry>& entries, std::string_view key) {
  const auto found = std::ranges::find(entries, key, &TomlEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

Result<TomlValue> read_toml(const SourceText& source) {
  if (const auto endless = find_too_long_key(source.text)) {
    const auto begin = static_cast<std::uint32_t>(*endless);
    return Diagnostic{Code::E101,
                      {&source, begin, begin + 1},
                      "key of more than " + std::to_string(most_key_parts) + " parts"};
  }
  const DocumentBuilder builder(source);
  try {
    return builder.build_value(toml::parse(source.text));
  } catch (const toml::parse_error& error) {
    return toml_error(source, builder.offset(error.source().begin), error.description());
  }
}

}  // namespace elgen
