// Syntax as readable text, for stamps and tests: entries in file order, expressions fully
// parenthesised, so that they parse back to the same tree.
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "elgen/syntax.hpp"
#include "parse/decimal.hpp"

namespace elgen {

namespace {

std::string_view operand_separator(SyntaxKind kind) {
  switch (kind) {
    case SyntaxKind::add:
      return " + ";
    case SyntaxKind::multiply:
      return " * ";
    case SyntaxKind::divide:
      return " / ";
    case SyntaxKind::power:
      return "^";
    default:
      return ", ";
  }
}

void print_operands(const ExpressionSyntax& expression, std::string& text) {
  std::string_view separator;
  for (const ExpressionSyntax& operand : expression.operands) {
    text += separator;
    text += dump(operand);
    separator = operand_separator(expression.kind);
  }
}

std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? "\\n" : std::string(1, c);
  }
  return result + '"';
}

std::string dump_keys(const std::vector<KeySyntax>& keys);

std::string dump_items(const std::vector<ValueSyntax>& items);

std::string dump_value(const ValueSyntax& value) {
  switch (value.kind) {
    case ValueKind::expression:
      return dump(value.expression);
    case ValueKind::text:
      return quoted_text(value.text);
    case ValueKind::boolean:
      return value.boolean ? "true" : "false";
    case ValueKind::list:
      return dump_items(value.items);
    case ValueKind::table:
      return dump_keys(value.entries);
  }
  return {};
}

std::string dump_items(const std::vector<ValueSyntax>& items) {
  std::vector<std::string> texts;
  for (const ValueSyntax& item : items) texts.push_back(dump_value(item));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string dump_keys(const std::vector<KeySyntax>& keys) {
  std::vector<std::string> texts;
  for (const KeySyntax& key : keys) {
    texts.push_back(fmt::format("{} = {}", key.key, dump_value(key.value)));
  }
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

}  // namespace

std::string dump(const ExpressionSyntax& expression) {
  std::string inside;
  print_operands(expression, inside);
  switch (expression.kind) {
    case SyntaxKind::number:
      return decimal_text(expression.value);
    case SyntaxKind::name:
      return expression.operands.empty() ? expression.text : expression.text + "[" + inside + "]";
    case SyntaxKind::call:
      return expression.text + "(" + inside + ")";
    case SyntaxKind::negate:
      return "(-" + inside + ")";
    default:
      return "(" + inside + ")";
  }
}

std::string dump(const FileSyntax& syntax) {
  std::string result;
  for (const EntrySyntax& entry : syntax.entries) {
    result += fmt::format("[{}]\n", entry.name);
    for (const KeySyntax& key : entry.keys) {
      result += fmt::format("  {} = {}\n", key.key, dump_value(key.value));
    }
  }
  return result;
}

std::string canonical_model_text(const FileSyntax& model) {
  FileSyntax kept = model;
  for (EntrySyntax& entry : kept.entries) {
    std::erase_if(entry.keys,
                  [&](const KeySyntax& key) { return is_drawing_key(entry.name, key.key); });
  }
  return dump(kept);
}

}  // namespace elgen
