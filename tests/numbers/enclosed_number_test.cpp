// An enclosed number is exact if possible, otherwise it has an error bound. Arguments outside the
// domain of a function are rejected with a reason.
#include "numbers/enclosed_number.hpp"

#include <cln/integer.h>

#include <catch2/catch.hpp>

#include "numbers/exact_number.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;
using cln::cl_RA;

const EnclosedArithmetic few(60);
const EnclosedArithmetic many(400);

EnclosedNumber exact(const cl_RA& value) { return {value, 0}; }

EnclosedResult call(const EnclosedArithmetic& with, FunctionId function, const cl_RA& x,
                    const cl_RA& y = 0) {
  return with.call(function, exact(x), exact(y));
}

/// True if `rough`, in few digits, differs from `fine`, in many digits, by at most the error bound
/// of `rough`.
bool agree(const EnclosedResult& rough, const EnclosedResult& fine) {
  REQUIRE(rough.number);
  REQUIRE(fine.number);
  const cl_R difference = cln::rational(rough.number->value) - cln::rational(fine.number->value);
  return cln::abs(difference) <= cln::rational(rough.number->error) + power_of_ten(-300);
}

TEST_CASE("340 more digits agree within the error bound") {
  for (const FunctionRow& row : function_table()) {
    for (const cl_RA& x : {cl_RA(3) / 10, cl_RA(-7) / 9, cl_RA(9999) / 10000}) {
      if (row.id == FunctionId::log && cln::minusp(x)) continue;
      INFO(row.name);
      CHECK(agree(call(few, row.id, x, 2), call(many, row.id, x, 2)));
    }
  }
  for (const cl_RA& exponent : {cl_RA(1) / 2, cl_RA(-7) / 3, cl_RA(-5)}) {
    CHECK(agree(few.power(few.pi(), exponent), many.power(many.pi(), exponent)));
  }
}

TEST_CASE("functions propagate errors of their arguments") {
  const EnclosedNumber rough{cl_RA(7) / 10, power_of_ten(-20)};
  for (const FunctionRow& row : function_table()) {
    INFO(row.name);
    const EnclosedResult here = few.call(row.id, rough, rough);
    REQUIRE(here.number);
    for (const cl_RA& end : {power_of_ten(-20), -power_of_ten(-20)}) {
      const EnclosedResult there = call(many, row.id, cl_RA(7) / 10 + end, cl_RA(7) / 10 - end);
      CHECK(agree(here, there));
    }
  }
}

TEST_CASE("arithmetic propagates errors of its operands") {
  const cl_RA e = power_of_ten(-20);
  const cl_RA x = cl_RA(7) / 10;
  const cl_RA y = cl_RA(-2) / 9;
  const EnclosedNumber rough_x{x, e};
  const EnclosedNumber rough_y{y, 3 * e};
  for (const int sign_x : {-1, 1}) {
    for (const int sign_y : {-1, 1}) {
      const EnclosedNumber end_x = exact(x + sign_x * e);
      const EnclosedNumber end_y = exact(y + sign_y * 3 * e);
      CHECK(agree(few.sum(rough_x, rough_y), many.sum(end_x, end_y)));
      CHECK(agree(few.product(rough_x, rough_y), many.product(end_x, end_y)));
      CHECK(agree(few.reciprocal(rough_y), many.reciprocal(end_y)));
      CHECK(agree(few.power(rough_x, cl_RA(1) / 2), many.power(end_x, cl_RA(1) / 2)));
      CHECK(agree(few.power(rough_y, -3), many.power(end_y, -3)));
      CHECK(agree(few.power(rough_x, cl_RA(1) / 3), many.power(end_x, cl_RA(1) / 3)));
    }
  }
}

TEST_CASE("small values have as many significant digits as large values") {
  for (const FunctionId function :
       {FunctionId::exp, FunctionId::tanh, FunctionId::sin, FunctionId::log1p, FunctionId::expm1}) {
    const EnclosedResult value =
        call(few, function, function == FunctionId::exp ? cl_RA(-300) : power_of_ten(-300));
    REQUIRE(value.number);
    CHECK(value.number->error < cln::abs(value.number->value) * power_of_ten(-40));
  }
}

TEST_CASE("rational results stay exact") {
  CHECK(is_exact(*few.power(exact(cl_RA(4) / 9), cl_RA(1) / 2).number));
  CHECK(few.power(exact(8), cl_RA(-2) / 3).number->value == cl_RA(1) / 4);
  CHECK(is_exact(*call(few, FunctionId::exp, 0).number));
  CHECK(is_exact(*call(few, FunctionId::log, 1).number));
  CHECK(call(few, FunctionId::max, -2, 3).number->value == 3);
  CHECK(call(few, FunctionId::hypot, -3, 4).number->value == 5);
  CHECK(call(few, FunctionId::stumpff, 0, 4).number->value == cl_RA(1) / 24);
  CHECK(call(few, FunctionId::stumpff, 0, -4).number->value == cl_RA(1) / 24);
}

TEST_CASE("outside the domain the reason is reported") {
  CHECK(few.reciprocal(exact(0)).reason == NoValueReason::undefined);
  CHECK(few.reciprocal({0, 1}).reason == NoValueReason::unknown);
  CHECK(few.power(exact(0), 0).reason == NoValueReason::undefined);
  CHECK(few.power(exact(-8), cl_RA(1) / 3).reason == NoValueReason::complex);
  CHECK(few.power(exact(10), 12'000).reason == NoValueReason::too_large);
  CHECK(call(few, FunctionId::log, 0).reason == NoValueReason::undefined);
  CHECK(call(few, FunctionId::log, -1).reason == NoValueReason::complex);
  CHECK(call(few, FunctionId::log1p, -1).reason == NoValueReason::undefined);
  CHECK(call(few, FunctionId::log1p, -2).reason == NoValueReason::complex);
  CHECK(call(few, FunctionId::expm1, -100'000).number->value == -1);
  CHECK(call(few, FunctionId::expm1, 100'000).reason == NoValueReason::too_large);
  CHECK(call(few, FunctionId::stumpff, -100'000, -3).reason == NoValueReason::too_large);
  CHECK(call(few, FunctionId::stumpff, -100'000, 3).number);
  CHECK(call(few, FunctionId::asin, 1 + power_of_ten(-30)).reason == NoValueReason::complex);
  CHECK(call(few, FunctionId::asin, 1 - power_of_ten(-30)).number);
  CHECK(call(few, FunctionId::atan2, 0, 0).reason == NoValueReason::undefined);
  CHECK(call(few, FunctionId::exp, 100'000).reason == NoValueReason::too_large);
  CHECK(call(few, FunctionId::tanh, -100'000).number->value == -1);
  const EnclosedResult right_angle = many.product(many.pi(), exact(cl_RA(1) / 2));
  CHECK(many.call(FunctionId::tan, *right_angle.number, {}).reason == NoValueReason::undefined);
}

TEST_CASE("a sign is known, or known to be undecided") {
  CHECK(sign_of({0, 0}) == 0);
  CHECK(sign_of({-2, 1}) == -1);
  CHECK_FALSE(sign_of({2, 3}));
}

}  // namespace
}  // namespace elgen::test
