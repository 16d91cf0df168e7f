// Conditioning: how far one rounding of everything that a value is made from takes it, however it
// is computed:
//
//     K = sum |z dx/dz|      over leaves z and literals z
//
// in units of u. A formula whose error is far beyond u (|x| + K) loses digits that another keeps.
#pragma once

#include "evaluate/bounded.hpp"

namespace elgen {

/// Errors of so many u (|x| + K) are what rounding and a few operations explain: more is lost to
/// the formula.
inline constexpr double tolerated_loss = 64;

/// Losses that differ by less are alike: the cheaper way is taken.
inline constexpr double similar_losses = 8;

/// The literals that count as rounded.
enum class Literals : std::uint8_t {
  not_binary,  ///< in the scalar
  all,         ///< but powers of two: parameters that a scene fixed are among them
};

/// Derivatives along a function at one point, by one sweep against its order for each value.
class Conditioning {
 public:
  /// `values`: those of all instructions. All arguments outlive it. Cost: two operations of dual
  /// numbers per instruction.
  Conditioning(const Program& program, const Function& function, std::vector<Real> values,
               const Rounding& rounding, Literals literals);

  /// K of an instruction; undefined where a derivative is. Cost: two operations of Real for each
  /// instruction before it.
  [[nodiscard]] Real of(std::uint32_t instruction) const;

  /// |x| + K, which errors are compared with.
  [[nodiscard]] Real reference(std::uint32_t instruction) const {
    return abs(values_[instruction]) + of(instruction);
  }

 private:
  [[nodiscard]] Real slope(const Instruction& i, std::uint32_t operand) const;
  [[nodiscard]] bool is_rounded(const Instruction& i) const;

  /// Of an instruction by its operands; by both together where they are one.
  struct Slopes {
    Real by_a = {};
    Real by_b = {};
  };

  const Program& program_;
  const Function& function_;
  const Rounding& rounding_;
  Literals literals_;
  std::vector<Real> values_;
  std::vector<Slopes> slopes_ = {};
};

}  // namespace elgen
