// conditioning: the derivatives of every instruction by its operands, then one reverse sweep per
// value.
#include "accuracy/conditioning.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// x rounded to a double, within an ulp; the error bounds of Adjoint include this error. Infinite
/// or 0 if x is outside the range of doubles.
double round_to_double(const Real& x) {
  return x.is_defined() ? cln::double_approx(x.value()) : std::numeric_limits<double>::quiet_NaN();
}

/// The relative error bound up to which K computed in double is used. This bound suffices, because
/// K is reported to a tenth of a decimal digit. In long functions, or if derivatives cancel, the
/// error bound may be larger; then K is computed in Real.
constexpr double tolerated_error = 1e-4;

/// An upper bound on the error that underflow causes in a factor or a product in double.
constexpr double underflow_loss = 1e-300;

/// A derivative, and a bound on its rounding errors in double.
struct Adjoint {
  double value = 0;
  double error = 0;

  /// Adds x * factor. The bound includes the rounding errors of the factor and of the product.
  void add(const Adjoint& x, double factor) {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const double term = x.value * factor;
    value += term;
    error += x.error * std::abs(factor) + rounding * (std::abs(term) + std::abs(value)) +
             underflow_loss * (1 + std::abs(x.value));
  }
};

}  // namespace

Conditioning::Conditioning(const Program& program, const Function& function,
                           std::vector<Real> values, std::vector<bool> parameters)
    : program_(program),
      function_(function),
      values_(std::move(values)),
      is_parameter_(std::move(parameters)) {
  slopes_.reserve(values_.size());
  for (const Instruction& i : function.instructions) {
    const std::size_t operands = operand_count(i);
    Slopes<Real>& slopes = slopes_.emplace_back();
    if (operands > 0) slopes.by_a = slope(i, i.a);
    if (operands > 1 && i.b != i.a) slopes.by_b = slope(i, i.b);
    rounded_slopes_.push_back({round_to_double(slopes.by_a), round_to_double(slopes.by_b)});
  }
  for (const Real& value : values_) rounded_values_.push_back(round_to_double(value));
}

/// The derivative of `i` by `operand`: 1 or -1 for a sum or difference, the other operand for a
/// product, otherwise the tangent of a dual number.
Real Conditioning::slope(const Instruction& i, std::uint32_t operand) const {
  const bool is_first = operand == i.a;
  if (is_sum(i) && i.a != i.b) return Real(is_first || i.opcode == Opcode::add ? 1 : -1);
  const bool is_product = i.opcode == Opcode::multiply && i.a != i.b;
  if (is_product && values_[operand].is_defined()) return values_[is_first ? i.b : i.a];
  return slope_by_operand(program_, i, operand, values_);
}

bool Conditioning::counts_as_input(const Instruction& i) const {
  if (i.opcode == Opcode::constant) return !is_parameter_.empty() && is_parameter_[i.a];
  return is_leaf(i.opcode);
}

std::optional<double> Conditioning::conditioning_in_double(std::uint32_t instruction) const {
  std::vector<Adjoint> adjoints(instruction + 1);
  adjoints[instruction].value = 1;
  Adjoint sum;
  for (std::size_t at = instruction + 1; at-- > 0;) {
    const Instruction& i = function_.instructions[at];
    const Adjoint& adjoint = adjoints[at];
    if (adjoint.value == 0 && adjoint.error == 0) continue;
    if (counts_as_input(i))
      sum.add({std::abs(adjoint.value), adjoint.error}, std::abs(rounded_values_[at]));
    const std::size_t operands = operand_count(i);
    if (operands > 0) adjoints[i.a].add(adjoint, rounded_slopes_[at].by_a);
    if (operands > 1) adjoints[i.b].add(adjoint, rounded_slopes_[at].by_b);
  }
  // If a derivative is NaN, the value of the sum is NaN, and K is computed in Real.
  if (std::isfinite(sum.value) && sum.error <= tolerated_error * sum.value) return sum.value;
  return std::nullopt;
}

Real Conditioning::absolute_condition(std::uint32_t instruction) const {
  if (const auto k = conditioning_in_double(instruction)) return Real(exact_value(*k));
  std::vector<Real> adjoints(instruction + 1, Real());
  adjoints[instruction] = Real(1);
  Real sum;
  for (std::size_t at = instruction + 1; at-- > 0;) {
    const Instruction& i = function_.instructions[at];
    const Real adjoint = adjoints[at];
    if (is_zero(adjoint)) continue;
    if (counts_as_input(i)) sum = sum + abs(adjoint * values_[at]);
    const std::size_t operands = operand_count(i);
    if (operands > 0) adjoints[i.a] = adjoints[i.a] + adjoint * slopes_[at].by_a;
    if (operands > 1) adjoints[i.b] = adjoints[i.b] + adjoint * slopes_[at].by_b;
  }
  return sum;
}

}  // namespace elgen
