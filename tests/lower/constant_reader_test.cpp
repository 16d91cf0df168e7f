#include "support/constant_reader.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("constants are read in the form that the graph gives them") {
  struct Row {
    const char* text;
    const char* form;
  };
  const Row row = GENERATE(values<Row>({{"pi*1/2", "1/2*pi"},
                                        {"2/4", "1/2"},
                                        {"exp(1)+cos(1)-1", "-1 + cos(1) + exp(1)"},
                                        {"-log(1/2)", "-log(1/2)"},
                                        {"sqrt(8)/2", "1/2*sqrt(8)"},
                                        {"sqrt(9/4)", "3/2"}}));
  const auto constant = test::read_constant(row.text);
  REQUIRE(constant);
  CHECK(text_of(constant->form) == row.form);
}

TEST_CASE("what is no constant is not read") {
  CHECK_FALSE(test::read_constant("x"));
  CHECK_FALSE(test::read_constant("1/0"));
  CHECK_FALSE(test::read_constant("2^pi"));
  CHECK_FALSE(test::read_constant("sin(1"));
  CHECK_FALSE(test::read_constant("cos(1, 2)"));
}
