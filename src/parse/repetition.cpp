// Repetitions:
//
//     "i in 1..n"   to   { index = i, low = 1, high = n }
#include "parse/repetition.hpp"

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

struct RepetitionParts {
  TextRange index;
  TextRange low;
  TextRange high;
};

std::optional<RepetitionParts> split(const DecodedText& text) {
  const std::size_t dots = text.text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  Lexer lexer(text, 0, dots);
  const Token index = lexer.next();
  const Token in = lexer.next();
  if (index.kind != TokenKind::name || lexer.text(in) != "in") return std::nullopt;
  return RepetitionParts{{index.begin, index.end}, {in.end, dots}, {dots + 2, text.text.size()}};
}

KeySyntax part_entry(std::string key, const TextRange& part, const DecodedText& text,
                     FileReading& reading) {
  KeySyntax result;
  result.key = std::move(key);
  result.key_span = result.value.span = text.span(part.begin, part.end);
  result.value.kind = ValueKind::expression;
  result.value.text = text.text.substr(part.begin, part.end - part.begin);
  Result<ExpressionSyntax> read = read_expression(text, part.begin, part.end, reading.limits);
  if (read) result.value.expression = std::move(*read);
  for (Diagnostic& problem : read.diagnostics) {
    reading.diagnostics.push_back(std::move(problem));
  }
  return result;
}

ValueSyntax read_one(const TomlValue& value, FileReading& reading) {
  ValueSyntax result = empty_value(value, ValueKind::table);
  if (value.kind != TomlKind::string) {
    report_wrong_type(value, "a repetition (a string)", reading);
    return result;
  }
  const std::optional<RepetitionParts> parts = split(value.text);
  if (!parts) {
    reading.report(Code::E210, value.text.whole, quoted(value.text.text) + " is no repetition",
                   std::string(grammar));
    return result;
  }
  result.entries.push_back(part_entry("index", parts->index, value.text, reading));
  result.entries.push_back(part_entry("low", parts->low, value.text, reading));
  result.entries.push_back(part_entry("high", parts->high, value.text, reading));
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
