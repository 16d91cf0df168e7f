// Keys of one table: reports unknown, missing and unsupported keys, and reads each value by the row
// of its key.
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/reason.hpp"
#include "elgen/outputs.hpp"
#include "elgen/wording.hpp"
#include "parse/entry_reader.hpp"
#include "parse/expression_parser.hpp"
#include "parse/lexer.hpp"
#include "parse/value_reader.hpp"

namespace elgen {

namespace {

// Texts with several parts

/// One part of a text with several parts: its key in the resulting table, and its bytes in the
/// decoded text.
struct TextPart {
  const char* key;
  std::size_t begin = 0;
  std::size_t end = 0;
  ValueKind kind = ValueKind::expression;
};

using TextParts = std::vector<TextPart>;

/// A kind of text with several parts: the words for messages, and the error for other texts.
struct SplitTextKind {
  std::string_view noun;
  std::string_view expected;
  Code code;
  const char* hint;
  TextParts (*split)(const DecodedText& text);
};

/// "i in 1..n" to { index = i, low = 1, high = n }
TextParts split_repetition(const DecodedText& text) {
  const std::size_t dots = text.text.find("..");
  if (dots == std::string::npos) return {};
  Lexer lexer(text, 0, dots);
  const Token index = lexer.advance();
  const Token in = lexer.advance();
  if (index.kind != TokenKind::name || lexer.text(in) != "in") return {};
  return {{"index", index.begin, index.end},
          {"low", in.end, dots},
          {"high", dots + 2, text.text.size()}};
}

/// "a > b" to { left = a, sign = ">", right = b }. A second comparison is reported as an error in
/// `right`.
TextParts split_condition(const DecodedText& text) {
  const std::size_t begin = text.text.find_first_of("<>");
  if (begin == std::string::npos) return {};
  const std::size_t end = text.text.substr(begin + 1).starts_with('=') ? begin + 2 : begin + 1;
  return {
      {"left", 0, begin}, {"sign", begin, end, ValueKind::text}, {"right", end, text.text.size()}};
}

/// "a = b" to { left = a, right = b }
TextParts split_equation(const DecodedText& text) {
  const std::size_t sign = text.text.find('=');
  if (sign == std::string::npos || text.text.find('=', sign + 1) != std::string::npos) return {};
  return {{"left", 0, sign}, {"right", sign + 1, text.text.size()}};
}

constexpr SplitTextKind repetition_text{"repetition", "a repetition (a string)", Code::E210,
                                        "a repetition is written `i in 1..n`", &split_repetition};
constexpr SplitTextKind condition_text{
    "condition", "a condition (a string)", Code::E320,
    "a condition is written `a > b`, with one of `>`, `>=`, `<` and `<=`", &split_condition};
constexpr SplitTextKind equation_text{"equation", "an equation (a string)", Code::E321,
                                      "an equation is written `left = right`, with one `=`",
                                      &split_equation};

KeySyntax read_part(const TextPart& part, const DecodedText& text, FileReadState& reading) {
  KeySyntax result;
  result.key = part.key;
  result.key_span = result.value.span = text.span(part.begin, part.end);
  result.value.kind = part.kind;
  result.value.text = text.text.substr(part.begin, part.end - part.begin);
  if (part.kind == ValueKind::expression) {
    store_expression(read_expression(text, part.begin, part.end, reading.limits),
                     result.value.expression, reading);
  }
  return result;
}

/// The table of the parts of a text. Errors: E104 if `value` is no string; `kind.code` if the text
/// is of another form; the errors of the parts.
ValueSyntax read_split_text(const TomlValue& value, const SplitTextKind& kind,
                            FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::table);
  if (value.kind != TomlKind::string) {
    report_wrong_type(value, kind.expected, reading);
    return result;
  }
  const TextParts parts = kind.split(value.text);
  if (parts.empty()) {
    reading.report(kind.code, value.text.content_span,
                   fmt::format("{} is no {}", quote_text(value.text.text), kind.noun), kind.hint);
  }
  for (const TextPart& part : parts) {
    result.entries.push_back(read_part(part, value.text, reading));
  }
  return result;
}

/// The list of read_split_text() of each text in `value`, which is one text or a list of texts.
ValueSyntax read_split_texts(const TomlValue& value, const SplitTextKind& kind,
                             FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::list);
  if (value.kind != TomlKind::array) {
    result.items.push_back(read_split_text(value, kind, reading));
  }
  for (const TomlValue& item : value.items) {
    result.items.push_back(read_split_text(item, kind, reading));
  }
  return result;
}

