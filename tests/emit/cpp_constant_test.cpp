// Tests the text of cpp_constant for exact and irrational numbers, and the names of constants.
#include "emit/code/cpp_constant.hpp"

#include <cln/float.h>
#include <cln/rational.h>

#include <catch2/catch.hpp>
#include <set>

#include "fixture.hpp"
#include "support/graph_reader.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;
using cln::cl_RA;

namespace {

cl_R pi() { return cln::pi(cln::float_format(100)); }

}  // namespace

TEST_CASE("a number that float holds exactly is one literal") {
  CHECK(cpp_constant(0) == "constant<Scalar>(0.0)");
  CHECK(cpp_constant(cl_RA(-1) / 2) == "-constant<Scalar>(0.5)");
  CHECK(is_short_constant(1000));
}

TEST_CASE("other numbers have a literal of each type and an exact fraction") {
  CHECK(cpp_constant(cl_RA(981) / 100) == "constant<Scalar>(9.81F, 9.81, 9.81L, {981}, {100})");
  CHECK(cpp_constant(cl_RA(1) / 3) ==
        "constant<Scalar>(0.33333334F, 0.3333333333333333, "
        "0.3333333333333333333333333333333333333333L, {1}, {3})");
  CHECK(cpp_constant(cln::cl_I("10267495893")) ==
        "constant<Scalar>(10267495893.0F, 10267495893.0, 10267495893.0L, {10267, 495893}, {1})");
  CHECK_FALSE(is_short_constant(cl_RA(1) / 3));
}

TEST_CASE("decimal powers are exponents, and a number out of range has no literal") {
  CHECK(cpp_constant(power_of_ten(-300)) ==
        "constant<Scalar>(detail::OutOfRange{}, 1e-300, 1e-300L, {1}, {1}, -300)");
  CHECK(cpp_constant(3 * power_of_ten(400)) ==
        "constant<Scalar>(detail::OutOfRange{}, detail::OutOfRange{}, 3e400L, {3}, {1}, 400)");
}

TEST_CASE("an irrational number is a fraction of 66 digits") {
  const std::string text = cpp_constant(pi());
  CHECK(mentions(text,
                 "(3.1415927F, 3.141592653589793, 3.141592653589793238462643383279502884197L, "
                 "{314159, 265358, 979323, 846264,"));
  CHECK(mentions(text, "{1}, -65)"));
}

TEST_CASE("names of constants: numbers, multiples of pi and roots are spelled out") {
  struct Row {
    const char* text;
    const char* name;
  };
  const Row row = GENERATE(values<Row>({{"981/100", "number_9p81"},
                                        {"1/3", "number_1_3"},
                                        {"pi", "number_pi"},
                                        {"2*pi", "number_2_pi"},
                                        {"1/2*sqrt(3)", "number_1_2_sqrt_3"}}));
  const auto constant = read_constant(row.text);
  REQUIRE(constant);
  CHECK(constant_name(*constant) == row.name);
  CHECK(constant_name(rational_constant(power_of_ten(-300))) == "number_1em300");
}

TEST_CASE("names of other constants are unique hashes of their form") {
  std::set<std::string> names;
  for (const char* text : {"2 + pi", "2*(1 + pi)", "2*pi", "1/2 + pi", "1/2*pi", "2 + sqrt(3)",
                           "2*sqrt(3)", "cos(1) + sin(1)", "cos(1)*sin(1)", "cos(3/10)"}) {
    const auto constant = read_constant(text);
    REQUIRE(constant);
    CHECK(names.insert(constant_name(*constant)).second);
  }
  const cl_RA wide = cln::cl_I("123456789012345678901234567890") /
                     cl_RA(cln::cl_I("99999999999999999999999999977"));
  CHECK(constant_name(rational_constant(wide)).size() == std::string("number_").size() + 8);
}
