// The rules of fold_expression that are the same for all equations with real values.
#pragma once

#include "elgen/real.hpp"
#include "texts/fold_expression.hpp"

namespace elgen::test {

struct RealRules {
  using Value = Real;

  static Real number(const cln::cl_RA& x) { return Real(x); }
  static Real negate(const Real& x) { return -x; }
  static Real add(const Real& x, const Real& y) { return x + y; }
  static Real multiply(const Real& x, const Real& y) { return x * y; }
  static Real divide(const Real& x, const Real& y) { return x / y; }
  static Real square_root(const Real& x) { return sqrt(x); }
  static Real call(const FunctionRow& row, const Real& x, const Real& y) {
    return interpreter::call(row.id, x, y);
  }
};

}  // namespace elgen::test