ValueSyntax read_equations(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = read_split_texts(value, equation_text, reading);
  if (result.items.empty()) {
    report_wrong_type(value, "an equation, or a list of such", reading);
  }
  return result;
}

const KeyRow* find_row(std::string_view entry, std::string_view key) {
  const KeyRow* any = nullptr;
  for (const KeyRow& row : key_table()) {
    if (row.entry != entry) continue;
    if (row.key == key) return &row;
    if (row.key == "*") any = &row;
  }
  return any;
}

/// E103 with the nearest key. For a parameter of a scene, the hint is the line that fixes it.
void report_unknown_key(const TomlEntry& key, const TableContext& table, FileReadState& reading) {
  std::vector<std::string> candidates;
  for (const KeyRow& row : key_table()) {
    if (row.entry == table.entry && row.supported) candidates.emplace_back(row.key);
  }
  std::string hint = foreign_word_hint(table.entry, key.key);
  if (hint.empty()) hint = suggestion(key.key, candidates);
  const bool has_value = key.value.kind == TomlKind::number || key.value.kind == TomlKind::string;
  if (hint.empty() && has_value && table.entry == "scene.parameters")
    hint = fmt::format("write `fixed = {{ {} = {} }}`", key.key, covered_text(key.value.span));
  reading.report(Code::E103, key.key_span,
                 fmt::format("unknown key {} in {}", quote_text(key.key), table.label),
                 std::move(hint));
}

/// The hint for a missing key: the first line of every file, or the words of a choice; else "".
std::string missing_key_hint(const KeyRow& row) {
  if (row.key == "format") return "a file starts with `format = 1`";
  const std::vector<std::string_view> words = choice_words(row);
  return words.empty() ? "" : fmt::format("it is `\"{}\"`", fmt::join(words, "\"` or `\""));
}

void report_missing_keys(const std::vector<TomlEntry>& entries, const TableContext& table,
                         FileReadState& reading) {
  for (const KeyRow& row : key_table()) {
    if (row.entry != table.entry || !row.required) continue;
    if (find_entry(entries, row.key) != nullptr) continue;
    reading.report(Code::E105, table.header, fmt::format("no `{}` in {}", row.key, table.label),
                   missing_key_hint(row));
  }
}

void report_wrong_choice(const ValueSyntax& value, const std::string& observed, const KeyRow& row,
                         FileReadState& reading) {
  reading.report(
      Reason::unknown_word, value.span,
      fmt::format("{} where `{}` is expected", observed, fmt::join(choice_words(row), "` or `")),
      std::string(former_choice_hint(row, value.text)));
}

/// A word of the choice table; E104 for any other value.
ValueSyntax read_choice(const TomlValue& value, const KeyRow& row, FileReadState& reading) {
  ValueSyntax result = read_text(value, reading);
  if (value.kind != TomlKind::string) return result;
  const std::vector<std::string_view> words = choice_words(row);
  if (std::ranges::find(words, result.text) == words.end()) {
    report_wrong_choice(result, quote_text(result.text), row, reading);
  }
  return result;
}

ValueSyntax read_choices(const TomlValue& value, const KeyRow& row, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::list);
  if (value.kind == TomlKind::string) {
    result.items.push_back(read_choice(value, row, reading));
  } else if (value.kind != TomlKind::array) {
    report_wrong_type(value, "a list of strings", reading);
  } else if (value.items.empty()) {
    report_wrong_choice(result, "an empty list", row, reading);
  }
  for (const TomlValue& item : value.items) result.items.push_back(read_choice(item, row, reading));
  return result;
}

ValueSyntax read_table(const TomlEntry& key, const KeyRow& row, FileReadState& reading) {
  ValueSyntax result = make_value(key.value, ValueKind::table);
  if (key.value.kind != TomlKind::table) {
    report_wrong_type(key.value, "a table", reading);
    return result;
  }
  const TableContext table{fmt::format("{}.{}", row.entry, row.key), quote_text(key.key),
                           key.key_span};
  result.entries = read_keys(key.value.entries, table, reading);
  return result;
}

