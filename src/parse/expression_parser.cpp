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

#include "parse/decimal.hpp"
#include "parse/syntax_errors.hpp"

namespace elgen {

namespace {

Span join(const Span& first, const Span& last) { return {first.source, first.begin, last.end}; }

/// A subtree, and its depth as counted against the limit.
struct Subtree {
  ExpressionSyntax tree;
  std::uint64_t levels = 0;
};

/// A parsed subtree; none after an error, which `problem_` then holds.
using Step = std::optional<Subtree>;

class ExpressionParser {
 public:
  ExpressionParser(const DecodedText& text, std::size_t begin, std::size_t end,
                   const Limits& limits)
      : tokens_(text, begin, end),
        limits_(limits),
        whole_(text.span(begin, end)),
        deepest_(std::min(limits.expression_depth, deepest_expression)) {}

  Result<ExpressionSyntax> parse();

 private:
  Step sum();
  Step product();
  Step quotient(const Token& token, Subtree numerator, Subtree denominator);
  Step unary();
  Step power();
  Step primary();
  Step number();
  Step name();
  Step parse_index(Subtree named);
  Step call(Subtree named);
  Step parse_brackets();
  bool arguments(Subtree& call);

  [[nodiscard]] bool at(TokenKind kind) const { return tokens_.at(kind); }

  Subtree node(SyntaxKind kind, const Token& token, std::deque<Subtree> operands) const;
  Subtree negate_node(const Token& minus, Subtree operand) const;

  // The functions that return bool return true if parsing can continue.
  bool enter(const Token& token);
  void leave() { --depth_; }
  bool close(TokenKind kind, const Token& opened);
  bool too_deep(const Token& token);
  bool fail(Diagnostic problem);

