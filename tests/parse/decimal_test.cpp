// Decimals are exact, limits are checked before any big arithmetic, and printed decimals are read
// back.
#include "parse/decimal.hpp"

#include <cln/integer.h>
#include <rapidcheck.h>

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

cln::cl_RA value_of(std::string_view text) { return decimal_value(decimal_parts(text)); }

std::optional<Code> limit_of(std::string_view text) {
  const auto hit = find_exceeded_limit(decimal_parts(text), Limits{});
  return hit ? std::optional(hit->code) : std::nullopt;
}

cln::cl_RA ratio(int numerator, int denominator) {
  return cln::cl_RA(numerator) / cln::cl_RA(denominator);
}

}  // namespace

TEST_CASE("numbers end according to the grammar", "[parse]") {
  struct Row {
    std::string_view text;
    std::size_t end;
    bool well_formed;
  };
  const auto row = GENERATE(values<Row>({
      {"12", 2, true},
      {"0.5*x", 3, true},
      {"1e-3", 4, true},
      {"2exp(x)", 1, true},  // 2*exp(x) without the operator
      {"2e3x", 3, true},
      {"1e", 2, false},
      {"1e+", 3, false},
      {"1.", 2, false},
      {".5", 2, false},
      {"..", 2, false},
      {"1..2", 4, false},
      {"1.2.3", 5, false},
      {"1e5e5", 5, false},
      {"1_000", 5, false},
      {"0x10", 4, false},
      {"1e5.5", 5, false},
  }));
  INFO(row.text);
  const NumberExtent extent = number_extent(row.text, 0);
  CHECK(extent.end == row.end);
  CHECK(extent.well_formed == row.well_formed);
}

TEST_CASE("decimals are exact rationals", "[parse]") {
  CHECK(value_of("0.1") == ratio(1, 10));
  CHECK(value_of("010") == 10);
  CHECK(value_of("9.80665") == ratio(980665, 100000));
  CHECK(value_of("1_000.5") == ratio(2001, 2));
  CHECK(value_of("12.5e-1") == ratio(5, 4));
  CHECK(value_of("2E+3") == 2000);
  CHECK(value_of("0.000e5") == 0);
  CHECK(value_of("9007199254740993") == cln::cl_I("9007199254740993"));
}

TEST_CASE("limits hold for digits and exponents, at the limit and one past it", "[parse]") {
  CHECK_FALSE(limit_of(std::string(400, '7')));
  CHECK(limit_of(std::string(401, '7')) == Code::E903);
  CHECK_FALSE(limit_of("0." + std::string(400, '7')));
  CHECK(limit_of("1." + std::string(400, '7')) == Code::E903);
  CHECK_FALSE(limit_of("1e400"));
  CHECK_FALSE(limit_of("1e-400"));
  CHECK_FALSE(limit_of("1e00000400"));
  CHECK(limit_of("1e401") == Code::E904);
  CHECK(limit_of("1e-401") == Code::E904);
  CHECK(limit_of("1e99999999999999999999999999") == Code::E904);
}

TEST_CASE("decimal text is the shortest literal", "[parse]") {
  CHECK(decimal_text(0) == "0");
  CHECK(decimal_text(-5) == "-5");
  CHECK(decimal_text(ratio(1, 10)) == "0.1");
  CHECK(decimal_text(ratio(-5, 4)) == "-1.25");
  CHECK(decimal_text(ratio(1, 3)) == "1/3");
  CHECK(decimal_text(ratio(-1, 6)) == "-1/6");
  CHECK(decimal_text(value_of("1.5e-400")) == "15e-401");
}

TEST_CASE("decimal text is read back to the same value", "[parse]") {
  CHECK(rc::check("text and value", [] {
    const auto digits = *rc::gen::inRange<std::int64_t>(0, 1'000'000'000'000);
    const auto exponent = *rc::gen::inRange(-60, 60);
    const std::string literal = std::to_string(digits) + "e" + std::to_string(exponent);
    const cln::cl_RA value = value_of(literal);
    RC_ASSERT(value_of(decimal_text(value)) == value);
  }));
}
