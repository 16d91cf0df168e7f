// Checks [[equilibrium]] entries by closed forms of the residual and of det(x M - K) at the point.
// If the forms do not decide, numbers at the states of sample_equilibrium() decide: inspect() has
// tested the balance at these states, and compare_frequencies() computes there in 64 digits.
#include <fmt/format.h>

#include <algorithm>

#include "analyse/formulas.hpp"
#include "analyse/newton_refinement.hpp"
#include "analyse/rest.hpp"
#include "elgen/analyse.hpp"
#include "elgen/choose.hpp"
#include "elgen/inspect.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Larger determinants exceed the budget of closed forms.
constexpr std::size_t most_rows = 8;

/// The determinant by Laplace expansion along the first row, with minors memoised by their columns.
/// Elimination would divide forms and exceed the budget sooner.
OptionalFraction determinant(Arithmetic& arithmetic, const std::vector<OptionalFraction>& matrix,
                             std::size_t n) {
  std::vector<OptionalFraction> minors(std::size_t{1} << n);
  minors[0] = fraction_of(cln::cl_RA(1));
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    std::size_t row = n;
    for (std::size_t k = 0; k < n; ++k) row -= (columns >> k) & 1;
    OptionalFraction sum = Fraction{};
    bool is_negative = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (((columns >> k) & 1) == 0) continue;
      const OptionalFraction term =
          arithmetic.multiply(matrix[row * n + k], minors[columns & ~(std::size_t{1} << k)]);
      sum = is_negative ? arithmetic.subtract(sum, term) : arithmetic.add(sum, term);
      is_negative = !is_negative;
    }
    minors[columns] = sum;
  }
  return minors.back();
}

/// The determinant in 64 digits; undefined if an entry is undefined.
Real determinant(const std::vector<Real>& matrix, std::size_t n) {
  LargestPivot<Real> field;
  const Echelon<LargestPivot<Real>> echelon(field, matrix, n, n);
  return echelon.is_defined() ? echelon.determinant() : Real::undefined();
}

/// The replacement of a coordinate by `value`. If `value` is an angle rest +- acos(c) or rest +-
/// asin(c), the replacement has the cosine and sine of this angle, by the addition theorem.
Replacement coordinate_replacement(Arithmetic& at, const Algebra& algebra, const Fraction& value) {
  Replacement result{value};
  if (!value.denominator.empty()) return result;
  OptionalFraction rest = value;
  for (const auto& [monomial, coefficient] : value.numerator) {
    if (monomial.size() != 1 || monomial[0].exponent != 1) continue;
    const Atom atom = algebra.atoms[monomial[0].atom];
    const bool is_inverse = atom.kind == AtomKind::call && (atom.function == FunctionId::acos ||
                                                            atom.function == FunctionId::asin);
    if (!is_inverse || cln::abs(coefficient.real) != 1) continue;
    rest = at.subtract(rest, fraction_of(Polynomial{{monomial, coefficient}}));
    const OptionalFraction known = atom.arguments[0];
    const OptionalFraction one = fraction_of(cln::cl_RA(1));
    const OptionalFraction other = at.square_root(at.subtract(one, at.multiply(known, known)));
    const bool is_cosine = atom.function == FunctionId::acos;
    const OptionalFraction cosine = is_cosine ? known : other;
    const OptionalFraction own = is_cosine ? other : known;
    const OptionalFraction sine = cln::minusp(coefficient.real) ? at.negate(own) : own;
    // cosine and sine of rest + angle
    const OptionalFraction c = at.call(FunctionId::cos, rest, {});
    const OptionalFraction s = at.call(FunctionId::sin, rest, {});
    const OptionalFraction both_c = at.subtract(at.multiply(c, cosine), at.multiply(s, sine));
    const OptionalFraction both_s = at.add(at.multiply(s, cosine), at.multiply(c, sine));
    if (both_c && both_s) result.sinusoids = CosineAndSine{*both_c, *both_s};
    return result;
  }
  return result;
}

