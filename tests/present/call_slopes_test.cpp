// call_slopes: derivatives in closed form, by the arithmetic that they are made with.
#include "present/call_slopes.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

/// Functions of x, or of x and y, and their slopes.
struct Calls {
  Algebra algebra = {};
  Arithmetic arithmetic{algebra};
  Value x = arithmetic.leaf(Opcode::coordinate, 0);
  Value y = arithmetic.leaf(Opcode::coordinate, 1);
  Value one = fraction_of(cln::cl_RA(1));

  Value call(FunctionId function) { return arithmetic.call(function, x, y); }
  Value square(const Value& value) { return arithmetic.power(value, 2); }

  std::vector<Value> slopes_of(FunctionId function) {
    const Fraction form = call(function).value();
    const Atom atom = algebra.atoms[form.numerator.begin()->first.at(0).atom];
    return call_slopes(arithmetic, atom, form);
  }

  bool has_slopes(FunctionId function, const std::vector<Value>& expected) {
    const std::vector<Value> slopes = slopes_of(function);
    if (slopes.size() != expected.size()) return false;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const Value difference = arithmetic.subtract(slopes[i], expected[i]);
      if (!difference || !difference->numerator.empty()) return false;
    }
    return true;
  }
};

}  // namespace

TEST_CASE_METHOD(Calls, "slopes are those of the table of functions") {
  const Value squares = arithmetic.add(square(x), square(y));
  CHECK(has_slopes(FunctionId::tanh, {arithmetic.subtract(one, square(call(FunctionId::tanh)))}));
  CHECK(has_slopes(FunctionId::exp, {call(FunctionId::exp)}));
  CHECK(has_slopes(FunctionId::log, {arithmetic.divide(one, x)}));
  CHECK(has_slopes(FunctionId::sinh, {call(FunctionId::cosh)}));
  CHECK(has_slopes(FunctionId::atan, {arithmetic.divide(one, arithmetic.add(one, square(x)))}));
  CHECK(has_slopes(FunctionId::atan2, {arithmetic.divide(y, squares),
                                       arithmetic.negate(arithmetic.divide(x, squares))}));
  CHECK_FALSE(has_slopes(FunctionId::exp, {call(FunctionId::sinh)}));
}

TEST_CASE_METHOD(Calls, "functions with kinks have none") {
  CHECK(slopes_of(FunctionId::abs).size() == 1);
  CHECK_FALSE(slopes_of(FunctionId::abs).front());
  CHECK(slopes_of(FunctionId::max).size() == 2);
  for (const Value& slope : slopes_of(FunctionId::max)) CHECK_FALSE(slope);
}
