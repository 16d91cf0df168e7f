// literal: what stays as written, and what is rounded.
#include "emit/literal.hpp"

#include <cln/rational.h>

#include <catch2/catch.hpp>

using namespace elgen;
using cln::cl_RA;

TEST_CASE("decimals stay, other numbers are the shortest that round to the same") {
  CHECK(scalar_literal(cl_RA(981) / 100, ScalarKind::single_precision) == "9.81");
  CHECK(scalar_literal(1000, ScalarKind::double_precision) == "1000.0");
  CHECK(scalar_literal(cl_RA(1) / 3, ScalarKind::single_precision) == "0.33333334");
  CHECK(scalar_literal(cl_RA(1) / 3, ScalarKind::double_precision) == "0.3333333333333333");
}
