// Tokens as C and C++ cut them.
#include "readback/code_tokens.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace elgen {
namespace {

std::string joined(std::string_view text, CodeKind kind = CodeKind::file) {
  std::string tokens;
  for (const CodeToken& token : code_tokens(text, kind).tokens) {
    const bool is_line = token.kind == CodeTokenKind::end_of_directive;
    const bool is_invalid = token.kind == CodeTokenKind::invalid;
    tokens +=
        is_line ? "<line> " : (is_invalid ? "<invalid> " : "") + std::string(token.text) + " ";
  }
  while (!tokens.empty() && tokens.back() == ' ') tokens.pop_back();
  return tokens;
}

}  // namespace

TEST_CASE("a token is as long as it can be") {
  CHECK(joined("a - -b") == "a - - b");
  CHECK(joined("a--b") == "a -- b");
  CHECK(joined("p->m*1.5e-3F") == "p -> m * 1.5e-3F");
  CHECK(joined("q[0]*x_1+.5") == "q [ 0 ] * x_1 + .5");
  CHECK(joined("1.2.3 0x1p-3f") == "1.2.3 0x1p-3f");
  CHECK(joined("\"a \\\" b\" c") == "\"a \\\" b\" c");
}

TEST_CASE("comments are kept apart, and counted before each token") {
  const CodeText code = code_tokens("a // one\n/* two */ b");
  REQUIRE(code.comments.size() == 2);
  CHECK(code.comments[0] == "// one");
  CHECK(code.tokens[0].comments == 0);
  CHECK(code.tokens[1].comments == 2);
}

TEST_CASE("a comment whose line ends with a backslash goes on") {
  CHECK(joined("a // one \\\n b\nc") == "a c");
}

TEST_CASE("a directive ends with its line, unless a backslash continues it") {
  CHECK(joined("#define A \\\n  1\nb") == "# define A 1 <line> b");
  CHECK(joined("#pragma once") == "# pragma once <line>");
}

TEST_CASE("what starts no token is invalid") {
  CHECK(joined("a @ b") == "a <invalid> @ b");
  CHECK(joined("\"open\nb") == "<invalid> \" open b");
  CHECK(joined("/* open") == "/ * open");
}

TEST_CASE("a hole of a picture is one token") {
  CHECK(joined("{ {{body}}}", CodeKind::picture) == "{ {{body}} }");
  CHECK(joined("{{a}}") == "{ { a } }");
}

}  // namespace elgen
