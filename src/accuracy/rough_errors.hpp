// Rough errors: the running errors of running_errors.hpp in double instead of 64 digits.
//
// Where nothing but the last digits of a value is lost, they are right within a factor of two on
// every machine: rounding and libm move them by a few u. Where an operand is divided by, or rooted,
// that has hardly a digit left, they are no number.
#pragma once

#include "elgen/evaluate.hpp"

namespace elgen {

struct RoughError {
  double value = 0;
  double error = 0;  ///< in u = 2^-53; not a number where double does not tell
};

/// The rules of fold.hpp. The leaves are given exactly.
struct RoughRules {
  const Arguments<double>& point;

  [[nodiscard]] RoughError constant(const Constant& constant) const;
  [[nodiscard]] RoughError leaf(Opcode kind, std::uint32_t number) const {
    return {leaf_of(point, kind, number), 0};
  }
  [[nodiscard]] RoughError negate(const RoughError& x) const { return {-x.value, x.error}; }
  [[nodiscard]] RoughError add(const RoughError& x, const RoughError& y) const;
  [[nodiscard]] RoughError subtract(const RoughError& x, const RoughError& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] RoughError multiply(const RoughError& x, const RoughError& y) const;
  [[nodiscard]] RoughError divide(const RoughError& x, const RoughError& y) const;
  [[nodiscard]] RoughError square_root(const RoughError& x) const;
  [[nodiscard]] RoughError call(FunctionId function, const RoughError& x,
                                const RoughError& y) const;
};

}  // namespace elgen
