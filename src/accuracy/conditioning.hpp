// Conditioning: the error K of a value x, in units of roundoff u, if all inputs are rounded once:
//
//     K = sum |z dx/dz|      over inputs z and parameters z
//
// K is the same for every formula for x. If the error of a formula is far beyond u (|x| + K), the
// formula loses digits that another formula for x can keep. K includes no error of literals, so
// pi/2 - atan(z) counts as lossy at large z: atan2(1, z) keeps all digits.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"

namespace elgen {

/// The largest error, in units of u (|x| + K), that the rounding of a few operations explains. A
/// formula with a larger error loses digits.
inline constexpr double tolerated_loss = 64;

/// Two losses count as equal if their quotient is at most this; then the cheaper formula is chosen.
inline constexpr double loss_equality_factor = 8;

/// The operands of an instruction as dual numbers. `seed_operand` has tangent 1, all others 0.
template <class Number>
struct DualOperands {
  const std::vector<Number>& values;
  std::uint32_t seed_operand;

  [[nodiscard]] Dual<Number> operator[](std::uint32_t at) const {
    return {values[at], ScalarTraits<Number>::from_real(at == seed_operand ? 1 : 0)};
  }
};

/// The derivative of instruction `i` by `operand`, one of its operands. `values`: the values of all
/// earlier instructions. Number: Real or double.
template <class Number>
[[nodiscard]] Number slope_by_operand(const Program& program, const Instruction& i,
                                      std::uint32_t operand, const std::vector<Number>& values) {
  static const Arguments<Dual<Number>> no_leaves;
  const interpreter::NumberRules<Dual<Number>> rules{no_leaves};
  return fold_instruction(rules, program, i, DualOperands<Number>{values, operand}).slope;
}

/// K of the values of a function at one point.
class Conditioning {
 public:
  /// `values`: the values of all instructions. `parameters`: marks the constants of the program
  /// that count as parameters; empty if all are literals. Program and function must outlive this
  /// object. Cost: two operations of dual numbers per instruction.
  Conditioning(const Program& program, const Function& function, std::vector<Real> values,
               std::vector<bool> parameters = {});

  /// K of an instruction; undefined if a derivative is undefined. K is computed in double, to four
  /// digits and with an error bound; if the bound is too large, K is computed in Real. Cost: ten
  /// operations of double, and two of Real if needed, for each earlier instruction.
  [[nodiscard]] Real absolute_condition(std::uint32_t instruction) const;

 private:
  [[nodiscard]] Real slope(const Instruction& i, std::uint32_t operand) const;
  [[nodiscard]] bool counts_as_input(const Instruction& i) const;

  /// The derivatives of an instruction by its operands a and b. If a and b are the same operand,
  /// `by_a` is the total derivative.
  template <class Number>
  struct Slopes {
    Number by_a = {};
    Number by_b = {};
  };

  [[nodiscard]] std::optional<double> conditioning_in_double(std::uint32_t instruction) const;

  const Program& program_;
  const Function& function_;
  std::vector<Real> values_;
  std::vector<bool> is_parameter_;
  std::vector<Slopes<Real>> slopes_ = {};
  std::vector<double> rounded_values_ = {};
  std::vector<Slopes<double>> rounded_slopes_ = {};
};

}  // namespace elgen
