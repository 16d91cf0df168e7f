// TOML strings of all four forms: their decoded text, and the span of each part in the file.
#include "parse/decoded_text.hpp"

#include <toml++/toml.h>

#include <catch2/catch.hpp>

#include "rapidcheck.h"

using namespace elgen;

namespace {

struct Decoded {
  SourcePointer source;
  DecodedText text;
};

/// Decodes `token`, which starts at byte 3 of its source.
Decoded decode(const std::string& token) {
  SourcePointer source = make_source("test", "v =" + token);
  const auto end = static_cast<std::uint32_t>(source->text.size());
  DecodedText text = decode_string({source.get(), 3, end});
  return {std::move(source), std::move(text)};
}

/// The source text of the decoded bytes [begin, end).
std::string behind(const Decoded& decoded, std::size_t begin, std::size_t end) {
  return std::string(covered_text(decoded.text.span(begin, end)));
}

}  // namespace

TEST_CASE("a plain string decodes to itself", "[parse]") {
  const Decoded decoded = decode("\"x + y\"");
  CHECK(decoded.text.text == "x + y");
  CHECK(decoded.text.pieces.size() == 1);
  CHECK(decoded.text.span(4, 5).begin == 8);
  CHECK(behind(decoded, 0, 5) == "x + y");
}

TEST_CASE("an escape decodes to one piece with one span", "[parse]") {
  const Decoded decoded = decode(R"("a\u002ab\t\"\\\U0001F600c")");
  CHECK(decoded.text.text == "a*b\t\"\\\U0001F600c");
  CHECK(behind(decoded, 0, 1) == "a");
  CHECK(behind(decoded, 1, 2) == R"(\u002a)");
  CHECK(behind(decoded, 2, 3) == "b");
  CHECK(behind(decoded, 3, 4) == R"(\t)");
  CHECK(behind(decoded, 5, 6) == R"(\\)");
  CHECK(behind(decoded, 6, 10) == R"(\U0001F600)");
  CHECK(behind(decoded, 10, 11) == "c");
  CHECK(behind(decoded, 0, 11) == R"(a\u002ab\t\"\\\U0001F600c)");
}

TEST_CASE("literal strings have no escapes", "[parse]") {
  const Decoded decoded = decode(R"('\theta')");
  CHECK(decoded.text.text == "\\theta");
  CHECK(behind(decoded, 1, 2) == "t");
}

TEST_CASE("multi-line strings lose their first line end", "[parse]") {
  CHECK(decode("\"\"\"\nab\nc\"\"\"").text.text == "ab\nc");
  CHECK(decode("'''\r\na\\b\r\nc'''").text.text == "a\\b\nc");
  CHECK(decode("\"\"\"a\"\"\"\"\"").text.text == "a\"\"");
  CHECK(decode("''''''").text.text.empty());
}

TEST_CASE("a backslash at the line end removes the white space after it", "[parse]") {
  const Decoded decoded = decode("\"\"\"a + \\  \n\n   b\"\"\"");
  CHECK(decoded.text.text == "a + b");
  CHECK(behind(decoded, 4, 5) == "b");
  CHECK(behind(decoded, 3, 4) == " ");
}

TEST_CASE("the empty span at the end of the text is just after the last character", "[parse]") {
  const Decoded decoded = decode("\"\"\"x\\\n   \"\"\"");
  const Span nothing = decoded.text.span(1, 1);
  CHECK(nothing.begin == 7);
  CHECK(nothing.end == 7);
  const Decoded empty = decode("\"\"");
  CHECK(empty.text.span(0, 0).begin == 4);
}

TEST_CASE("strings decode as toml++ decodes them", "[parse]") {
  CHECK(rc::check("one decoder, another decoder", [] {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
        "x", "é", "\\t", "\\\"", "\\\\", "\\u00e9", "\\U0001F600", " ", "'", "π", "\\n"));
    std::string token = "\"";
    for (const std::string& piece : pieces) token += piece;
    token += '"';
    const toml::table table = toml::parse("v =" + token);
    RC_ASSERT(decode(token).text.text == *table["v"].value<std::string>());
  }));
}
