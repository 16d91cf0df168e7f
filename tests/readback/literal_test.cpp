// Floating literals as compilers read them.
#include "readback/literal.hpp"

#include <catch2/catch.hpp>

namespace elgen {

TEST_CASE("a floating literal is read exactly, with its suffix") {
  const auto literal = read_literal("9.81F");
  REQUIRE(literal);
  CHECK(literal->value == cln::cl_RA(981) / 100);
  CHECK(literal->suffix == 'F');
  CHECK(read_literal("1e-3")->value == cln::cl_RA(1) / 1000);
  CHECK(read_literal("0.0")->suffix == '\0');
}

TEST_CASE("what is no decimal floating literal is none") {
  for (const char* text : {"", "2", "2F", "1.", ".5", "1.5e", "0x1p3", "1.5FF", "1.5.2", "1'0.5"}) {
    INFO(text);
    CHECK_FALSE(read_literal(text));
  }
  CHECK_FALSE(read_literal("1e99999999"));
}

TEST_CASE("numbers round alike where a compiler makes the same of them") {
  const cln::cl_RA third = cln::cl_RA(1) / 3;
  CHECK(rounds_alike(read_literal("0.33333334")->value, third, ScalarKind::single_precision));
  CHECK_FALSE(rounds_alike(read_literal("0.33333337")->value, third, ScalarKind::single_precision));
  CHECK(
      rounds_alike(read_literal("0.3333333333333333")->value, third, ScalarKind::double_precision));
  CHECK_FALSE(rounds_alike(read_literal("0.33333334")->value, third, ScalarKind::double_precision));
  const std::string digits = "0." + std::string(40, '3');
  CHECK(rounds_alike(read_literal(digits)->value, third, ScalarKind::long_double));
  CHECK_FALSE(
      rounds_alike(read_literal(digits.substr(0, 41))->value, third, ScalarKind::long_double));
}

}  // namespace elgen
