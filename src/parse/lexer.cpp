// The lexer of the model language. Numbers, names, `+ - * / ^ ( ) [ ] ,`; everything else is named
// in an error together with what the language writes for it.
#include "parse/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "elgen/wording.hpp"
#include "parse/decimal.hpp"

namespace elgen {

namespace {

struct SpelledCharacter {
  char32_t character;
  std::string_view written;
};

constexpr std::array replacements{
    // ASCII that other languages use
    SpelledCharacter{U'\'', "dot(x)"},
    SpelledCharacter{U'{', "("},
    SpelledCharacter{U'}', ")"},
    // operators
    SpelledCharacter{0x00B7, "*"},
    SpelledCharacter{0x00D7, "*"},
    SpelledCharacter{0x2022, "*"},
    SpelledCharacter{0x2217, "*"},
    SpelledCharacter{0x2219, "*"},
    SpelledCharacter{0x22C5, "*"},
    SpelledCharacter{0x00F7, "/"},
    SpelledCharacter{0x2044, "/"},
    SpelledCharacter{0x2215, "/"},
    SpelledCharacter{0x00AD, "-"},
    SpelledCharacter{0x2010, "-"},
    SpelledCharacter{0x2011, "-"},
    SpelledCharacter{0x2012, "-"},
    SpelledCharacter{0x2013, "-"},
    SpelledCharacter{0x2014, "-"},
    SpelledCharacter{0x2212, "-"},
    SpelledCharacter{0x221A, "sqrt(x)"},
    SpelledCharacter{0x2032, "dot(x)"},
    SpelledCharacter{0x0307, "dot(x)"},
    SpelledCharacter{0x02D9, "dot(x)"},
    SpelledCharacter{0x2019, "dot(x)"},
    // superscripts, fractions, degrees
    SpelledCharacter{0x00B2, "^2"},
    SpelledCharacter{0x00B3, "^3"},
    SpelledCharacter{0x00B9, "^1"},
    SpelledCharacter{0x2070, "^0"},
    SpelledCharacter{0x2074, "^4"},
    SpelledCharacter{0x207B, "^-"},
    SpelledCharacter{0x00BC, "1/4"},
    SpelledCharacter{0x00BD, "1/2"},
    SpelledCharacter{0x00BE, "3/4"},
    SpelledCharacter{0x00B0, "*pi/180"},
    // spaces
    SpelledCharacter{0x00A0, " "},
    SpelledCharacter{0x2009, " "},
    SpelledCharacter{0x202F, " "},
    SpelledCharacter{0x3000, " "},
    // Greek
    SpelledCharacter{0x03B1, "alpha"},
    SpelledCharacter{0x03B2, "beta"},
    SpelledCharacter{0x03B3, "gamma"},
    SpelledCharacter{0x03B4, "delta"},
    SpelledCharacter{0x03B5, "epsilon"},
    SpelledCharacter{0x03B6, "zeta"},
    SpelledCharacter{0x03B7, "eta"},
    SpelledCharacter{0x03B8, "theta"},
    SpelledCharacter{0x03D1, "theta"},
    SpelledCharacter{0x03B9, "iota"},
    SpelledCharacter{0x03BA, "kappa"},
    SpelledCharacter{0x03BB, "lambda"},
    SpelledCharacter{0x03BC, "mu"},
    SpelledCharacter{0x00B5, "mu"},
    SpelledCharacter{0x03BD, "nu"},
    SpelledCharacter{0x03BE, "xi"},
    SpelledCharacter{0x03C0, "pi"},
    SpelledCharacter{0x03C1, "rho"},
    SpelledCharacter{0x03C3, "sigma"},
    SpelledCharacter{0x03C4, "tau"},
    SpelledCharacter{0x03C5, "upsilon"},
    SpelledCharacter{0x03C6, "phi"},
    SpelledCharacter{0x03D5, "phi"},
    SpelledCharacter{0x03C7, "chi"},
    SpelledCharacter{0x03C8, "psi"},
    SpelledCharacter{0x03C9, "omega"},
    SpelledCharacter{0x0393, "Gamma"},
    SpelledCharacter{0x0394, "Delta"},
    SpelledCharacter{0x0398, "Theta"},
    SpelledCharacter{0x039B, "Lambda"},
    SpelledCharacter{0x03A0, "Pi"},
    SpelledCharacter{0x03A3, "sum(i, a, b, e)"},
    SpelledCharacter{0x2211, "sum(i, a, b, e)"},
    SpelledCharacter{0x03A6, "Phi"},
    SpelledCharacter{0x03A8, "Psi"},
    SpelledCharacter{0x03A9, "Omega"},
    // Cyrillic letters that look like Latin ones
    SpelledCharacter{0x0410, "A"},
    SpelledCharacter{0x0412, "B"},
    SpelledCharacter{0x0415, "E"},
    SpelledCharacter{0x041A, "K"},
    SpelledCharacter{0x041C, "M"},
    SpelledCharacter{0x041D, "H"},
    SpelledCharacter{0x041E, "O"},
    SpelledCharacter{0x0420, "P"},
    SpelledCharacter{0x0421, "C"},
    SpelledCharacter{0x0422, "T"},
    SpelledCharacter{0x0425, "X"},
    SpelledCharacter{0x0430, "a"},
    SpelledCharacter{0x0435, "e"},
    SpelledCharacter{0x043E, "o"},
    SpelledCharacter{0x0440, "p"},
    SpelledCharacter{0x0441, "c"},
    SpelledCharacter{0x0443, "y"},
    SpelledCharacter{0x0445, "x"},
    SpelledCharacter{0x0456, "i"},
    SpelledCharacter{0x0458, "j"},
};

/// Full-width forms stand at a fixed distance from their ASCII.
bool is_full_width(char32_t c) { return c >= 0xFF01 && c <= 0xFF5E; }
constexpr char32_t full_width_distance = 0xFEE0;

std::string_view script_name(char32_t c) {
  if (c >= 0x0370 && c <= 0x03FF) return "the Greek letter";
  if (c >= 0x0400 && c <= 0x04FF) return "the Cyrillic letter";
  return "this character";
}

/// "write `pi`" for U+03C0, "write `-`" for U+2212 …; empty where there is nothing to suggest.
std::string replacement_hint(char32_t character) {
  if (is_full_width(character)) {
    return fmt::format("write `{}`", static_cast<char>(character - full_width_distance));
  }
  const auto row =
      std::find_if(replacements.begin(), replacements.end(),
                   [&](const SpelledCharacter& r) { return r.character == character; });
  if (row == replacements.end()) return {};
  if (row->written == " ") return "write a plain space";
  if (character < 0x80) return fmt::format("write `{}`", row->written);
  return fmt::format("write `{}` instead of {}", row->written, script_name(character));
}

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
                 in_backticks(bytes_.substr(position_, point.bytes)) +
                     (is_hidden(point.value) ? "" : " (" + code_point_name(point.value) + ")") +
                     " is not ASCII",
                 replacement_hint(point.value));
}

}  // namespace elgen
