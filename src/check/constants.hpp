// Constants: the values of expressions made of numbers, pi and functions of them.
#pragma once

#include <cln/real.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"

namespace elgen::checking {

/// Why a constant has no (usable) value. `operand` says where: the denominator, or the whole.
struct ConstantFailure {
  Code code = Code::E313;
  std::string message;
  std::optional<std::size_t> operand = {};
};

struct ConstantOutcome {
  std::optional<cln::cl_R> value = {};
  std::optional<ConstantFailure> failure = {};
};

/// Digits constants are kept to.
inline constexpr int constant_digits = 100;

/// The value of operand `i` of the node, to that many decimal digits.
using OperandValue = std::function<cln::cl_R(std::size_t operand, int digits)>;

/// Value of one node from its operands: an exact rational where it is one, else a float good to
/// `digits` decimal digits. What cancels to less than its rounding is an exact 0: sin(pi),
/// 2-sqrt(4).
[[nodiscard]] ConstantOutcome evaluate_constant(const Expression& node, const OperandValue& operand,
                                                int digits);

/// Values of the constant expressions of an arena, kept beside it.
class Constants {
 public:
  /// The value of the first expression of the arena that has not had its turn, which its operands
  /// have had; `failure` where there is none.
  std::optional<ConstantFailure> append(const std::vector<Expression>& arena);
  void truncate(std::size_t size) { values_.resize(size); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

  /// Nothing where the expression is no constant.
  [[nodiscard]] const std::optional<cln::cl_R>& operator[](ExpressionId id) const {
    return values_[id];
  }

 private:
  [[nodiscard]] cln::cl_R at(const std::vector<Expression>& arena, ExpressionId id,
                             int digits) const;

  std::vector<std::optional<cln::cl_R>> values_;
};

/// log10 |x| to within one, of numbers of any size; 0 of 0.
[[nodiscard]] double decimal_exponent(const cln::cl_R& x);

/// Decimal digits of numerator and denominator, whichever has more.
[[nodiscard]] std::size_t digit_count(const cln::cl_RA& number);

inline constexpr std::size_t largest_exact_digits = 4096;

}  // namespace elgen::checking
