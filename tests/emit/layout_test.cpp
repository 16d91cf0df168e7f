// layout: line breaks, and user text inside comments and literals.
#include "emit/text/layout.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

using namespace elgen;
using Lines = std::vector<std::string>;

TEST_CASE("an expression breaks before its outermost operators") {
  CHECK(wrap_expression("a * b + c * d", {100, "  "}) == Lines{"a * b + c * d"});
  CHECK(wrap_expression("a * b + c * d", {8, "  "}) == Lines{"a * b", "  + c * d"});
  CHECK(wrap_expression("f * (a + b) * g", {11, "  "}) == Lines{"f * (a + b)", "  * g"});
  CHECK(wrap_expression("f(aaaa, bbbb)", {10, "  "}) == Lines{"f(aaaa,", "  bbbb)"});
}

TEST_CASE("an unbreakable text stays on one line") {
  CHECK(wrap_expression("a_long_name", {4, "  "}) == Lines{"a_long_name"});
  CHECK(wrap_expression("-a_long_name", {4, "  "}) == Lines{"-a_long_name"});
  CHECK(wrap_words("word", {2, ""}) == Lines{"word"});
}

TEST_CASE("words") { CHECK(wrap_words("aa bb cc", {5, " "}) == Lines{"aa bb", " cc"}); }

TEST_CASE("wrapping keeps all words") {
  CHECK(rc::check("lines joined by spaces are the text", [] {
    const auto words = *rc::gen::container<std::vector<std::string>>(
        rc::gen::element<std::string>("a", "(b + c)", "d * e", "+ f", "g, h"));
    std::string text = "x";
    for (const std::string& word : words) text += " " + word;
    std::string joined;
    for (const std::string& line : wrap_expression(text, {10, ""})) {
      joined += (joined.empty() ? "" : " ") + line;
    }
    RC_ASSERT(joined == text);
  }));
}

TEST_CASE("user text cannot end its comment") {
  CHECK(comment_text("two\nlines\t here ") == "two lines here");
  CHECK(comment_text("continued \\") == "continued \\.");
  CHECK(comment_text("") == "");
  CHECK(comment_text("a \\ b \\alpha") == "a \\. b \\alpha");
  CHECK(comment_text("really?\?/ so") == "really? ?/ so");
  CHECK(comment_text("a\u202eb\x01\xff") == "aU+202EbU+0001?");
}

TEST_CASE("user text cannot end its literal") {
  CHECK(string_literal("q[1]") == "\"q[1]\"");
  CHECK(string_literal("a\"b\\c") == "\"a\\\"b\\\\c\"");
}

TEST_CASE("documentation of members is aligned") {
  CHECK(member_doc_lines({{"int a;", "one"}, {"double b;", "two"}}) ==
        Lines{"int a;     ///< one", "double b;  ///< two"});
  const std::string wide(80, 'x');
  CHECK(member_doc_lines({{"int a;", "one"}, {wide, "a doc that has no place"}}) ==
        Lines{"int a;  ///< one", "/// a doc that has no place", wide});
}

TEST_CASE("a short signature is one line") {
  CHECK(signature("void f", {"const A&", "const B& b"}, " noexcept") ==
        "void f(const A&, const B& b) noexcept");
}

TEST_CASE("long signatures break between arguments, aligned below the first if possible") {
  const std::vector<std::string> arguments = {std::string(32, 'A'), std::string(32, 'B')};
  const std::string start = "[[nodiscard]] Forces<Scalar> gravity";
  CHECK(signature(start, arguments, " noexcept") == start + "(" + arguments[0] + ",\n" +
                                                        std::string(start.size() + 1, ' ') +
                                                        arguments[1] + ") noexcept");
  const std::string wide(70, 'x');
  CHECK(signature(wide, arguments, "") ==
        wide + "(\n    " + arguments[0] + ", " + arguments[1] + ")");
}
