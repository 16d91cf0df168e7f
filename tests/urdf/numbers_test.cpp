// The numbers of a URDF file. Sums of these numbers omit 0, products omit 1.
#include "urdf/numbers.hpp"

#include <catch2/catch.hpp>

#include "urdf/draft.hpp"
#include "urdf/urdf_testing.hpp"

namespace elgen::test {

namespace {

Result<urdf::FileNumber> read(const SourcePointer& source) {
  const Span span{source.get(), 0, static_cast<std::uint32_t>(source->text.size())};
  return urdf::read_decimal(span, {});
}

std::string spelled(const std::string& text) { return read(make_source("r.urdf", text))->text; }

std::string refused(const std::string& text) {
  const SourcePointer source = make_source("r.urdf", text);
  return messages(read(source).diagnostics);
}

}  // namespace

TEST_CASE("the digits of a number are kept, and its spelling is TOML's") {
  CHECK(spelled("0.333") == "0.333");
  CHECK(spelled("-1.5707963267948966192313") == "-1.5707963267948966192313");
  CHECK(spelled("+.5") == "0.5");
  CHECK(spelled("5.") == "5");
  CHECK(spelled("007.10") == "7.10");
  CHECK(spelled("1E+05") == "1e05");
  CHECK(spelled("-2.5e-3") == "-2.5e-3");
  for (const char* zero : {"0", "-0", "0.000", "-.0", "0e5", "00"}) CHECK(spelled(zero) == "0");
}

TEST_CASE("the value of a number is exact") {
  CHECK(read(make_source("r.urdf", "-0.1"))->value == -cln::cl_RA(1) / 10);
  CHECK(read(make_source("r.urdf", "25E-1"))->value == cln::cl_RA(5) / 2);
  CHECK(read(make_source("r.urdf", "0"))->is_zero());
}

TEST_CASE("a sign negates digits and value") {
  const urdf::FileNumber one = urdf::make_file_number(1);
  CHECK(urdf::negate_number(one).text == "-1");
  CHECK(urdf::negate_number(one).value == -1);
  CHECK(urdf::negate_number(urdf::negate_number(one)).text == "1");
  CHECK(urdf::negate_number(urdf::make_file_number(0)).text == "0");
}

TEST_CASE("anything but a finite decimal is refused") {
  CHECK(refused("1,5") == "E804 1:1 `1,5` is not a decimal number\n");
  CHECK(refused("0x10") == "E804 1:1 `0x10` is not a decimal number\n");
  CHECK(refused("1e") == "E804 1:1 `1e` is not a decimal number\n");
  CHECK(refused(".") == "E804 1:1 `.` is not a decimal number\n");
  CHECK(refused("--1") == "E804 1:1 `--1` is not a decimal number\n");
  CHECK(refused("nan") == "E804 1:1 `nan` is not finite\n");
  CHECK(refused("-INF") == "E804 1:1 `-INF` is not finite\n");
  CHECK(refused("${pi/2}") ==
        "E804 1:1 `${pi/2}` is not a decimal number | " + std::string(urdf::xacro_remedy) + "\n");
  CHECK(refused("1e99999") ==
        "E904 1:1 decimal exponent `99999` is beyond ±400 | `--limit decimal_exponent=N` raises "
        "the limit\n");
}

TEST_CASE("words are separated by blanks") {
  const SourcePointer source = make_source("r.urdf", " 1 \t-2\n3 ");
  const auto words = urdf::word_spans({source.get(), 0, 9});
  REQUIRE(words.size() == 3);
  CHECK(covered_text(words[0]) == "1");
  CHECK(covered_text(words[1]) == "-2");
  CHECK(covered_text(words[2]) == "3");
}

TEST_CASE("a sum omits 0 and writes minus signs") {
  CHECK(urdf::sum_text("0", "q") == "q");
  CHECK(urdf::sum_text("x", "0") == "x");
  CHECK(urdf::sum_text("x", "q") == "x + q");
  CHECK(urdf::sum_text("x", "-q") == "x - q");
  CHECK(urdf::sum_text("x", "-(a*q + b)") == "x - (a*q + b)");
}

TEST_CASE("a product omits 1 and puts sums in brackets") {
  CHECK(urdf::product_text("0", "q") == "0");
  CHECK(urdf::product_text("1", "q") == "q");
  CHECK(urdf::product_text("-1", "q") == "-q");
  CHECK(urdf::product_text("0.6", "q") == "0.6*q");
  CHECK(urdf::product_text("0.6", "a*q + b") == "0.6*(a*q + b)");
  CHECK(urdf::product_text("-0.6", "-q") == "-0.6*(-q)");
}

TEST_CASE("a quotient omits 1 and puts sums in brackets") {
  CHECK(urdf::quotient_text("0", "l") == "0");
  CHECK(urdf::quotient_text("q + b", "1") == "q + b");
  CHECK(urdf::quotient_text("-0.7*q", "l") == "-0.7*q/l");
  CHECK(urdf::quotient_text("q + b", "l") == "(q + b)/l");
  CHECK(urdf::quotient_text("-q + b", "l") == "(-q + b)/l");
  CHECK(urdf::quotient_text("0.7*(q + b)", "l") == "0.7*(q + b)/l");
}

TEST_CASE("a sign negates the operand after it") {
  CHECK(urdf::negated_text("q") == "-q");
  CHECK(urdf::negated_text("-q") == "q");
  CHECK(urdf::negated_text("a*q + b") == "-(a*q + b)");
  CHECK(urdf::negated_text("-q + b") == "-(-q + b)");
  CHECK(urdf::negated_text("0") == "0");
}

TEST_CASE("a coupling is a position and a rate") {
  const urdf::Coupling coupling{"q", "ratio", "offset"};
  CHECK(coupling.position_text() == "ratio*q + offset");
  CHECK(coupling.rate_text() == "ratio*dot(q)");
  CHECK(urdf::Coupling{"q"}.position_text() == "q");
  CHECK(urdf::Coupling{"q", "-1", "b"}.position_text() == "-q + b");
  CHECK(urdf::Coupling{"q", "0", "b"}.position_text() == "b");
}

}  // namespace elgen::test
