// The expression parser, by recursive descent over
//
//     sum     = product { ("+" | "-") product }
//     product = unary { ("*" | "/") unary }
//     unary   = "-" unary | power
//     power   = primary [ "^" unary ]                  so -x^2 = -(x^2), x^-1, 2^3^2 = 2^(3^2)
//     primary = number | name [ "[" sum "]" ] | name "(" [ sum { "," sum } ] ")" | "(" sum ")"
//
// Depth is counted on the way down, before the stack grows. A sum or product of any length is one
// node.
#include "parse/expression_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "base/ascii.hpp"
#include "elgen/functions.hpp"
#include "elgen/units.hpp"
#include "elgen/wording.hpp"
#include "parse/decimal.hpp"
#include "parse/syntax_errors.hpp"

namespace elgen {

namespace {

Span join(const Span& first, const Span& last) { return {first.source, first.begin, last.end}; }

/// The hint on `9.81 m/s^2`: `tokens` is at the `m`, behind `before`. "" unless `before` is a
/// number and only a unit follows.
std::string quantity_hint(Lexer tokens, const ExpressionSyntax& before) {
  const bool is_negated = before.kind == SyntaxKind::negate;
  const ExpressionSyntax& number = is_negated ? before.operands.front() : before;
  const bool is_angle = tokens.text(tokens.current()) == "deg";
  if (number.kind != SyntaxKind::number || !tokens.is_at(TokenKind::name) || is_angle) return {};
  std::string value(covered_text(before.span));
  std::string unit;
  bool has_multiple = false;
  while (!tokens.is_at(TokenKind::end) && !tokens.is_at(TokenKind::invalid)) {
    const Token token = tokens.advance();
    const std::string_view text = tokens.text(token);
    const bool is_multiple = find_unit_multiple(text) != nullptr;
    const bool is_sign = std::string_view("*/^()").find(text) != std::string_view::npos ||
                         (text == "-" && unit.ends_with('^'));
    const bool is_exponent = token.kind == TokenKind::number && !unit.ends_with('*');
    if (!find_unit(text) && !is_multiple && !is_sign && !is_exponent) return {};
    const bool is_name = token.kind == TokenKind::name;
    if (is_name && !unit.empty() && is_word_character(unit.back())) unit += '*';
    unit += text;
    has_multiple = has_multiple || is_multiple;
  }
  if (const UnitMultipleRow* const row = find_unit_multiple(unit)) {
    value = fmt::format("\"{}*{}\"", row->factor, value);
    unit = row->unit;
  } else if (has_multiple || tokens.is_at(TokenKind::invalid)) {
    unit = "…";
  }
  return fmt::format("a unit belongs to a parameter: `{{ value = {}, unit = \"{}\" }}`", value,
                     unit);
}

/// A subtree, and its depth as counted against the limit.
struct Subtree {
  ExpressionSyntax tree;
  std::uint64_t levels = 0;
};

/// A parsed subtree; none after an error, which `problem_` then holds.
using MaybeSubtree = std::optional<Subtree>;

class ExpressionParser {
 public:
  ExpressionParser(const DecodedText& text, std::size_t begin, std::size_t end,
                   const Limits& limits)
      : tokens_(text, begin, end),
        limits_(limits),
        whole_span_(text.span(begin, end)),
        max_depth_(std::min(limits.expression_depth, max_expression_depth)) {}

  Result<ExpressionSyntax> parse();

 private:
  MaybeSubtree parse_sum();
  MaybeSubtree parse_product();
  MaybeSubtree make_quotient(const Token& token, Subtree numerator, Subtree denominator);
  MaybeSubtree parse_unary();
  MaybeSubtree parse_power();
  MaybeSubtree parse_primary();
  MaybeSubtree parse_number();
  MaybeSubtree parse_name();
  MaybeSubtree parse_index(Subtree named);
  MaybeSubtree parse_call(Subtree named);
  MaybeSubtree parse_brackets();
  bool parse_arguments(Subtree& call);
  bool lacks_brackets(const ExpressionSyntax& base, std::string_view power);

