// Malformed TOML: the place, the message, and a hint where the mistake is a usual one.
#include "parse/toml_error.hpp"

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;

TEST_CASE("malformed TOML is reported once, where it is", "[parse]") {
  struct Row {
    std::string input;
    std::string place;
    std::string message;
    std::string hint;
  };
  const std::string quotes = "texts and expressions are written in quotes";
  const std::string three = "a string over several lines has three quotes at each end";
  const auto row = GENERATE_COPY(values<Row>({
      {"a = 1\nb = \"x\nc = 3", "E101 2:7", "string is not closed", three},
      {"a = \"x", "E101 1:7", "string is not closed", three},
      {"a = 1/2", "E101 1:6", "expected digit, saw `/`", quotes},
      {"a = pi", "E101 1:5", "could not determine value type", quotes},
      {"a = 1\na = 2", "E101 2:1", "cannot redefine existing integer `a`",
       "give one of them another name"},
      {"[a]\n[a]", "E101 2:1", "cannot redefine existing table `a`", ""},
      {"a = 1e400", "E109 1:5", "`1e400` is wider than TOML's numbers",
       "write it as a string, in quotes"},
      {"a = [-1e999, 2]", "E109 1:6", "`-1e999` is wider than TOML's numbers",
       "write it as a string, in quotes"},
      {"a = 12345678901234567890", "E109 1:5",
       "`12345678901234567890` is wider than TOML's numbers", "write it as a string, in quotes"},
  }));
  INFO(row.input);
  const SourcePointer source = make_source("test", row.input);
  const auto result = parse_model(source, {});
  CHECK(testing::places(result.diagnostics) == row.place);
  CHECK(result.diagnostics.at(0).message == row.message);
  CHECK(result.diagnostics.at(0).hint == row.hint);
}

TEST_CASE("numbers of more digits than toml++ reads are told so", "[parse]") {
  const std::string digits(200, '7');
  CHECK(testing::model_answer("a = " + digits) == "E109 1:5");
  CHECK(testing::model_answer("a = [-0." + digits + "]") == "E109 1:6");
}

TEST_CASE("decimal tokens are told from other numbers", "[parse]") {
  CHECK(is_decimal_token("12"));
  CHECK(is_decimal_token("-1_000.5e+3"));
  CHECK(is_decimal_token("+0"));
  CHECK_FALSE(is_decimal_token("0x1E"));
  CHECK_FALSE(is_decimal_token("0b1"));
  CHECK_FALSE(is_decimal_token("inf"));
  CHECK_FALSE(is_decimal_token("-nan"));
  CHECK_FALSE(is_decimal_token("1979-05-27T07:32:00Z"));
  CHECK_FALSE(is_decimal_token(""));
}
