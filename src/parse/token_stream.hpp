// TokenStream: the token to be read and the one before it, with their places and texts.
#pragma once

#include <string>

#include "parse/lexer.hpp"

namespace elgen {

class TokenStream {
 public:
  /// Reads bytes [begin, end) of `text`, which must outlive the stream.
  TokenStream(const DecodedText& text, std::size_t begin, std::size_t end);

  [[nodiscard]] const Token& previous() const { return previous_; }
  [[nodiscard]] const Token& current() const { return current_; }
  [[nodiscard]] bool at(TokenKind kind) const { return current_.kind == kind; }

  /// Steps on and returns the token that was current.
  Token advance();

  [[nodiscard]] std::string_view text(const Token& token) const { return lexer_.text(token); }
  [[nodiscard]] Span span(const Token& token) const;
  /// The token in back-ticks.
  [[nodiscard]] std::string shown(const Token& token) const;
  [[nodiscard]] const std::optional<Diagnostic>& problem() const { return lexer_.problem(); }

 private:
  const DecodedText* text_;
  Lexer lexer_;
  Token previous_ = {};
  Token current_;
};

}  // namespace elgen
