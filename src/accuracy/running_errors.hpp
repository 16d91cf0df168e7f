// Running errors: how far rounding takes a value, to first order, in u.
//
// Of each instruction the error is that of its operands, times how much the instruction makes of
// it, and one rounding: its magnitude. N. J. Higham, Accuracy and Stability of Numerical
// Algorithms, 2nd ed., section 3.3.
#pragma once

#include "accuracy/bounded.hpp"

namespace elgen {

/// A value in 64 digits with the error of its rounding.
struct Running {
  Real value = {};
  Real error = {};  ///< in u; undefined where the value is
};

[[nodiscard]] std::vector<Real> values_of(const std::vector<Running>& all);

/// The leaves are given exactly, or each is rounded once, so that at an angle of 1e6 both cos(q +
/// 1) and cos(q)*cos(1) - sin(q)*sin(1) have as few digits as the angle itself.
enum class Leaves : std::uint8_t { exact, rounded };

[[nodiscard]] LeafValues<Running> running_leaves(const Arguments<double>& point, Leaves leaves);

/// The rules of fold.hpp.
struct RunningErrorRules {
  LeafValues<Running> leaves;
  const Rounding& rounding = elgen::rounding<double>();

  /// Constants that are not binary are rounded once.
  [[nodiscard]] Running constant(const Constant& constant) const;
  [[nodiscard]] Running leaf(Opcode kind, std::uint32_t number) const {
    return leaf_of(leaves, kind, number);
  }
  [[nodiscard]] Running negate(const Running& x) const { return {-x.value, x.error}; }
  [[nodiscard]] Running add(const Running& x, const Running& y) const;
  [[nodiscard]] Running subtract(const Running& x, const Running& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] Running multiply(const Running& x, const Running& y) const;
  [[nodiscard]] Running divide(const Running& x, const Running& y) const;
  [[nodiscard]] Running square_root(const Running& x) const;
  [[nodiscard]] Running call(FunctionId function, const Running& x, const Running& y) const;
};

}  // namespace elgen
