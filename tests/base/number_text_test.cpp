// Numbers as text: exact for rationals, thirty digits for the rest, in any locale.
#include "base/number_text.hpp"

#include <cln/cln.h>

#include <catch2/catch.hpp>
#include <clocale>

namespace elgen {
namespace {

TEST_CASE("rationals are printed exactly") {
  CHECK(number_text(0) == "0");
  CHECK(number_text(-7) == "-7");
  CHECK(number_text(cln::cl_RA(-1) / 3) == "-1/3");
  CHECK(number_text(cln::expt(cln::cl_RA(10), 25)) == "10000000000000000000000000");
}

TEST_CASE("floats are printed with thirty digits and their exponent") {
  const cln::float_format_t format = cln::float_format(100);
  CHECK(number_text(cln::pi(format)) == "3.14159265358979323846264338328e0");
  CHECK(number_text(-cln::pi(format) / 1000) == "-3.14159265358979323846264338328e-3");
  CHECK(number_text(cln::sqrt(cln::cl_float(2, format)) * 1000000) ==
        "1.41421356237309504880168872421e6");
  CHECK(number_text(cln::cl_float(1, format)) == "1.00000000000000000000000000000e0");
}

TEST_CASE("what rounds up to a power of ten takes its exponent") {
  const cln::float_format_t format = cln::float_format(100);
  const cln::cl_R below_ten = cln::cl_float(10 - cln::expt(cln::cl_RA(10), -60), format);
  REQUIRE(below_ten < 10);
  CHECK(number_text(below_ten) == "1.00000000000000000000000000000e1");
  CHECK(number_text(-below_ten / 1000) == "-1.00000000000000000000000000000e-2");
  const cln::cl_RA nines = 10 - cln::expt(cln::cl_RA(10), -29);
  CHECK(number_text(cln::cl_float(nines, format)) == "9.99999999999999999999999999999e0");
}

TEST_CASE("the locale does not show") {
  const char* previous = std::setlocale(LC_ALL, nullptr);
  const std::string saved = previous == nullptr ? "C" : previous;
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(number_text(cln::cl_RA(123456789) / 10) == "123456789/10");
  std::setlocale(LC_ALL, saved.c_str());
}

}  // namespace
}  // namespace elgen
