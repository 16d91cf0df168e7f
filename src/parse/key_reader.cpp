// Keys of one table: unknown, missing and unsupported ones, and the value of each as its row says.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "elgen/wording.hpp"
#include "parse/entry_reader.hpp"
#include "parse/expression_parser.hpp"
#include "parse/lexer.hpp"
#include "parse/value_reader.hpp"

namespace elgen {

namespace {

// Repetitions: "i in 1..n" to { index = i, low = 1, high = n }

constexpr std::string_view grammar = "a repetition is written `i in 1..n`";

/// Bytes of the decoded text.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The index and the two bounds.
using Parts = std::array<TextRange, 3>;
constexpr std::array<const char*, 3> part_names{"index", "low", "high"};

std::optional<Parts> split(const DecodedText& text) {
  const std::size_t dots = text.text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  Lexer lexer(text, 0, dots);
  const Token index = lexer.advance();
  const Token in = lexer.advance();
  if (index.kind != TokenKind::name || lexer.text(in) != "in") return std::nullopt;
  return Parts{{{index.begin, index.end}, {in.end, dots}, {dots + 2, text.text.size()}}};
}

KeySyntax part_entry(std::string key, const TextRange& part, const DecodedText& text,
                     FileReading& reading) {
  KeySyntax result;
  result.key = std::move(key);
  result.key_span = result.value.span = text.span(part.begin, part.end);
  result.value.kind = ValueKind::expression;
  result.value.text = text.text.substr(part.begin, part.end - part.begin);
  keep(read_expression(text, part.begin, part.end, reading.limits), result.value.expression,
       reading);
  return result;
}

ValueSyntax read_one(const TomlValue& value, FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::table);
  if (value.kind != TomlKind::string) {
    report_wrong_type(value, "a repetition (a string)", reading);
    return result;
  }
  const std::optional<Parts> parts = split(value.text);
  if (!parts) {
    reading.report(Code::E210, value.text.whole,
                   in_backticks(value.text.text) + " is no repetition", std::string(grammar));
    return result;
  }
  for (std::size_t i = 0; i < parts->size(); ++i) {
    result.entries.push_back(part_entry(part_names[i], (*parts)[i], value.text, reading));
  }
  return result;
}

/// One string, or a list of such: always a list.
template <class ReadOne>
ValueSyntax read_one_or_list(const TomlValue& value, const ReadOne& read_one,
                             FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::list);
  if (value.kind != TomlKind::array) {
    result.items.push_back(read_one(value, reading));
    return result;
  }
  for (const TomlValue& item : value.items) result.items.push_back(read_one(item, reading));
  return result;
}

/// A list of tables {index, low, high}. E104; E210 malformed repetition; errors of the bounds.
ValueSyntax read_repetition(const TomlValue& value, FileReading& reading) {
  return read_one_or_list(value, read_one, reading);
}

// Conditions: "a > b" to { left = a, sign = ">", right = b }

/// E104; E320 no comparison; errors of the sides, of which a second comparison is one.
ValueSyntax read_condition(const TomlValue& value, FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::table);
  if (value.kind != TomlKind::string) {
    report_wrong_type(value, "a condition (a string)", reading);
    return result;
  }
  const std::string& text = value.text.text;
  const std::size_t begin = text.find_first_of("<>");
  if (begin == std::string::npos) {
    reading.report(Code::E320, value.text.whole, in_backticks(text) + " is no condition",
                   "a condition is written `a > b`, with one of `>`, `>=`, `<` and `<=`");
    return result;
  }
  const bool has_equality = begin + 1 < text.size() && text[begin + 1] == '=';
  const std::size_t end = has_equality ? begin + 2 : begin + 1;
  KeySyntax sign;
  sign.key = "sign";
  sign.key_span = sign.value.span = value.text.span(begin, end);
  sign.value.text = text.substr(begin, end - begin);
  result.entries.push_back(part_entry("left", {0, begin}, value.text, reading));
  result.entries.push_back(std::move(sign));
  result.entries.push_back(part_entry("right", {end, text.size()}, value.text, reading));
  return result;
}

// Equations: "a = b" to { left = a, right = b }

ValueSyntax read_equation(const TomlValue& value, FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::table);
  if (value.kind != TomlKind::string) {
    report_wrong_type(value, "an equation (a string)", reading);
    return result;
  }
  const std::string& text = value.text.text;
  const std::size_t sign = text.find('=');
  const bool has_one = sign != std::string::npos && text.find('=', sign + 1) == std::string::npos;
  if (!has_one) {
    reading.report(Code::E321, value.text.whole, in_backticks(text) + " is no equation",
                   "an equation is written `left = right`, with one `=`");
    return result;
  }
  result.entries.push_back(part_entry("left", {0, sign}, value.text, reading));
  result.entries.push_back(part_entry("right", {sign + 1, text.size()}, value.text, reading));
  return result;
}

