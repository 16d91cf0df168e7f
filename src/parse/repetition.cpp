// Repetitions:
//
//     "i in 1..n"   to   { index = i, low = 1, high = n }
#include "parse/repetition.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "elgen/wording.hpp"
#include "parse/expression_parser.hpp"
#include "parse/lexer.hpp"

namespace elgen {

namespace {

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

}  // namespace

ValueSyntax read_repetition(const TomlValue& value, FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::list);
  if (value.kind != TomlKind::array) {
    result.items.push_back(read_one(value, reading));
    return result;
  }
  for (const TomlValue& item : value.items) result.items.push_back(read_one(item, reading));
  return result;
}

}  // namespace elgen
