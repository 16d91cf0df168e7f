// The window of two tokens.
#include "parse/token_stream.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("a token stream knows the token it is at and the one before", "[parse]") {
  const SourcePointer source = make_source("test", "a + 1");
  const DecodedText text = copied_text({source.get(), 0, 5});
  TokenStream tokens(text, 0, 5);
  CHECK(tokens.at(TokenKind::name));
  CHECK(tokens.text(tokens.advance()) == "a");
  CHECK(tokens.at(TokenKind::plus));
  CHECK(tokens.shown(tokens.previous()) == "`a`");
  CHECK(tokens.span(tokens.current()).begin == 2);
  tokens.advance();
  tokens.advance();
  CHECK(tokens.at(TokenKind::end));
  CHECK(tokens.span(tokens.current()).begin == 5);
  CHECK_FALSE(tokens.problem());
}

TEST_CASE("a copy of a token stream looks ahead without moving it", "[parse]") {
  const SourcePointer source = make_source("test", "1,5");
  const DecodedText text = copied_text({source.get(), 0, 3});
  const TokenStream tokens(text, 0, 3);
  TokenStream ahead = tokens;
  ahead.advance();
  CHECK(ahead.at(TokenKind::comma));
  CHECK(tokens.at(TokenKind::number));
}
