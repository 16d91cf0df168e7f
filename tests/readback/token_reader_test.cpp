// What should stand in a text, and what is said where it does not.
#include "readback/token_reader.hpp"

#include <catch2/catch.hpp>

namespace elgen {
namespace {

/// The message of what `read` finds wrong.
template <class Read>
std::string said(const std::string& text, const Read& read) {
  const SourcePointer source = make_source("text", text);
  TokenReader tokens(*source);
  try {
    read(tokens);
  } catch (const Mistake& mistake) {
    return mistake.diagnostic.message;
  }
  return "";
}

}  // namespace

TEST_CASE("tokens are expected one after another") {
  CHECK(said("a + 1", [](TokenReader& t) {
          t.expect("a");
          t.expect_code("+ 1");
          t.expect_end();
        }).empty());
  CHECK(said("a + 1", [](TokenReader& t) { t.expect_code("a - 1"); }) == "`+` instead of `-`");
  CHECK(said("a", [](TokenReader& t) { t.expect_code("a b"); }) ==
        "the end of the file instead of `b`");
  CHECK(said("a b", [](TokenReader& t) {
          t.name();
          t.expect_end();
        }) == "`b` instead of the end of the file");
}

TEST_CASE("integers are decimal") {
  CHECK(said("12", [](TokenReader& t) { CHECK(t.integer() == 12); }).empty());
  for (const char* text : {"012", "1.5", "x", "99999999999", "1u"}) {
    CHECK_FALSE(said(text, [](TokenReader& t) { (void)t.integer(); }).empty());
  }
}

TEST_CASE("a message names the function and the place") {
  const SourcePointer source = make_source("file.hpp", "a\n  b");
  TokenReader tokens(*source);
  tokens.set_function("gravity");
  tokens.expect("a");
  try {
    tokens.expect("c");
    FAIL("b is no c");
  } catch (const Mistake& mistake) {
    CHECK(format({mistake.diagnostic}).find("file.hpp:2:3: error[E915]: `gravity`: `b`") == 0);
  }
}

TEST_CASE("the comments before a token are told") {
  const SourcePointer source = make_source("text", "// one\na // two\n// three\nb");
  TokenReader tokens(*source);
  CHECK(tokens.comments() == std::vector<std::string_view>{"// one"});
  tokens.advance();
  CHECK(tokens.comments() == std::vector<std::string_view>{"// two", "// three"});
}

}  // namespace elgen
