// Errors of the expression grammar. Each message names the current token; the hint gives the
// correct spelling of the expression that the user probably meant.
#include "parse/syntax_errors.hpp"

#include <fmt/format.h>

#include <utility>

#include "numbers/exact_number.hpp"
#include "parse/decimal.hpp"

namespace elgen {

namespace {

Diagnostic error_at_current(const Lexer& tokens, Code code, std::string message,
                            std::string hint = {}) {
  return {code, tokens.span(tokens.current()), std::move(message), std::move(hint)};
}

Diagnostic misplaced_comma_error(const Lexer& tokens) {
  const Token& number = tokens.previous();
  const Token& comma = tokens.current();
  Lexer ahead = tokens;
  ahead.advance();
  const bool touches = number.end == comma.begin && comma.end == ahead.current().begin;
  if (touches && number.kind == TokenKind::number && ahead.is_at(TokenKind::number)) {
    const std::string whole(tokens.text(number));
    const std::string fraction(tokens.text(ahead.current()));
    return error_at_current(tokens, Code::E306,
                            fmt::format("`{},{}` has a decimal comma", whole, fraction),
                            fmt::format("write `{}.{}`", whole, fraction));
  }
  return error_at_current(tokens, Code::E301, "`,` outside the arguments of a function",
                          "a list is written `[\"x(P)\", \"y(P)\"]`");
}

/// The lexer's error of the current token. For `cart.x` and `theta.dot` with the call to write.
Diagnostic invalid_token_error(const Lexer& tokens) {
  Diagnostic error = *tokens.problem();
  const Token& object = tokens.previous();
  const std::string_view text = tokens.text(tokens.current());
  const bool is_member = object.kind == TokenKind::name && object.end == tokens.current().begin;
  const bool is_call = text == ".x" || text == ".y" || text == ".z" || text == ".dot";
  if (is_member && is_call)
    error.hint = fmt::format("write `{}({})`", text.substr(1), tokens.text(object));
  return error;
}

/// E303 for `2x`, `x y`, `2(x + y)`, `(x)(y)`, `30 deg`.
Diagnostic missing_operator_error(const Lexer& tokens) {
  const Token& left = tokens.previous();
  const Token& right = tokens.current();
  constexpr std::size_t short_enough = 20;
  const bool both_words = left.kind == TokenKind::number || left.kind == TokenKind::name;
  const bool shown_whole = both_words && right.end - left.begin <= short_enough &&
                           !tokens.is_at(TokenKind::left_parenthesis);
  std::string hint = shown_whole
                         ? fmt::format("write `{}*{}`", tokens.text(left), tokens.text(right))
                         : "a product is written with `*`";
  const bool is_angle = tokens.text(right) == "deg" || tokens.text(right) == "degrees";
  if (left.kind == TokenKind::number && is_angle) {
    const cln::cl_RA half_turns = decimal_value(decimal_parts(tokens.text(left))) / 180;
    hint = fmt::format("angles are in rad: write `{}`", multiple_of_pi(half_turns));
  }
  return error_at_current(tokens, Code::E303,
                          tokens.token_in_backticks(right) + " follows " +
                              tokens.token_in_backticks(left) + " without an operator",
                          std::move(hint));
}

}  // namespace

Diagnostic missing_operand_error(const Lexer& tokens) {
  switch (tokens.current().kind) {
    case TokenKind::invalid:
      return *tokens.problem();
    case TokenKind::end:
      return error_at_current(tokens, Code::E302, "expression ends where an operand is expected");
    case TokenKind::left_bracket:
      return error_at_current(tokens, Code::E301, "`[` where an operand is expected",
                              "an index follows a name: `q[i]`");
    default:
      return error_at_current(
          tokens, Code::E302,
          tokens.token_in_backticks(tokens.current()) + " where an operand is expected");
  }
}

Diagnostic misplaced_token_error(const Lexer& tokens) {
  switch (tokens.current().kind) {
    case TokenKind::invalid:
      return invalid_token_error(tokens);
    case TokenKind::comma:
      return misplaced_comma_error(tokens);
    case TokenKind::left_bracket:
      return error_at_current(tokens, Code::E301,
                              "`[` after " + tokens.token_in_backticks(tokens.previous()),
                              "a name takes one index: `q[i]`");
    case TokenKind::right_parenthesis:
    case TokenKind::right_bracket:
      return error_at_current(tokens, Code::E304,
                              tokens.token_in_backticks(tokens.current()) + " was never opened");
    default:
      return missing_operator_error(tokens);
  }
}

Diagnostic unclosed_bracket_error(const Lexer& tokens, const Token& opened) {
  const bool ends = tokens.is_at(TokenKind::end);
  const bool closes =
      tokens.is_at(TokenKind::right_parenthesis) || tokens.is_at(TokenKind::right_bracket);
  if (!ends && !closes) return misplaced_token_error(tokens);
  Diagnostic result =
      error_at_current(tokens, Code::E304,
                       ends ? tokens.token_in_backticks(opened) + " is not closed"
                            : tokens.token_in_backticks(tokens.current()) + " stands where " +
                                  tokens.token_in_backticks(opened) + " is to be closed");
  result.related = tokens.span(opened);
  result.related_message = "opened here";
  return result;
}

}  // namespace elgen