/// A list of tables {left, right}. E104; E321 no equation; errors of the sides.
ValueSyntax read_equations(const TomlValue& value, FileReading& reading) {
  ValueSyntax result = read_one_or_list(value, read_equation, reading);
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

void report_unknown(const TomlEntry& key, const TableContext& table, FileReading& reading) {
  std::vector<std::string> candidates;
  for (const KeyRow& row : key_table()) {
    if (row.entry == table.entry && row.supported) candidates.emplace_back(row.key);
  }
  reading.report(Code::E103, key.key_span,
                 fmt::format("unknown key {} in {}", in_backticks(key.key), table.label),
                 suggestion(key.key, candidates));
}

void report_missing(const std::vector<TomlEntry>& entries, const TableContext& table,
                    FileReading& reading) {
  for (const KeyRow& row : key_table()) {
    if (row.entry != table.entry || !row.required) continue;
    if (find_entry(entries, row.key) != nullptr) continue;
    reading.report(Code::E105, table.header, fmt::format("no `{}` in {}", row.key, table.label),
                   row.key == "format" ? "a file starts with `format = 1`" : "");
  }
}

std::vector<std::string_view> words_of(const KeyRow& row) {
  std::vector<std::string_view> words;
  for (const ChoiceRow& choice : choice_table()) {
    if (choice.entry == row.entry && choice.key == row.key) words.push_back(choice.word);
  }
  return words;
}

void report_choice(const ValueSyntax& value, const std::string& observed, const KeyRow& row,
                   FileReading& reading) {
  reading.report(
      Code::E104, value.span,
      fmt::format("{} where `{}` is expected", observed, fmt::join(words_of(row), "` or `")));
}

/// One of the words of the choice table: E104.
ValueSyntax read_choice(const TomlValue& value, const KeyRow& row, FileReading& reading) {
  ValueSyntax result = read_text(value, reading);
  if (value.kind != TomlKind::string) return result;
  const std::vector<std::string_view> words = words_of(row);
  if (std::find(words.begin(), words.end(), result.text) == words.end()) {
    report_choice(result, in_backticks(result.text), row, reading);
  }
  return result;
}

ValueSyntax read_choices(const TomlValue& value, const KeyRow& row, FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::list);
  if (value.kind != TomlKind::array) {
    report_wrong_type(value, "a list of strings", reading);
  } else if (value.items.empty()) {
    report_choice(result, "an empty list", row, reading);
  }
  for (const TomlValue& item : value.items) result.items.push_back(read_choice(item, row, reading));
  return result;
}

ValueSyntax read_table(const TomlEntry& key, const KeyRow& row, FileReading& reading) {
  ValueSyntax result = empty_value(key.value, ValueKind::table);
  if (key.value.kind != TomlKind::table) {
    report_wrong_type(key.value, "a table", reading);
    return result;
  }
  const TableContext table{fmt::format("{}.{}", row.entry, row.key), in_backticks(key.key),
                           key.key_span};
  result.entries = read_keys(key.value.entries, table, reading);
  return result;
}

ValueSyntax read_by_type(const TomlEntry& key, const KeyRow& row, FileReading& reading) {
  const TomlValue& value = key.value;
  const bool is_table = value.kind == TomlKind::table;
  switch (row.type) {
    case KeyType::expression:
      return read_expression_value(value, reading);
    case KeyType::expression_list:
      return read_list(value, 0, reading);
    case KeyType::expression_or_list:
      return value.kind == TomlKind::array ? read_list(value, 0, reading)
                                           : read_expression_value(value, reading);
    case KeyType::expression_or_table:
      return is_table ? read_table(key, row, reading) : read_expression_value(value, reading);
    case KeyType::closed_form:
      return is_table ? read_table(key, row, reading) : read_array_or_expression(value, reading);
    case KeyType::name:
      return read_name(value, reading);
    case KeyType::text:
      return read_text(value, reading);
    case KeyType::symbol:
      return read_symbol(value, reading);
    case KeyType::choice:
      return read_choice(value, row, reading);
    case KeyType::choice_list:
      return read_choices(value, row, reading);
    case KeyType::unit:
      return read_text(value, reading);
    case KeyType::repetition:
      return read_repetition(value, reading);
    case KeyType::condition:
      return read_condition(value, reading);
    case KeyType::equations:
      return read_equations(value, reading);
    case KeyType::integer:
      return read_integer(value, reading);
    case KeyType::boolean:
      return read_boolean(value, reading);
    case KeyType::range:
      return read_list(value, 2, reading);
    case KeyType::turns:
      return read_turns(value, reading);
    case KeyType::table:
      return read_table(key, row, reading);
    case KeyType::boolean_or_table:
      return is_table ? read_table(key, row, reading) : read_boolean(value, reading);
    case KeyType::boolean_or_expression:
      return value.kind == TomlKind::boolean ? read_boolean(value, reading)
                                             : read_expression_value(value, reading);
    case KeyType::text_or_table:
      return is_table ? read_table(key, row, reading) : read_text(value, reading);
  }
  return {};
}

}  // namespace

std::vector<KeySyntax> read_keys(const std::vector<TomlEntry>& entries, const TableContext& table,
                                 FileReading& reading) {
  std::vector<KeySyntax> result;
  bool all_supported = true;
  for (const TomlEntry& entry : entries) {
    const KeyRow* row = find_row(table.entry, entry.key);
    if (row == nullptr) {
      report_unknown(entry, table, reading);
    } else if (!row->supported) {
      all_supported = false;
      reading.report(Code::E108, entry.key_span, in_backticks(entry.key) + " is not yet supported");
    } else {
      result.push_back({entry.key, entry.key_span, read_by_type(entry, *row, reading)});
    }
  }
  // A key that the unsupported one would have replaced is not reported as missing.
  if (all_supported) report_missing(entries, table, reading);
  return result;
}

}  // namespace elgen
