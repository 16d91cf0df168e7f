// Lexer: the tokens of an expression, one at a time, so that errors come in reading order. Keeps
// the current and the previous token.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"
#include "parse/decoded_text.hpp"

namespace elgen {

enum class TokenKind : std::uint8_t {
  number,
  name,
  plus,
  minus,
  times,
  divide,
  power,
  left_parenthesis,   ///< (
  right_parenthesis,  ///< )
  left_bracket,       ///< [
  right_bracket,      ///< ]
  comma,
  end,      ///< empty, at the end of the last token
  invalid,  ///< problem() has the error
};

/// Bytes [begin, end) of the decoded text.
struct Token {
  TokenKind kind = TokenKind::end;
  std::size_t begin = 0;
  std::size_t end = 0;
};

class Lexer {
 public:
  /// Reads bytes [begin, end) of `text`, which must outlive the lexer.
  Lexer(const DecodedText& text, std::size_t begin, std::size_t end);

  [[nodiscard]] const Token& previous() const { return previous_; }
  [[nodiscard]] const Token& current() const { return current_; }
  [[nodiscard]] bool is_at(TokenKind kind) const { return current_.kind == kind; }

  /// Reads the next token, and returns the token that was current.
  Token advance();

  [[nodiscard]] std::string_view text(const Token& token) const;
  [[nodiscard]] Span span(const Token& token) const {
    return source_->span(token.begin, token.end);
  }
  [[nodiscard]] std::string token_in_backticks(const Token& token) const;
  /// The error of the current token, if it is invalid: E301, E305, E307, E308, E317.
  [[nodiscard]] const std::optional<Diagnostic>& problem() const { return problem_; }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const;
  Token scan_token();
  Token consume_token(TokenKind kind, std::size_t bytes);
  Token scan_number();
  Token scan_name();
  Token reject_comparison();
  Token reject_character();
  Token consume_invalid(Code code, std::size_t bytes, std::string message, std::string hint);

  const DecodedText* source_;
  std::string_view bytes_;  ///< of the text, up to the end of the expression
  std::size_t position_;
  std::size_t last_end_;
  std::optional<Diagnostic> problem_ = {};
  Token previous_ = {};
  Token current_;
};

}  // namespace elgen
