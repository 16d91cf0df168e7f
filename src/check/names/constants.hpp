// Values of constant expressions: numbers, pi and functions of them.
#pragma once

#include <cln/real.h>

#include <optional>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "numbers/enclosed_number.hpp"

namespace elgen {

/// Why a constant has no usable value. `operand` is the index of the operand at fault, such as a
/// zero denominator; none: the whole expression.
struct ConstantFailure {
  Code code = Code::E313;
  std::string message;
  std::optional<std::size_t> operand = {};
};

/// A value, a failure, or neither: undecided at this precision.
struct ConstantOutcome {
  std::optional<EnclosedNumber> value = {};
  std::optional<ConstantFailure> failure = {};
};

/// Correct decimal digits of a constant that is not rational.
inline constexpr int constant_digits = 100;

/// Value of one node from the values of its operands, in floats of `digits` decimal digits. A sum
/// or function value becomes an exact 0 if its enclosure contains 0 and is narrow enough: sin(pi),
/// 2-sqrt(4).
[[nodiscard]] ConstantOutcome evaluate_constant(const Expression& node,
                                                const std::vector<EnclosedNumber>& operands,
                                                int digits);

/// Values of the constant expressions of an arena, by ExpressionId.
class ConstantValues {
 public:
  /// Evaluates arena[size()] from the values of its operands, which precede it. Returns the
  /// failure, if any.
  std::optional<ConstantFailure> evaluate_next(const std::vector<Expression>& arena);
  void truncate(std::size_t size) { values_.resize(size); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

  /// An exact rational, or else a float accurate to constant_digits; none if the expression is not
  /// constant.
  [[nodiscard]] std::optional<cln::cl_R> operator[](ExpressionId id) const {
    return values_[id] ? std::optional(values_[id]->value) : std::nullopt;
  }

 private:
  /// Evaluates a node with `digits` digits. Inexact operands are evaluated again if `digits` is
  /// larger than in the first evaluation.
  [[nodiscard]] ConstantOutcome evaluate_node(const std::vector<Expression>& arena,
                                              const Expression& node, int digits) const;

  std::vector<std::optional<EnclosedNumber>> values_;
};

/// Decimal digits of the numerator or the denominator, whichever has more.
[[nodiscard]] std::size_t digit_count(const cln::cl_RA& number);

inline constexpr std::size_t largest_exact_digits = 4096;

}  // namespace elgen