  Lexer tokens_;
  const Limits& limits_;
  Span whole_;
  std::uint64_t deepest_;
  std::uint64_t depth_ = 0;
  std::optional<Diagnostic> problem_ = {};
};

Result<ExpressionSyntax> ExpressionParser::parse() {
  if (at(TokenKind::end)) {
    return Diagnostic{Code::E310, whole_, "empty expression", "write `0` for nothing"};
  }
  Step result = sum();
  if (result && !at(TokenKind::end)) fail(misplaced_token(tokens_));
  if (problem_) return *problem_;
  return std::move(result->tree);
}

Step ExpressionParser::sum() {
  Step first = product();
  if (!first || !(at(TokenKind::plus) || at(TokenKind::minus))) return first;
  const Token token = tokens_.current();
  std::deque<Subtree> terms;
  terms.push_back(*std::move(first));
  while (at(TokenKind::plus) || at(TokenKind::minus)) {
    const Token sign = tokens_.advance();
    Step term = product();
    if (!term) return std::nullopt;
    terms.push_back(sign.kind == TokenKind::minus ? negate_node(sign, *std::move(term))
                                                  : *std::move(term));
  }
  return node(SyntaxKind::add, token, std::move(terms));
}

Step ExpressionParser::product() {
  Step first = unary();
  if (!first || !(at(TokenKind::times) || at(TokenKind::divide))) return first;
  std::deque<Subtree> factors;
  factors.push_back(*std::move(first));
  Token star = tokens_.current();
  while (at(TokenKind::times) || at(TokenKind::divide)) {
    const Token token = tokens_.advance();
    Step factor = unary();
    if (!factor) return std::nullopt;
    if (token.kind == TokenKind::times) {
      if (factors.size() == 1) star = token;
      factors.push_back(*std::move(factor));
      continue;
    }
    Step divided =
        quotient(token, node(SyntaxKind::multiply, star, std::move(factors)), *std::move(factor));
    if (!divided) return std::nullopt;
    factors.clear();
    factors.push_back(*std::move(divided));
  }
  return node(SyntaxKind::multiply, star, std::move(factors));
}

/// The node numerator / denominator; none if it is too deep: a/b/c nests to the left, and the
/// recursive descent does not count these levels.
Step ExpressionParser::quotient(const Token& token, Subtree numerator, Subtree denominator) {
  std::deque<Subtree> operands;
  operands.push_back(std::move(numerator));
  operands.push_back(std::move(denominator));
  Subtree result = node(SyntaxKind::divide, token, std::move(operands));
  ++result.levels;
  if (depth_ + result.levels > deepest_) {
    too_deep(token);
    return std::nullopt;
  }
  return result;
}

Step ExpressionParser::unary() {
  if (!at(TokenKind::minus)) return power();
  if (!enter(tokens_.current())) return std::nullopt;
  const Token minus = tokens_.advance();
  Step operand = unary();
  leave();
  if (!operand) return std::nullopt;
  Subtree result = negate_node(minus, *std::move(operand));
  ++result.levels;
  return result;
}

Step ExpressionParser::power() {
  Step base = primary();
  if (!base || !at(TokenKind::power)) return base;
  if (!enter(tokens_.current())) return std::nullopt;
  const Token token = tokens_.advance();
  Step exponent = unary();
  leave();
  if (!exponent) return std::nullopt;
  std::deque<Subtree> operands;
  operands.push_back(*std::move(base));
  operands.push_back(*std::move(exponent));
  Subtree result = node(SyntaxKind::power, token, std::move(operands));
  ++result.levels;
  return result;
}

Step ExpressionParser::primary() {
  switch (tokens_.current().kind) {
    case TokenKind::number:
      return number();
    case TokenKind::name:
      return name();
    case TokenKind::open:
      return parse_brackets();
    default:
      fail(missing_operand(tokens_));
      return std::nullopt;
  }
}

Step ExpressionParser::number() {
  const Token token = tokens_.advance();
  const DecimalParts parts = decimal_parts(tokens_.text(token));
  if (std::optional<ExceededLimit> hit = find_exceeded_limit(parts, limits_)) {
    fail({hit->code, tokens_.span(token), std::move(hit->message), std::move(hit->hint)});
    return std::nullopt;
  }
  Subtree result = node(SyntaxKind::number, token, {});
  result.tree.value = decimal_value(parts);
  return result;
}

Step ExpressionParser::name() {
  const Token token = tokens_.advance();
  Subtree result = node(SyntaxKind::name, token, {});
  result.tree.text = tokens_.text(token);
  if (at(TokenKind::open)) return call(std::move(result));
  if (at(TokenKind::open_index)) return parse_index(std::move(result));
  return result;
}

Step ExpressionParser::parse_index(Subtree named) {
  const Token opened = tokens_.current();
  if (!enter(opened)) return std::nullopt;
  tokens_.advance();
  Step index = sum();
  if (!index || !close(TokenKind::close_index, opened)) return std::nullopt;
  leave();
  named.levels = index->levels + 1;
  named.tree.operands.push_back(std::move(index->tree));
  named.tree.span = join(named.tree.span, tokens_.span(tokens_.previous()));
  return named;
}

Step ExpressionParser::call(Subtree named) {
  const Token opened = tokens_.current();
  if (!enter(opened)) return std::nullopt;
  tokens_.advance();
  named.tree.kind = SyntaxKind::call;
  if (!at(TokenKind::close) && !arguments(named)) return std::nullopt;
  if (!close(TokenKind::close, opened)) return std::nullopt;
  leave();
  ++named.levels;
  named.tree.span = join(named.tree.span, tokens_.span(tokens_.previous()));
  return named;
}

bool ExpressionParser::arguments(Subtree& call) {
  std::deque<Subtree> operands;
  do {
    if (!operands.empty()) tokens_.advance();
    Step argument = sum();
    if (!argument) return false;
    operands.push_back(*std::move(argument));
  } while (at(TokenKind::comma));
  call.tree.operands.reserve(operands.size());
  for (Subtree& operand : operands) {
    call.levels = std::max(call.levels, operand.levels);
    call.tree.operands.push_back(std::move(operand.tree));
  }
  return true;
}

Step ExpressionParser::parse_brackets() {
  const Token opened = tokens_.current();
  if (!enter(opened)) return std::nullopt;
  tokens_.advance();
  Step inner = sum();
  if (!inner || !close(TokenKind::close, opened)) return std::nullopt;
  leave();
  ++inner->levels;
  inner->tree.span = join(tokens_.span(opened), tokens_.span(tokens_.previous()));
  return inner;
}

/// The node of `kind`; a sum or product of one operand is the operand itself. The operands are in a
/// deque, because a growing vector would copy subtrees.
Subtree ExpressionParser::node(SyntaxKind kind, const Token& token,
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
  Subtree result = node(SyntaxKind::negate, minus, std::move(operands));
  result.tree.span = whole;
  return result;
}

bool ExpressionParser::enter(const Token& token) {
  ++depth_;
  return depth_ <= deepest_ || too_deep(token);
}

bool ExpressionParser::too_deep(const Token& token) {
  const bool own_limit = limits_.expression_depth > deepest_expression;
  return fail({Code::E902, tokens_.span(token),
               fmt::format("expression is nested deeper than {}", deepest_),
               own_limit ? "name parts of it in `[define]`"
                         : "`--limit expression_depth=N` raises the limit"});
}

bool ExpressionParser::close(TokenKind kind, const Token& opened) {
  if (!at(kind)) return fail(unclosed_bracket(tokens_, opened));
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
