#include "inspect/readable.hpp"

#include <cln/float.h>

#include <catch2/catch.hpp>

using namespace elgen;

using cln::cl_R;
using cln::cl_RA;

TEST_CASE("integers and short fractions are printed as such") {
  CHECK(readable(0) == "0");
  CHECK(readable(-1) == "-1");
  CHECK(readable(cl_RA(1) / cl_RA(3)) == "1/3");
  CHECK(readable(cl_RA(-7) / cl_RA(2)) == "-7/2");
  const cln::cl_F third = cln::cl_float(cl_RA(1) / cl_RA(3), cln::float_format(60));
  CHECK(readable(third) == "1/3");
}

TEST_CASE("other numbers are printed with five digits") {
  const cln::cl_F two = cln::cl_float(cl_RA(2), cln::float_format(60));
  CHECK(readable(cln::sqrt(two)) == "1.4142");
  CHECK(readable(cl_RA(1) / cl_RA(1009)) == "0.00099108");
}

TEST_CASE("what sixty digits leave of zero is zero") {
  CHECK(readable(cln::expt(cl_R(10), -41)) == "0");
  CHECK(readable(cln::expt(cl_R(10), -20)) == "1e-20");
}
