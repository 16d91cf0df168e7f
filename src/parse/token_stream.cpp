// TokenStream: a window of two tokens over the lexer.
#include "parse/token_stream.hpp"

#include "elgen/wording.hpp"

namespace elgen {

TokenStream::TokenStream(const DecodedText& text, std::size_t begin, std::size_t end)
    : text_(&text), lexer_(text, begin, end), current_(lexer_.next()) {}

Token TokenStream::advance() {
  previous_ = current_;
  current_ = lexer_.next();
  return previous_;
}

Span TokenStream::span(const Token& token) const { return text_->span(token.begin, token.end); }

std::string TokenStream::shown(const Token& token) const { return quoted(text(token)); }

}  // namespace elgen
