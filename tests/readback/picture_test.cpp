// A template is what stands in a file, with holes.
#include "readback/picture.hpp"

#include <catch2/catch.hpp>

namespace elgen {

TEST_CASE("holes with one text are filled, comments are left out") {
  const Picture picture("c99/kinked.h.mustache", {{"scalar", "double"}, {"namespace", "arm"}});
  const std::vector<PictureElement>& elements = picture.elements();
  REQUIRE(elements.size() > 5);
  CHECK(elements[0].token.text == "static");
  CHECK(elements[2].token.text == "double");
  CHECK(elements[3].token.text == "arm_sign_of");
}

TEST_CASE("a section is read as long as it begins") {
  const Picture picture("c99/parts_of_function.h.mustache", {{"scalar", "double"}});
  const SourcePointer source = make_source(
      "text", "typedef struct W { double a; double b; } W; void one() { } void two() { }");
  TokenReader tokens(*source);
  std::string read;
  HoleReaders readers;
  readers.holes["workspace"] = [&] { read += tokens.name(); };
  readers.holes["line"] = [&] { read += tokens.name(); };
  readers.holes["signature"] = [&] {
    tokens.expect_code("void"), read += tokens.name(), tokens.expect_code("()");
  };
  readers.holes["body"] = [&] { read += ";"; };
  readers.sections["part"] = [&] { return tokens.at("void"); };
  read_picture(picture, readers, tokens);
  CHECK(read == "WabWone;two;");
}

TEST_CASE("what the picture does not show is a mistake") {
  const Picture picture("c99/kinked.h.mustache", {{"scalar", "double"}, {"namespace", "arm"}});
  const SourcePointer source = make_source("text", "static inline double arm_sign_of(double y)");
  TokenReader tokens(*source);
  CHECK_THROWS_AS(read_picture(picture, {}, tokens), Mistake);
  CHECK_THROWS_AS(Picture("c99/none.mustache", {}), std::logic_error);
}

}  // namespace elgen