/// d(bias - B u)/dq.
std::vector<Real> stiffness_at(const Model& model, const Program& moving,
                               const Arguments<Real>& at) {
  const std::size_t n = at.v.size();
  std::vector<std::uint32_t> velocities(n);
  for (std::uint32_t i = 0; i < velocities.size(); ++i) velocities[i] = i;
  std::vector<Real> slopes =
      position_slopes(model, moving, *find_function(moving, OutputKind::bias), at, velocities);
  const Function* const inputs = find_function(moving, OutputKind::input_matrix);
  if (inputs == nullptr) return slopes;
  const std::vector<Real> of_inputs = position_slopes(model, moving, *inputs, at, velocities);
  for (std::size_t i = 0; i < n * n; ++i) {
    for (std::size_t k = 0; k < at.u.size(); ++k) {
      const std::size_t entry = i / n * at.u.size() + k;
      slopes[i] = slopes[i] - of_inputs[entry * n + i % n] * at.u[k];
    }
  }
  return slopes;
}

/// True if det(x M - K) = det M (x - w1^2) (x - w2^2) … at n + 1 values of x, to 30 digits. None if
/// a value is undefined.
std::optional<bool> matches_frequencies_at(const Model& model, const Program& moving,
                                           const Equilibrium& declared, const State& state) {
  static const cl_R noise = power_of_ten(-30);
  const std::size_t n = state.v.size();
  const Arguments<Real> at = arguments_at<Real>(state);
  const std::vector<Real> mass =
      evaluate(moving, *find_function(moving, OutputKind::mass_matrix), at);
  const std::vector<Real> stiffness = stiffness_at(model, moving, at);
  for (std::size_t place = 0; place <= n; ++place) {
    const Real x(cl_R(static_cast<int>(place)) - cl_R(1) / 3);
    std::vector<Real> pencil;
    for (std::size_t i = 0; i < n * n; ++i) pencil.push_back(x * mass[i] - stiffness[i]);
    Real product = determinant(mass, n);
    for (const ExpressionId expression : declared.frequencies_squared) {
      const auto square = oracle_expression_value(model, expression, state);
      if (!square) return std::nullopt;
      product = product * (x - Real(*square));
    }
    const Real own = determinant(pencil, n);
    const Real difference = abs(own - product);
    if (!difference.is_defined()) return std::nullopt;
    if (difference.value() > noise * max(abs(own), abs(product)).value()) return false;
  }
  return true;
}

class EquilibriumCheck {
 public:
  EquilibriumCheck(const CheckedModel& checked, const Program& moving, ClosedForms& forms,
                   const Equilibrium& declared)
      : checked_(checked),
        model_(checked.model),
        moving_(moving),
        forms_(forms),
        declared_(declared),
        arithmetic_(forms.algebra) {}

  EquilibriumVerdict operator()() {
    EquilibriumVerdict result{declared_.name};
    find_forms();
    const bool states_frequencies = !declared_.frequencies_squared.empty();
    const bool balances =
        !residual_.empty() && std::ranges::all_of(residual_, [](const OptionalFraction& row) {
          return row && row->numerator.empty();
        });
    if (balances) result.balance = ClaimStatus::proved;
    if (states_frequencies && matches_frequencies()) result.frequencies = ClaimStatus::proved;
    if (balances && result.frequencies.has_value() == states_frequencies) return result;
    const std::vector<State> points = sample_equilibrium(checked_, declared_);
    if (!balances && !points.empty()) result.balance = ClaimStatus::sampled;
    if (states_frequencies && !result.frequencies) compare_frequencies(points, result);
    return result;
  }

