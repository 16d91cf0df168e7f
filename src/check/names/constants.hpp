// Constants: the values of expressions made of numbers, pi and functions of them.
#pragma once

#include <cln/real.h>

#include <optional>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "numbers/enclosed_number.hpp"

namespace elgen {

/// Why a constant has no (usable) value. `operand` says where: the denominator, or the whole.
struct ConstantFailure {
  Code code = Code::E313;
  std::string message;
  std::optional<std::size_t> operand = {};
};

/// A value, or why there is none, or neither where so many digits do not tell.
struct ConstantOutcome {
  std::optional<EnclosedNumber> value = {};
  std::optional<ConstantFailure> failure = {};
};

/// Digits constants are kept to.
inline constexpr int constant_digits = 100;

/// Value of one node from its operands, in floats of so many digits. A value that differs from 0 by
/// no more than its error is an exact 0: sin(pi), 2-sqrt(4).
[[nodiscard]] ConstantOutcome evaluate_constant(const Expression& node,
                                                const std::vector<EnclosedNumber>& operands,
                                                int digits);

/// Values of the constant expressions of an arena, kept beside it.
class Constants {
 public:
  /// The value of the first expression of the arena that has not had its turn, which its operands
  /// have had; `failure` where there is none.
  std::optional<ConstantFailure> append(const std::vector<Expression>& arena);
  void truncate(std::size_t size) { values_.resize(size); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

  /// An exact rational where it is one, else a float good to constant_digits; nothing where the
  /// expression is no constant.
  [[nodiscard]] std::optional<cln::cl_R> operator[](ExpressionId id) const {
    return values_[id] ? std::optional(values_[id]->value) : std::nullopt;
  }

 private:
  /// The outcome of a node, its operands evaluated again to as many digits.
  [[nodiscard]] ConstantOutcome at(const std::vector<Expression>& arena, const Expression& node,
                                   int digits) const;

  std::vector<std::optional<EnclosedNumber>> values_;
};

/// Decimal digits of numerator and denominator, whichever has more.
[[nodiscard]] std::size_t digit_count(const cln::cl_RA& number);

inline constexpr std::size_t largest_exact_digits = 4096;

}  // namespace elgen
