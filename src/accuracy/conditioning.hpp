// Conditioning: how far one rounding of everything that a value is made from takes it, however it
// is computed:
//
//     K = sum |z dx/dz|      over inputs z and parameters z
//
// in units of u. A formula whose error is far beyond u (|x| + K) loses digits that another keeps.
// Literals are exact: pi/2 - atan(x), which loses them where x is large, is atan2(1, x), which has
// them all.
#pragma once

#include <optional>
#include <vector>

#include "elgen/evaluate.hpp"
#include "numbers/dual.hpp"

namespace elgen {

/// Errors of so many u (|x| + K) are what rounding and a few operations explain: more is lost to
/// the formula.
inline constexpr double tolerated_loss = 64;

/// Losses that differ by less are alike: the cheaper rewriting is taken.
inline constexpr double similar_losses = 8;

/// Derivatives along a function at one point, by one sweep against its order for each value.
class Conditioning {
 public:
  /// `values`: those of all instructions. `parameters`: of the program's constants, those that
  /// count; empty where all are literals. Program and function outlive it. Cost: two operations of
  /// dual numbers per instruction.
  Conditioning(const Program& program, const Function& function, std::vector<Real> values,
               std::vector<bool> parameters = {});

  /// K of an instruction; undefined where a derivative is. Doubles give it to four digits, with a
  /// bound of their error, and Real where that is too large. Cost: ten operations of double, or
  /// else two of Real, for each instruction before it.
  [[nodiscard]] Real of(std::uint32_t instruction) const;

 private:
  [[nodiscard]] Real slope(const Instruction& i, std::uint32_t operand) const;
  [[nodiscard]] bool counts(const Instruction& i) const;

  /// Slopes of an instruction by its operands; by both together where they are one.
  template <class Number>
  struct Slopes {
    Number by_a = {};
    Number by_b = {};
  };

  [[nodiscard]] std::optional<double> in_doubles(std::uint32_t instruction) const;

  const Program& program_;
  const Function& function_;
  std::vector<Real> values_;
  std::vector<bool> parameters_;
  std::vector<Slopes<Real>> slopes_ = {};
  std::vector<double> rounded_values_ = {};
  std::vector<Slopes<double>> rounded_slopes_ = {};
};

}  // namespace elgen