  [[nodiscard]] bool is_at(TokenKind kind) const { return tokens_.is_at(kind); }
  /// The text from a byte to the end of the previous token.
  [[nodiscard]] std::string_view text_from(std::size_t begin) const {
    return tokens_.text({TokenKind::name, begin, tokens_.previous().end});
  }

  Subtree make_node(SyntaxKind kind, const Token& token, std::deque<Subtree> operands) const;
  Subtree negate_node(const Token& minus, Subtree operand) const;

  // The functions that return bool return true if parsing can continue.
  bool enter_level(const Token& token);
  void leave_level() { --depth_; }
  bool expect_bracket(TokenKind kind, const Token& opened);
  bool fail_too_deep(const Token& token);
  bool fail(Diagnostic problem);

  Lexer tokens_;
  const Limits& limits_;
  Span whole_span_;
  std::uint64_t max_depth_;
  std::uint64_t depth_ = 0;
  std::optional<Diagnostic> problem_ = {};
};

Result<ExpressionSyntax> ExpressionParser::parse() {
  if (is_at(TokenKind::end)) {
    return Diagnostic{Code::E310, whole_span_, "empty expression", "write `0` for nothing"};
  }
  MaybeSubtree result = parse_sum();
  if (result && !is_at(TokenKind::end)) {
    Diagnostic error = misplaced_token_error(tokens_);
    const std::string hint = quantity_hint(tokens_, result->tree);
    if (!hint.empty()) error.hint = hint;
    fail(std::move(error));
  }
  if (problem_) return *problem_;
  return std::move(result->tree);
}

/// Reports E303 at the operand in `sin x` or `sin^2(x)`. `power`: the text of the exponent. False
/// if `base` is no function, or if no operand follows.
bool ExpressionParser::lacks_brackets(const ExpressionSyntax& base, std::string_view power) {
  const bool has_operand =
      is_at(TokenKind::name) || is_at(TokenKind::number) || is_at(TokenKind::left_parenthesis);
  if (!has_operand || base.kind != SyntaxKind::name || !base.operands.empty()) return false;
  if (!is_reserved_function(base.text) && translate_call(base.text, {"x"}).empty()) return false;
  Diagnostic error = misplaced_token_error(tokens_);
  const std::size_t begin = tokens_.current().begin;
  // In `sin 2*x` the whole product is the argument.
  const MaybeSubtree operand = is_at(TokenKind::number) ? parse_product() : parse_primary();
  std::string argument(operand && !is_at(TokenKind::name) ? text_from(begin) : "…");
  if (argument.starts_with('(')) argument = argument.substr(1, argument.size() - 2);
  std::string call = translate_call(base.text, {argument});
  if (call.empty()) call = fmt::format("{}({})", base.text, argument);
  error.hint = "write " + quote_text(call + (power.empty() ? "" : "^") + std::string(power));
  if (power == "-1" && find_function("a" + base.text) != nullptr)
    error.hint += fmt::format(", or `a{}` for the inverse function", call);
  fail(std::move(error));
  return true;
}

MaybeSubtree ExpressionParser::parse_sum() {
  MaybeSubtree first = parse_product();
  if (!first || !(is_at(TokenKind::plus) || is_at(TokenKind::minus))) return first;
  const Token token = tokens_.current();
  std::deque<Subtree> terms;
  terms.push_back(*std::move(first));
  while (is_at(TokenKind::plus) || is_at(TokenKind::minus)) {
    const Token sign = tokens_.advance();
    MaybeSubtree term = parse_product();
    if (!term) return std::nullopt;
    terms.push_back(sign.kind == TokenKind::minus ? negate_node(sign, *std::move(term))
                                                  : *std::move(term));
  }
  return make_node(SyntaxKind::add, token, std::move(terms));
}

MaybeSubtree ExpressionParser::parse_product() {
  MaybeSubtree first = parse_unary();
  if (!first || !(is_at(TokenKind::times) || is_at(TokenKind::divide))) return first;
  std::deque<Subtree> factors;
  factors.push_back(*std::move(first));
  Token star = tokens_.current();
  while (is_at(TokenKind::times) || is_at(TokenKind::divide)) {
    const Token token = tokens_.advance();
    MaybeSubtree factor = parse_unary();
    if (!factor) return std::nullopt;
    if (token.kind == TokenKind::times) {
      if (factors.size() == 1) star = token;
      factors.push_back(*std::move(factor));
      continue;
    }
    MaybeSubtree divided = make_quotient(
        token, make_node(SyntaxKind::multiply, star, std::move(factors)), *std::move(factor));
    if (!divided) return std::nullopt;
    factors.clear();
    factors.push_back(*std::move(divided));
  }
  return make_node(SyntaxKind::multiply, star, std::move(factors));
}

/// The node numerator / denominator; none if the node is too deep. a/b/c nests to the left, and
/// enter_level() does not count these levels.
MaybeSubtree ExpressionParser::make_quotient(const Token& token, Subtree numerator,
                                             Subtree denominator) {
  std::deque<Subtree> operands;
  operands.push_back(std::move(numerator));
  operands.push_back(std::move(denominator));
  Subtree result = make_node(SyntaxKind::divide, token, std::move(operands));
  ++result.levels;
  if (depth_ + result.levels > max_depth_) {
    fail_too_deep(token);
    return std::nullopt;
  }
  return result;
}

MaybeSubtree ExpressionParser::parse_unary() {
  if (!is_at(TokenKind::minus)) return parse_power();
  if (!enter_level(tokens_.current())) return std::nullopt;
  const Token minus = tokens_.advance();
  MaybeSubtree operand = parse_unary();
  leave_level();
  if (!operand) return std::nullopt;
  Subtree result = negate_node(minus, *std::move(operand));
  ++result.levels;
  return result;
}

MaybeSubtree ExpressionParser::parse_power() {
  MaybeSubtree base = parse_primary();
  if (base && lacks_brackets(base->tree, "")) return std::nullopt;
  if (!base || !is_at(TokenKind::power)) return base;
  if (!enter_level(tokens_.current())) return std::nullopt;
  const Token token = tokens_.advance();
  const std::size_t begin = tokens_.current().begin;
  MaybeSubtree exponent = parse_unary();
  leave_level();
  if (!exponent || lacks_brackets(base->tree, text_from(begin))) return std::nullopt;
  std::deque<Subtree> operands;
  operands.push_back(*std::move(base));
  operands.push_back(*std::move(exponent));
  Subtree result = make_node(SyntaxKind::power, token, std::move(operands));
  ++result.levels;
  return result;
}

MaybeSubtree ExpressionParser::parse_primary() {
  switch (tokens_.current().kind) {
    case TokenKind::number:
      return parse_number();
    case TokenKind::name:
      return parse_name();
    case TokenKind::left_parenthesis:
      return parse_brackets();
    default:
      fail(missing_operand_error(tokens_));
      return std::nullopt;
  }
}

MaybeSubtree ExpressionParser::parse_number() {
  const Token token = tokens_.advance();
  const DecimalParts parts = decimal_parts(tokens_.text(token));
  if (std::optional<ExceededLimit> hit = find_exceeded_limit(parts, limits_)) {
    fail({hit->code, tokens_.span(token), std::move(hit->message), std::move(hit->hint)});
    return std::nullopt;
  }
  Subtree result = make_node(SyntaxKind::number, token, {});
  result.tree.value = decimal_value(parts);
  return result;
}

MaybeSubtree ExpressionParser::parse_name() {
  const Token token = tokens_.advance();
  Subtree result = make_node(SyntaxKind::name, token, {});
  result.tree.text = tokens_.text(token);
  if (is_at(TokenKind::left_parenthesis)) return parse_call(std::move(result));
  if (is_at(TokenKind::left_bracket)) return parse_index(std::move(result));
  return result;
}

MaybeSubtree ExpressionParser::parse_index(Subtree named) {
  const Token opened = tokens_.current();
  if (!enter_level(opened)) return std::nullopt;
  tokens_.advance();
  MaybeSubtree index = parse_sum();
  if (!index || !expect_bracket(TokenKind::right_bracket, opened)) return std::nullopt;
  leave_level();
  named.levels = index->levels + 1;
  named.tree.operands.push_back(std::move(index->tree));
  named.tree.span = join(named.tree.span, tokens_.span(tokens_.previous()));
  return named;
}

MaybeSubtree ExpressionParser::parse_call(Subtree named) {
  const Token opened = tokens_.current();
  if (!enter_level(opened)) return std::nullopt;
  tokens_.advance();
  named.tree.kind = SyntaxKind::call;
  if (!is_at(TokenKind::right_parenthesis) && !parse_arguments(named)) return std::nullopt;
  if (!expect_bracket(TokenKind::right_parenthesis, opened)) return std::nullopt;
  leave_level();
  ++named.levels;
  named.tree.span = join(named.tree.span, tokens_.span(tokens_.previous()));
  return named;
}

bool ExpressionParser::parse_arguments(Subtree& call) {
  std::deque<Subtree> operands;
  do {
    if (!operands.empty()) tokens_.advance();
    MaybeSubtree argument = parse_sum();
    if (!argument) return false;
    operands.push_back(*std::move(argument));
  } while (is_at(TokenKind::comma));
  call.tree.operands.reserve(operands.size());
  for (Subtree& operand : operands) {
    call.levels = std::max(call.levels, operand.levels);
    call.tree.operands.push_back(std::move(operand.tree));
  }
  return true;
}

MaybeSubtree ExpressionParser::parse_brackets() {
  const Token opened = tokens_.current();
  if (!enter_level(opened)) return std::nullopt;
  tokens_.advance();
  MaybeSubtree inner = parse_sum();
  if (!inner || !expect_bracket(TokenKind::right_parenthesis, opened)) return std::nullopt;
  leave_level();
  ++inner->levels;
  inner->tree.span = join(tokens_.span(opened), tokens_.span(tokens_.previous()));
  return inner;
}

/// The node of `kind`; a sum or product of one operand is the operand itself. The operands are in a
/// deque, because a growing vector would copy subtrees.
Subtree ExpressionParser::make_node(SyntaxKind kind, const Token& token,
                                    std::deque<Subtree> operands) const {
  const bool chain = kind == SyntaxKind::add || kind == SyntaxKind::multiply;
  if (chain && operands.size() == 1) return std::move(operands.front());
  Subtree result;
  result.tree.kind = kind;
  result.tree.token = tokens_.span(token);
  result.tree.span = result.tree.token;
  if (operands.empty()) return result;
  result.tree.span = join(operands.front().tree.span, operands.back().tree.span);
  result.tree.operands.reserve(operands.size());
  for (Subtree& operand : operands) {
    result.levels = std::max(result.levels, operand.levels);
    result.tree.operands.push_back(std::move(operand.tree));
  }
  return result;
}

Subtree ExpressionParser::negate_node(const Token& minus, Subtree operand) const {
  const Span whole = join(tokens_.span(minus), operand.tree.span);
  std::deque<Subtree> operands;
  operands.push_back(std::move(operand));
  Subtree result = make_node(SyntaxKind::negate, minus, std::move(operands));
  result.tree.span = whole;
  return result;
}

bool ExpressionParser::enter_level(const Token& token) {
  ++depth_;
  return depth_ <= max_depth_ || fail_too_deep(token);
}

bool ExpressionParser::fail_too_deep(const Token& token) {
  const bool own_limit = limits_.expression_depth > max_expression_depth;
  return fail({Code::E902, tokens_.span(token),
               fmt::format("expression is nested deeper than {}", max_depth_),
               own_limit ? "name parts of it in `[define]`"
                         : "`--limit expression_depth=N` raises the limit"});
}

bool ExpressionParser::expect_bracket(TokenKind kind, const Token& opened) {
  if (!is_at(kind)) return fail(unclosed_bracket_error(tokens_, opened));
  tokens_.advance();
  return true;
}

bool ExpressionParser::fail(Diagnostic problem) {
  problem_ = std::move(problem);
  return false;
}

}  // namespace

Result<ExpressionSyntax> read_expression(const DecodedText& text, std::size_t begin,
                                         std::size_t end, const Limits& limits) {
  return ExpressionParser(text, begin, end, limits).parse();
}

Result<ExpressionSyntax> read_expression(const DecodedText& text, const Limits& limits) {
  return read_expression(text, 0, text.text.size(), limits);
}

}  // namespace elgen
