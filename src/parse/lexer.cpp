// The lexer of the model language. Numbers, names, `+ - * / ^ ( ) [ ] ,`; everything else is named
// in an error together with what the language writes for it.
#include "parse/lexer.hpp"

#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/wording.hpp"
#include "parse/characters.hpp"
#include "parse/decimal.hpp"

namespace elgen {

namespace {

bool starts_comparison(char c) { return c == '=' || c == '<' || c == '>'; }

/// In the order of TokenKind, from `plus` on.
constexpr std::string_view symbols = "+-*/^()[],";
static_assert(static_cast<std::size_t>(TokenKind::plus) + symbols.size() ==
              static_cast<std::size_t>(TokenKind::end));

TokenKind symbol_kind(char c) {
  const std::size_t at = symbols.find(c);
  if (at == std::string_view::npos) return TokenKind::invalid;
  return static_cast<TokenKind>(static_cast<std::size_t>(TokenKind::plus) + at);
}

/// For ASCII characters whose meaning elsewhere suggests what was meant.
std::string ascii_hint(char32_t character) {
  switch (character) {
    case U'#':
      return "a comment stands outside the quotes";
    case U'_':
      return "a name starts with a letter";
    case U'!':
      return "there is no factorial";
    case U';':
      return "one string holds one expression";
    default:
      return replacement_hint(character);
  }
}

}  // namespace

Lexer::Lexer(const DecodedText& text, std::size_t begin, std::size_t end)
    : source_(&text),
      bytes_(std::string_view(text.text).substr(0, end)),
      position_(begin),
      last_end_(begin),
      current_(next()) {}

Token Lexer::advance() {
  previous_ = std::exchange(current_, next());
  return previous_;
}

std::string Lexer::shown(const Token& token) const { return in_backticks(text(token)); }

std::string_view Lexer::text(const Token& token) const {
  return bytes_.substr(token.begin, token.end - token.begin);
}

char Lexer::peek(std::size_t ahead) const {
  return position_ + ahead < bytes_.size() ? bytes_[position_ + ahead] : '\0';
}

Token Lexer::take(TokenKind kind, std::size_t bytes) {
  const Token token{kind, position_, position_ + bytes};
  position_ = last_end_ = token.end;
  return token;
}

Token Lexer::invalid(Code code, std::size_t bytes, std::string message, std::string hint) {
  problem_ = Diagnostic{code, source_->span(position_, position_ + bytes), std::move(message),
                        std::move(hint)};
  return take(TokenKind::invalid, bytes);
}

Token Lexer::next() {
  while (position_ < bytes_.size() && is_space(peek())) ++position_;
  if (position_ == bytes_.size()) return {TokenKind::end, last_end_, last_end_};
  const char first = peek();
  if (is_digit(first) || first == '.') return number();
  if (is_letter(first)) return name();
  if (starts_comparison(first) || (first == '!' && peek(1) == '=')) return comparison();
  if (first == '*' && peek(1) == '*') {
    return invalid(Code::E305, 2, "`**` is not an operator", "powers are written `^`");
  }
  const TokenKind kind = symbol_kind(first);
  return kind == TokenKind::invalid ? unknown_character() : take(kind, 1);
}

Token Lexer::number() {
  const NumberExtent extent = number_extent(bytes_, position_);
  const std::size_t bytes = extent.end - position_;
  if (extent.well_formed) return take(TokenKind::number, bytes);
  return invalid(Code::E308, bytes,
                 in_backticks(bytes_.substr(position_, bytes)) + " is not a number",
                 "numbers are written `12`, `0.5` or `1e-3`");
}

Token Lexer::name() {
  std::size_t bytes = 1;
  while (is_word_character(peek(bytes))) ++bytes;
  return take(TokenKind::name, bytes);
}

Token Lexer::comparison() {
  const std::size_t bytes = peek(1) == '=' ? 2 : 1;
  return invalid(Code::E317, bytes,
                 in_backticks(bytes_.substr(position_, bytes)) + " in an expression",
                 "an expression is a value, without `=` or comparisons");
}

Token Lexer::unknown_character() {
  const CodePoint point = code_point_at(bytes_, position_);
  if (point.value < 0x80) {
    return invalid(Code::E301, 1,
                   in_backticks(bytes_.substr(position_, 1)) + " has no meaning in an expression",
                   ascii_hint(point.value));
  }
  return invalid(Code::E307, point.bytes,
                 in_backticks(bytes_.substr(position_, point.bytes)) + " (" +
                     code_point_name(point.value) + ") is not ASCII",
                 replacement_hint(point.value));
}

}  // namespace elgen
