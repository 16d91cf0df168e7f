// The lexer of the model language: numbers, names, `+ - * / ^ ( ) [ ] ,`. Every other character is
// an error, with a hint on its replacement in the language.
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
#include "formula/glyphs.hpp"
#include "parse/decimal.hpp"

namespace elgen {

namespace {

/// `replacement`: a text of the language. `characters`: characters of other notations that a user
/// should replace by this text.
struct ReplacementRow {
  std::string_view replacement;
  std::u32string_view characters;
};

constexpr std::array replacements{
    // ASCII characters from other languages
    ReplacementRow{"dot(x)", U"'"},
    ReplacementRow{"(", U"{"},
    ReplacementRow{")", U"}"},
    // operators
    ReplacementRow{"*", U"\u00B7\u00D7\u2022\u2217\u2219\u22C5"},
    ReplacementRow{"/", U"\u00F7\u2044\u2215"},
    ReplacementRow{"-", U"\u00AD\u2010\u2011\u2012\u2013\u2014\u2212"},
    ReplacementRow{"sqrt(x)", U"\u221A"},
    ReplacementRow{"dot(x)", U"\u2032\u0307\u02D9\u2019"},
    // superscripts, fractions, degrees
    ReplacementRow{"^2", U"\u00B2"},
    ReplacementRow{"^3", U"\u00B3"},
    ReplacementRow{"^1", U"\u00B9"},
    ReplacementRow{"^0", U"\u2070"},
    ReplacementRow{"^4", U"\u2074"},
    ReplacementRow{"^-", U"\u207B"},
    ReplacementRow{"1/4", U"\u00BC"},
    ReplacementRow{"1/2", U"\u00BD"},
    ReplacementRow{"3/4", U"\u00BE"},
    ReplacementRow{"*pi/180", U"\u00B0"},
    // spaces
    ReplacementRow{" ", U"\u00A0\u2009\u202F\u3000"},
    // the micro sign, and signs of a sum; greek_command() knows all other Greek letters
    ReplacementRow{"mu", U"\u00B5"},
    ReplacementRow{"sum(i, a, b, e)", U"\u03A3\u2211"},
};

/// Cyrillic letters that look like Latin letters, and these Latin letters in the same order.
constexpr std::u32string_view look_alikes =
    U"\u0410\u0412\u0415\u041A\u041C\u041D\u041E\u0420\u0421\u0422"
    U"\u0425\u0430\u0435\u043E\u0440\u0441\u0443\u0445\u0456\u0458";
constexpr std::string_view latin_letters = "ABEKMHOPCTXaeopcyxij";
static_assert(look_alikes.size() == latin_letters.size());

/// True for full-width forms: the code of an ASCII character plus full_width_distance.
bool is_full_width(char32_t c) { return c >= 0xFF01 && c <= 0xFF5E; }
constexpr char32_t full_width_distance = 0xFEE0;

std::string_view script_name(char32_t c) {
  if (c >= 0x0370 && c <= 0x03FF) return "the Greek letter";
  if (c >= 0x0400 && c <= 0x04FF) return "the Cyrillic letter";
  return "this character";
}

/// `pi` for U+03C0, `-` for U+2212 …; "" if there is no replacement.
std::string_view find_replacement(char32_t character) {
  const std::size_t letter = look_alikes.find(character);
  if (letter != std::u32string_view::npos) return latin_letters.substr(letter, 1);
  const auto row = std::ranges::find_if(replacements, [&](const ReplacementRow& r) {
    return r.characters.find(character) != std::u32string_view::npos;
  });
  if (row != replacements.end()) return row->replacement;
  std::string text;
  append_utf8(text, character);
  const std::string_view greek = greek_command(text);
  return greek.substr(greek.starts_with("var") ? 3 : 0);
}

/// "write `pi`" for U+03C0.
std::string replacement_hint(char32_t character) {
  if (is_full_width(character)) {
    return fmt::format("write `{}`", static_cast<char>(character - full_width_distance));
  }
  const std::string_view written = find_replacement(character);
  if (written.empty()) return {};
  if (written == " ") return "write a plain space";
  if (character < 0x80) return fmt::format("write `{}`", written);
  return fmt::format("write `{}` instead of {}", written, script_name(character));
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

/// Hint on an ASCII character that other languages use, such as `#`.
std::string ascii_hint(char32_t character) {
  switch (character) {
    case U'#':
      return "put the comment outside the quotes";
    case U'_':
      return "a name starts with a letter";
    case U'!':
      return "there is no factorial";
    case U';':
      return "one string holds one expression";
    case U'\\':
      return "LaTeX is not read: write `theta`, `dot(x)`, `a/b`";
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
      current_(scan_token()) {}

Token Lexer::advance() {
  previous_ = std::exchange(current_, scan_token());
  return previous_;
}

std::string Lexer::token_in_backticks(const Token& token) const { return quote_text(text(token)); }

std::string_view Lexer::text(const Token& token) const {
  return bytes_.substr(token.begin, token.end - token.begin);
}

char Lexer::peek(std::size_t ahead) const {
  return position_ + ahead < bytes_.size() ? bytes_[position_ + ahead] : '\0';
}

Token Lexer::consume_token(TokenKind kind, std::size_t bytes) {
  const Token token{kind, position_, position_ + bytes};
  position_ = last_end_ = token.end;
  return token;
}

Token Lexer::consume_invalid(Code code, std::size_t bytes, std::string message, std::string hint) {
  problem_ = Diagnostic{code, source_->span(position_, position_ + bytes), std::move(message),
                        std::move(hint)};
  return consume_token(TokenKind::invalid, bytes);
}

Token Lexer::scan_token() {
  while (position_ < bytes_.size() && is_space(peek())) ++position_;
  if (position_ == bytes_.size()) return {TokenKind::end, last_end_, last_end_};
  const char first = peek();
  if (is_digit(first) || first == '.') return scan_number();
  if (is_letter(first)) return scan_name();
  if (starts_comparison(first) || (first == '!' && peek(1) == '=')) return reject_comparison();
  if (first == '*' && peek(1) == '*') {
    return consume_invalid(Code::E305, 2, "`**` is not an operator", "powers are written `^`");
  }
  const TokenKind kind = symbol_kind(first);
  return kind == TokenKind::invalid ? reject_character() : consume_token(kind, 1);
}

Token Lexer::scan_number() {
  const NumberExtent extent = number_extent(bytes_, position_);
  const std::size_t bytes = extent.end - position_;
  if (extent.well_formed) return consume_token(TokenKind::number, bytes);
  return consume_invalid(Code::E308, bytes,
                         quote_text(bytes_.substr(position_, bytes)) + " is not a number",
                         "numbers are written `12`, `0.5` or `1e-3`");
}

Token Lexer::scan_name() {
  std::size_t bytes = 1;
  while (is_word_character(peek(bytes))) ++bytes;
  return consume_token(TokenKind::name, bytes);
}

Token Lexer::reject_comparison() {
  const std::size_t bytes = peek(1) == '=' ? 2 : 1;
  return consume_invalid(Code::E317, bytes,
                         quote_text(bytes_.substr(position_, bytes)) + " in an expression",
                         "an expression is a value, without `=` or comparisons");
}

Token Lexer::reject_character() {
  const CodePoint point = code_point_at(bytes_, position_);
  if (point.value < 0x80) {
    return consume_invalid(
        Code::E301, 1, quote_text(bytes_.substr(position_, 1)) + " has no meaning in an expression",
        ascii_hint(point.value));
  }
  return consume_invalid(
      Code::E307, point.bytes,
      quote_text(bytes_.substr(position_, point.bytes)) +
          (is_hidden(point.value) ? "" : " (" + code_point_name(point.value) + ")") +
          " is not ASCII",
      replacement_hint(point.value));
}

}  // namespace elgen