/// Reads the value of `key`, unless it is a table, as the table { short_key = value }.
ValueSyntax read_short_form(TomlEntry key, const KeyRow& row, std::string short_key,
                            FileReadState& reading) {
  if (key.value.kind == TomlKind::table) return read_table(key, row, reading);
  const TomlEntry entry{std::move(short_key), key.value.span, key.value};
  key.value = {.kind = TomlKind::table, .span = entry.key_span, .entries = {entry}};
  return read_table(key, row, reading);
}

ValueSyntax read_output_request(const TomlEntry& key, const KeyRow& row, FileReadState& reading) {
  if (key.value.kind == TomlKind::boolean) return read_boolean(key.value, reading);
  const OutputRow* const output = find_output(key.key);
  const bool is_step = output != nullptr && output->is_step;
  return read_short_form(key, row, is_step ? "method" : "form", reading);
}

ValueSyntax read_texts(const TomlValue& value, FileReadState& reading) {
  ValueSyntax result = make_value(value, ValueKind::list);
  for (const TomlValue& item : value.items) result.items.push_back(read_text(item, reading));
  return result;
}

ValueSyntax read_key_value(const TomlEntry& key, const KeyRow& row, FileReadState& reading) {
  const TomlValue& value = key.value;
  const bool is_table = value.kind == TomlKind::table;
  switch (row.type) {
    case KeyType::expression:
      return read_expression_value(value, reading);
    case KeyType::expression_list:
      return read_expression_list(value, 0, reading);
    case KeyType::expression_or_list:
      return value.kind == TomlKind::array ? read_expression_list(value, 0, reading)
                                           : read_expression_value(value, reading);
    case KeyType::expression_or_table:
      return is_table ? read_table(key, row, reading) : read_expression_value(value, reading);
    case KeyType::closed_form:
      return is_table ? read_table(key, row, reading) : read_matrix_or_expression(value, reading);
    case KeyType::name:
      return read_name(value, reading);
    case KeyType::text:
      return read_text(value, reading);
    case KeyType::latex_symbol:
      return read_latex_symbol(value, reading);
    case KeyType::choice:
      return read_choice(value, row, reading);
    case KeyType::choice_list:
      return read_choices(value, row, reading);
    case KeyType::unit:
      return read_text(value, reading);
    case KeyType::repetition:
      return read_split_texts(value, repetition_text, reading);
    case KeyType::condition:
      return read_split_text(value, condition_text, reading);
    case KeyType::equations:
      return read_equations(value, reading);
    case KeyType::integer:
      return read_integer(value, reading);
    case KeyType::boolean:
      return read_boolean(value, reading);
    case KeyType::range:
      return read_expression_list(value, 2, reading);
    case KeyType::turns:
      return read_turns(value, reading);
    case KeyType::table:
      return read_table(key, row, reading);
    case KeyType::value_or_table:
      return read_short_form(key, row, "value", reading);
    case KeyType::output_request:
      return read_output_request(key, row, reading);
    case KeyType::boolean_or_expression:
      return value.kind == TomlKind::boolean ? read_boolean(value, reading)
                                             : read_expression_value(value, reading);
    case KeyType::text_or_table:
      return is_table ? read_table(key, row, reading) : read_text(value, reading);
    case KeyType::names_or_table:
      if (value.kind == TomlKind::array) return read_texts(value, reading);
      return is_table ? read_table(key, row, reading) : read_text(value, reading);
  }
  return {};
}

}  // namespace

std::vector<KeySyntax> read_keys(const std::vector<TomlEntry>& entries, const TableContext& table,
                                 FileReadState& reading) {
  std::vector<KeySyntax> result;
  bool all_supported = true;
  for (const TomlEntry& entry : entries) {
    const KeyRow* row = find_row(table.entry, entry.key);
    if (row == nullptr) {
      report_unknown_key(entry, table, reading);
    } else if (!row->supported) {
      all_supported = false;
      reading.report(Code::E108, entry.key_span, quote_text(entry.key) + " is not yet supported");
    } else {
      result.push_back({entry.key, entry.key_span, read_key_value(entry, *row, reading)});
    }
  }
  // An unsupported key may be meant in place of a required key, so missing keys are reported only
  // if all keys are supported.
  if (all_supported) report_missing_keys(entries, table, reading);
  return result;
}

}  // namespace elgen
