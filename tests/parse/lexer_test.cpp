// Tokens and their spans, and the lexer's messages for text that is no token.
#include "parse/lexer.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

struct Lexed {
  std::string tokens;  ///< each token in brackets
  std::optional<Diagnostic> problem;
};

Lexed lex(const std::string& input) {
  const SourcePointer source = make_source("test", input);
  const auto size = static_cast<std::uint32_t>(input.size());
  const DecodedText text = verbatim_text({source.get(), 0, size});
  Lexer lexer(text, 0, input.size());
  Lexed result;
  while (!lexer.is_at(TokenKind::end) && !lexer.is_at(TokenKind::invalid)) {
    result.tokens += "[" + std::string(lexer.text(lexer.advance())) + "]";
  }
  result.problem = lexer.problem();
  return result;
}

}  // namespace

TEST_CASE("expressions are split into tokens", "[parse]") {
  CHECK(lex("a+b_1*2.5e-3").tokens == "[a][+][b_1][*][2.5e-3]");
  CHECK(lex("-x^2 / (y)").tokens == "[-][x][^][2][/][(][y][)]");
  CHECK(lex("p[i-1], \n\t q").tokens == "[p][[][i][-][1][]][,][q]");
  CHECK(lex("2x").tokens == "[2][x]");
  CHECK(lex("").tokens.empty());
}

TEST_CASE("the end token is just after the last token", "[parse]") {
  const SourcePointer source = make_source("test", "x   ");
  const DecodedText text = verbatim_text({source.get(), 0, 4});
  Lexer lexer(text, 0, 4);
  (void)lexer.advance();
  const Token end = lexer.advance();
  CHECK(end.kind == TokenKind::end);
  CHECK(end.begin == 1);
}

TEST_CASE("text that is no token is reported", "[parse]") {
  struct Row {
    std::string input;
    Code code;
    std::uint32_t begin;
    std::string message;
    std::string hint;
  };
  const auto row = GENERATE(values<Row>({
      {"x**2", Code::E305, 1, "`**` is not an operator", "powers are written `^`"},
      {"a == b", Code::E317, 2, "`==` in an expression",
       "an expression is a value, without `=` or comparisons"},
      {"a != b", Code::E317, 2, "`!=` in an expression",
       "an expression is a value, without `=` or comparisons"},
      {"5!", Code::E301, 1, "`!` has no meaning in an expression", "there is no factorial"},
      {"x'", Code::E301, 1, "`'` has no meaning in an expression", "write `dot(x)`"},
      {"x # note", Code::E301, 2, "`#` has no meaning in an expression",
       "put the comment outside the quotes"},
      {"_a", Code::E301, 0, "`_` has no meaning in an expression", "a name starts with a letter"},
      {"\\dot{x}", Code::E301, 0, "`\\` has no meaning in an expression",
       "LaTeX is not read: write `theta`, `dot(x)`, `a/b`"},
      {"{x}", Code::E301, 0, "`{` has no meaning in an expression", "write `(`"},
      {"x\x01", Code::E301, 1, "`U+0001` has no meaning in an expression", ""},
      {"2\u00B7x", Code::E307, 1, "`\u00B7` (U+00B7) is not ASCII",
       "write `*` instead of this character"},
      {"\u03C0", Code::E307, 0, "`\u03C0` (U+03C0) is not ASCII",
       "write `pi` instead of the Greek letter"},
      {"\u0445", Code::E307, 0, "`\u0445` (U+0445) is not ASCII",
       "write `x` instead of the Cyrillic letter"},
      {"x\u00B2", Code::E307, 1, "`\u00B2` (U+00B2) is not ASCII",
       "write `^2` instead of this character"},
      {"x\u00A0", Code::E307, 1, "`\u00A0` (U+00A0) is not ASCII", "write a plain space"},
      {"\uFF08", Code::E307, 0, "`\uFF08` (U+FF08) is not ASCII", "write `(`"},
      {"\u4E2D", Code::E307, 0, "`\u4E2D` (U+4E2D) is not ASCII", ""},
      {"1.2.3", Code::E308, 0, "`1.2.3` is not a number",
       "numbers are written `12`, `0.5` or `1e-3`"},
  }));
  INFO(row.input);
  const Lexed lexed = lex(row.input);
  REQUIRE(lexed.problem);
  CHECK(lexed.problem->code == row.code);
  CHECK(lexed.problem->span.begin == row.begin);
  CHECK(lexed.problem->message == row.message);
  CHECK(lexed.problem->hint == row.hint);
}

TEST_CASE("a lexer knows its current token and the previous token", "[parse]") {
  const SourcePointer source = make_source("test", "a + 1");
  const DecodedText text = verbatim_text({source.get(), 0, 5});
  Lexer tokens(text, 0, 5);
  CHECK(tokens.is_at(TokenKind::name));
  CHECK(tokens.text(tokens.advance()) == "a");
  CHECK(tokens.is_at(TokenKind::plus));
  CHECK(tokens.token_in_backticks(tokens.previous()) == "`a`");
  CHECK(tokens.span(tokens.current()).begin == 2);
  tokens.advance();
  tokens.advance();
  CHECK(tokens.is_at(TokenKind::end));
  CHECK(tokens.span(tokens.current()).begin == 5);
  CHECK_FALSE(tokens.problem());
}

TEST_CASE("a copy of a lexer looks ahead without moving the original", "[parse]") {
  const SourcePointer source = make_source("test", "1,5");
  const DecodedText text = verbatim_text({source.get(), 0, 3});
  const Lexer tokens(text, 0, 3);
  Lexer ahead = tokens;
  ahead.advance();
  CHECK(ahead.is_at(TokenKind::comma));
  CHECK(tokens.is_at(TokenKind::number));
}
