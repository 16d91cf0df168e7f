// Whole files: size, encoding, format, and errors inside strings at the exact character.
#include "elgen/syntax.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("an error inside a string is reported at its character in the file", "[parse]") {
  struct Row {
    std::string value;  ///< starts at 6:5
    std::string place;
  };
  const auto row = GENERATE(values<Row>({
      {R"("2x")", "E303 6:7"},
      {R"("x\t2")", "E303 6:9"},
      {R"("\u0078 y")", "E303 6:13"},
      {R"("\U00000078 y")", "E303 6:17"},
      {R"("1\u002a*x")", "E305 6:7"},
      {R"('x \ y')", "E301 6:8"},
      {"\"\"\"2x\"\"\"", "E303 6:9"},
      {"\"\"\"\n2x\"\"\"", "E303 7:2"},
      {"\"\"\"\r\n  x\r\n  + 2x\"\"\"", "E303 8:6"},
      {"'''\n  x\n\t  y'''", "E303 8:4"},
      {"\"\"\"x \\\n    + 2x\"\"\"", "E303 7:8"},
      {"\"\"\"(x \\\n    \"\"\"", "E304 6:10"},
      {"\"\u03B1 + x\"", "E307 6:6"},
      {"\"x + \u03B1\" # \u03B1", "E307 6:10"},
      {"\"x \\u03b1\"", "E307 6:8"},
      {"'x #'", "E301 6:8"},
      {"\"x + \\u0000\"", "E301 6:10"},
      {"\"(x\"", "E304 6:8"},
      {"\"\"", "E310 6:6"},
  }));
  INFO(row.value);
  CHECK(model_answer(with_potential(row.value)) == row.place);
}

TEST_CASE("columns of errors count code points, not bytes", "[parse]") {
  CHECK(model_answer("format = 1\nmodel = {name = \"m\", title = \"\u03C0\u03C0\", nmae = 1}\n"
                     "[[coordinate]]\nname = \"x\"\n") == "E103 2:36");
}

TEST_CASE("line ends with carriage returns give the same places", "[parse]") {
  std::string text = with_potential("\"x + 2x\"") + "D = \"(\"\n";
  std::string converted;
  for (const char c : text) converted += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(model_answer(text) == "E303 6:11\nE302 7:7");
  CHECK(model_answer(converted) == model_answer(text));
}

TEST_CASE("all independent errors of a file are reported in one run, in order", "[parse]") {
  CHECK(model_answer("format = 1\n[model]\ntitle = 3\n[[coordinate]]\nname = \"x\"\nunti = \"m\"\n"
                     "[energy]\nT = \"2x\"\nV = \"(x\"\n[[constraint]]\n[extra]\n") ==
        "E105 2:1\nE104 3:9\nE103 6:1\nE303 8:7\nE304 9:8\nE105 10:1\nE106 11:1");
}

TEST_CASE("the format must be 1", "[parse]") {
  CHECK(model_answer("format = 2\nanything = 3\n") == "E102 1:10");
  CHECK(model_answer("format = 1.5\n") == "E102 1:10");
  CHECK(model_answer("[model]\nname = \"m\"\n[[coordinate]]\nname = \"x\"\n") == "E105 1:1");
  CHECK(model_answer("format = \"1\"\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\n") ==
        "E104 1:10");
}

TEST_CASE("a file of exactly the size limit is accepted, one more byte is not", "[parse]") {
  const std::string text = with_potential("0");
  Limits limits;
  limits.file_bytes = text.size();
  CHECK(model_answer(text, limits).starts_with("[]"));
  limits.file_bytes = text.size() - 1;
  CHECK(model_answer(text, limits) == "E901 1:1");
}

TEST_CASE("bytes that are not UTF-8 are rejected at their place", "[parse]") {
  CHECK(model_answer("format = 1\n# caf\xE9\n") == "E110 2:6");
  CHECK(model_answer(with_potential("\"x\xFF\"")) == "E110 6:7");
}

TEST_CASE("a byte order mark is accepted", "[parse]") {
  CHECK(model_answer("\xEF\xBB\xBF" + with_potential("1")).starts_with("[]"));
  CHECK(model_answer("\xEF\xBB\xBF" + with_potential("\"2x\"")) == "E303 6:7");
}

TEST_CASE("a sum of 100 000 terms fits a file", "[parse]") {
  const std::string terms = repeated("x + ", 99'999) + "x";
  CHECK(model_answer(with_potential("\"" + terms + "\"")).size() > terms.size());
}

TEST_CASE("damaged files give a tree or errors inside the file", "[parse]") {
  CHECK(rc::check("damaged files", [] {
    std::string text = with_potential("\"1/2*k*x^2\"") + "[[expect]]\nbias = [\"(x)\", 1e3]\n";
    const auto position = *rc::gen::inRange<std::size_t>(0, text.size());
    text[position] = static_cast<char>(*rc::gen::inRange(0, 256));
    const SourcePointer source = make_source("test", text);
    const auto model = parse_model(source, {});
    RC_ASSERT(model || !model.diagnostics.empty());
    for (const Diagnostic& d : model.diagnostics) RC_ASSERT(d.span.end <= text.size());
  }));
}

TEST_CASE("a part of a source keeps its place in the whole source") {
  const SourcePointer source = make_source("command line", "g = 1 + h");
  const auto expression = parse_expression(Span{source.get(), 4, 9}, {});
  REQUIRE(expression);
  CHECK(covered_text(expression->span) == "1 + h");
  CHECK(covered_text(expression->operands[1].span) == "h");
  CHECK(covered_text(expression->operands[1].token) == "h");
}

TEST_CASE("errors in a part have spans in the whole source") {
  const SourcePointer source = make_source("command line", "g=(1+2");
  const auto expression = parse_expression(Span{source.get(), 2, 6}, {});
  REQUIRE(expression.diagnostics.size() == 1);
  const Diagnostic& error = expression.diagnostics.front();
  CHECK(error.code == Code::E304);
  CHECK(error.span.source == source.get());
  CHECK(error.span.begin == 6);
  REQUIRE(error.related);
  CHECK(error.related->source == source.get());
  CHECK(error.related->begin == 2);
  const SourcePointer damaged = make_source("command line", "g=\xFF");
  CHECK(parse_expression(Span{damaged.get(), 2, 3}, {}).diagnostics.front().span.begin == 2);
}
