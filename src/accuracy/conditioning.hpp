// Conditioning: the error of a value if all its inputs are rounded once, however it is computed:
//
//     K = sum |z dx/dz|      over inputs z and parameters z
//
// in units of u. A formula with an error far beyond u (|x| + K) loses digits that another keeps.
// Literals are exact: at large x, pi/2 - atan(x) loses digits, and atan2(1, x) keeps all.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"

namespace elgen {

/// Rounding and a few operations explain an error of this many u (|x| + K). Beyond, the formula
/// loses digits.
inline constexpr double tolerated_loss = 64;

/// Losses within this factor count as equal; then the cheaper rewriting wins.
inline constexpr double similar_losses = 8;

/// Derivatives of a function at one point: one reverse sweep for each value.
class Conditioning {
 public:
  /// `values`: of all instructions. `parameters`: marks the program's constants that count as
  /// parameters; empty if all are literals. Program and function must outlive this. Cost: two
  /// operations of dual numbers per instruction.
  Conditioning(const Program& program, const Function& function, std::vector<Real> values,
               std::vector<bool> parameters = {});

  /// K of an instruction; undefined if a derivative is. Doubles give four digits and an error
  /// bound; if the bound is too large, Real computes K. Cost: ten operations of double, and two of
  /// Real if needed, for each instruction before it.
  [[nodiscard]] Real of(std::uint32_t instruction) const;

 private:
  [[nodiscard]] Real slope(const Instruction& i, std::uint32_t operand) const;
  [[nodiscard]] bool counts_as_input(const Instruction& i) const;

  /// Slopes of an instruction by its operands; if both are one, `by_a` is the total.
  template <class Number>
  struct Slopes {
    Number by_a = {};
    Number by_b = {};
  };

  [[nodiscard]] std::optional<double> conditioning_in_double(std::uint32_t instruction) const;

  const Program& program_;
  const Function& function_;
  std::vector<Real> values_;
  std::vector<bool> parameters_;
  std::vector<Slopes<Real>> slopes_ = {};
  std::vector<double> rounded_values_ = {};
  std::vector<Slopes<double>> rounded_slopes_ = {};
};

}  // namespace elgen