 private:
  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }

  [[nodiscard]] const ClosedFunction* closed_function(OutputKind kind) const {
    for (std::size_t i = 0; i < moving_.functions.size(); ++i) {
      if (moving_.functions[i].kind == kind) return &forms_.functions[i];
    }
    return nullptr;
  }

  OptionalFraction form_of(ExpressionId expression) {
    return closed_form(forms_, model_, checked_.scene.specialisation.fixed, expression);
  }

  /// Computes the residual, M and K at the point. All three remain empty if a coordinate of the
  /// point has no closed form, and for models with rotations.
  void find_forms() {
    const ClosedFunction* const bias = closed_function(OutputKind::bias);
    const ClosedFunction* const inputs = closed_function(OutputKind::input_matrix);
    const ClosedFunction* const mass = closed_function(OutputKind::mass_matrix);
    if (bias == nullptr || mass == nullptr || !model_.rotations.empty()) return;
    Replacements rest;
    for (std::uint32_t i = 0; i < size(); ++i) rest[{Opcode::velocity, i}] = {};
    Replacements place;
    for (std::uint32_t i = 0; i < model_.coordinates.size(); ++i) {
      if (!declared_.coordinates[i]) continue;
      const OptionalFraction value = form_of(*declared_.coordinates[i]);
      if (!value) return;
      place[{Opcode::coordinate, i}] = coordinate_replacement(arithmetic_, forms_.algebra, *value);
    }
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) {
      OptionalFraction row = substitute(forms_.algebra, bias->fields[0].entries[i], rest);
      for (std::size_t k = 0; k < model_.inputs.size(); ++k) {
        if (!declared_.inputs[k]) continue;
        const OptionalFraction force = arithmetic_.multiply(
            substitute(forms_.algebra, inputs->fields[0].entries[i * model_.inputs.size() + k],
                       rest),
            form_of(*declared_.inputs[k]));
        row = arithmetic_.subtract(row, force);
      }
      residual_.push_back(substitute(forms_.algebra, row, place));
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t coordinate = model_.velocities[k].coordinate;
        const OptionalFraction slope =
            row ? partial_derivative(forms_, *row, coordinate, model_.coordinates.size())
                : std::nullopt;
        stiffness_.push_back(substitute(forms_.algebra, slope, place));
        mass_.push_back(substitute(forms_.algebra, mass->fields[0].entries[i * n + k], place));
      }
    }
  }

  /// True if det(x M - K) and det M (x - w1^2) (x - w2^2) ... are equal as closed forms.
  bool matches_frequencies() {
    const std::size_t n = size();
    if (stiffness_.size() != n * n || n > most_rows) return false;
    const OptionalFraction x =
        arithmetic_.leaf(Opcode::acceleration, 0);  // a leaf in no equation at rest
    std::vector<OptionalFraction> pencil;
    for (std::size_t i = 0; i < n * n; ++i) {
      pencil.push_back(arithmetic_.subtract(arithmetic_.multiply(x, mass_[i]), stiffness_[i]));
    }
    OptionalFraction product = determinant(arithmetic_, mass_, n);
    for (const ExpressionId expression : declared_.frequencies_squared) {
      product = arithmetic_.multiply(product, arithmetic_.subtract(x, form_of(expression)));
    }
    const OptionalFraction difference =
        arithmetic_.subtract(determinant(arithmetic_, pencil, n), product);
    return difference && difference->numerator.empty();
  }

  /// Compares the declared frequencies with det(x M - K) at `points`, and stores the status in
  /// `result`. The witness is the first point at which a declared frequency is wrong.
  void compare_frequencies(const std::vector<State>& points, EquilibriumVerdict& result) const {
    result.frequencies = ClaimStatus::undecided;
    for (const State& point : points) {
      const std::optional<bool> holds = matches_frequencies_at(model_, moving_, declared_, point);
      if (!holds) continue;
      result.frequencies = *holds ? ClaimStatus::sampled : ClaimStatus::wrong;
      if (*holds) continue;
      result.witness = describe_state({model_, checked_.scene, moving_}, point);
      return;
    }
  }

  const CheckedModel& checked_;
  const Model& model_;
  const Program& moving_;
  ClosedForms& forms_;
  const Equilibrium& declared_;
  Arithmetic arithmetic_;
  std::vector<OptionalFraction> residual_ = {};
  std::vector<OptionalFraction> mass_ = {};
  std::vector<OptionalFraction> stiffness_ = {};
};

}  // namespace

std::vector<EquilibriumVerdict> check_equilibria(const CheckedModel& checked,
                                                 const Program& recursive) {
  std::vector<EquilibriumVerdict> result;
  const bool is_exact = !checked.model.approximation && checked.model.open_values.empty();
  if (checked.model.equilibria.empty() || !is_exact) return result;
  const Program moving =
      with_closed_forms(recursive, Audience::code);  // contains no leaves that cancel
  ClosedForms forms = present(moving);
  for (const Equilibrium& declared : checked.model.equilibria) {
    result.push_back(EquilibriumCheck(checked, moving, forms, declared)());
  }
  return result;
}

}  // namespace elgen
