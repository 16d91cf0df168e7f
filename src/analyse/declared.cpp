// [[equilibrium]]: closed forms of the residual and of det(x M - K) at the point; where they do not
// decide, numbers of 64 digits at random parameters.
#include <fmt/format.h>

#include <algorithm>

#include "analyse/polish.hpp"
#include "analyse/rest.hpp"
#include "analyse/substitution.hpp"
#include "elgen/analyse.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/random.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// An exact and random state at which a wrong claim holds is one in 1e9.
constexpr std::size_t draws = 8;
/// Draws that do not meet a condition are drawn again.
constexpr std::size_t most_draws = 64;

/// The larger determinants of closed forms outgrow their budget.
constexpr std::size_t most_rows = 8;

/// Expands by the first row; minors are known by the columns that they leave. Elimination divides
/// forms, which would outgrow the budget sooner.
Value determinant(Arithmetic& at, const std::vector<Value>& matrix, std::size_t n) {
  std::vector<Value> minors(std::size_t{1} << n);
  minors[0] = fraction_of(cln::cl_RA(1));
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    std::size_t row = n;
    for (std::size_t k = 0; k < n; ++k) row -= (columns >> k) & 1;
    Value sum = Fraction{};
    bool is_negative = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (((columns >> k) & 1) == 0) continue;
      const Value term = at.multiply(matrix[row * n + k], minors[columns & ~(std::size_t{1} << k)]);
      sum = is_negative ? at.subtract(sum, term) : at.add(sum, term);
      is_negative = !is_negative;
    }
    minors[columns] = sum;
  }
  return minors.back();
}

/// In 64 digits; undefined where an entry is.
Real determinant(const std::vector<Real>& matrix, std::size_t n) {
  LargestPivot<Real> field;
  const Echelon<LargestPivot<Real>> echelon(field, matrix, n, n);
  return echelon.is_defined() ? echelon.determinant() : Real::undefined();
}

class DeclaredEquilibrium {
 public:
  DeclaredEquilibrium(const CheckedModel& checked, const Program& moving, ClosedForms& forms,
                      const Equilibrium& declared)
      : model_(checked.model),
        scene_(checked.scene),
        moving_(moving),
        forms_(forms),
        declared_(declared),
        at_(forms.algebra) {}

  JudgedEquilibrium operator()() {
    JudgedEquilibrium result{declared_.name};
    find_forms();
    const bool balances =
        !residual_.empty() && std::ranges::all_of(residual_, [](const Value& row) {
          return row && row->numerator.empty();
        });
    result.balance =
        balances ? ClaimStatus::proved : sampled(result, &DeclaredEquilibrium::rests_at);
    if (declared_.frequencies_squared.empty()) return result;
    result.frequencies = has_frequencies()
                             ? ClaimStatus::proved
                             : sampled(result, &DeclaredEquilibrium::has_frequencies_at);
    return result;
  }

 private:
  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }

  [[nodiscard]] const ClosedFunction* closed(OutputKind kind) const {
    for (std::size_t i = 0; i < moving_.functions.size(); ++i) {
      if (moving_.functions[i].kind == kind) return &forms_.functions[i];
    }
    return nullptr;
  }

  Value form_of(ExpressionId expression) {
    return closed_form(forms_, model_, scene_.specialisation.fixed, expression);
  }

  /// The angle k pi +- acos(c) or asin(c) has its cosine and sine; others have their value alone.
  Replacement replacement_of(const Fraction& value) {
    Replacement result{value};
    if (!value.denominator.empty()) return result;
    Value rest = value;
    for (const auto& [monomial, coefficient] : value.numerator) {
      if (monomial.size() != 1 || monomial[0].exponent != 1) continue;
      const Atom atom = forms_.algebra.atoms[monomial[0].atom];
      const bool is_inverse = atom.kind == AtomKind::call && (atom.function == FunctionId::acos ||
                                                              atom.function == FunctionId::asin);
      if (!is_inverse || cln::abs(coefficient.real) != 1) continue;
      rest = at_.subtract(rest, fraction_of(Polynomial{{monomial, coefficient}}));
      const Value known = atom.arguments[0];
      const Value one = fraction_of(cln::cl_RA(1));
      const Value other = at_.square_root(at_.subtract(one, at_.multiply(known, known)));
      const bool is_cosine = atom.function == FunctionId::acos;
      const Value cosine = is_cosine ? known : other;
      const Value own = is_cosine ? other : known;
      const Value sine = cln::minusp(coefficient.real) ? at_.negate(own) : own;
      // cos and sin of rest + angle
      const Value c = at_.call(FunctionId::cos, rest, {});
      const Value s = at_.call(FunctionId::sin, rest, {});
      const Value both_c = at_.subtract(at_.multiply(c, cosine), at_.multiply(s, sine));
      const Value both_s = at_.add(at_.multiply(s, cosine), at_.multiply(c, sine));
      if (both_c && both_s) result.waves = CosineAndSine{*both_c, *both_s};
      return result;
    }
    return result;
  }

  /// The residual at the point, and K there; empty where a form is not known.
  void find_forms() {
    const ClosedFunction* const bias = closed(OutputKind::bias);
    const ClosedFunction* const inputs = closed(OutputKind::input_matrix);
    const ClosedFunction* const mass = closed(OutputKind::mass_matrix);
    if (bias == nullptr || mass == nullptr || !model_.rotations.empty()) return;
    Replacements rest;
    for (std::uint32_t i = 0; i < size(); ++i) rest[{Opcode::velocity, i}] = {};
    Replacements place;
    for (std::uint32_t i = 0; i < model_.coordinates.size(); ++i) {
      if (!declared_.coordinates[i]) continue;
      const Value value = form_of(*declared_.coordinates[i]);
      if (!value) return;
      place[{Opcode::coordinate, i}] = replacement_of(*value);
    }
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) {
      Value row = at_rest(bias->fields[0].entries[i], rest);
      for (std::size_t k = 0; k < model_.inputs.size(); ++k) {
        if (!declared_.inputs[k]) continue;
        const Value force =
            at_.multiply(at_rest(inputs->fields[0].entries[i * model_.inputs.size() + k], rest),
                         form_of(*declared_.inputs[k]));
        row = at_.subtract(row, force);
      }
      residual_.push_back(row ? substituted(forms_.algebra, *row, place) : std::nullopt);
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t coordinate = model_.velocities[k].coordinate;
        const Value slope =
            row ? partial_derivative(forms_, *row, coordinate, model_.coordinates.size())
                : std::nullopt;
        const auto& m = mass->fields[0].entries[i * n + k];
        stiffness_.push_back(slope ? substituted(forms_.algebra, *slope, place) : std::nullopt);
        mass_.push_back(m ? substituted(forms_.algebra, *m, place) : std::nullopt);
      }
    }
  }

  Value at_rest(const std::optional<Fraction>& form, const Replacements& rest) {
    return form ? substituted(forms_.algebra, *form, rest) : std::nullopt;
  }

  /// det(x M - K) = det M (x - w1^2) (x - w2^2) ...
  bool has_frequencies() {
    const std::size_t n = size();
    if (stiffness_.size() != n * n || n > most_rows) return false;
    const Value x = at_.leaf(Opcode::acceleration, 0);  // no equation at rest holds it
    std::vector<Value> pencil;
    for (std::size_t i = 0; i < n * n; ++i) {
      pencil.push_back(at_.subtract(at_.multiply(x, mass_[i]), stiffness_[i]));
    }
    Value product = determinant(at_, mass_, n);
    for (const ExpressionId expression : declared_.frequencies_squared) {
      product = at_.multiply(product, at_.subtract(x, form_of(expression)));
    }
    const Value difference = at_.subtract(determinant(at_, pencil, n), product);
    return difference && difference->numerator.empty();
  }

  using Judge = std::optional<bool> (DeclaredEquilibrium::*)(const State& state) const;

  /// At random parameters that meet the condition; the first wrong state is kept.
  ClaimStatus sampled(JudgedEquilibrium& result, Judge judge) {
    Random random(1);
    std::size_t seen = 0;
    for (std::size_t turn = 0; turn < most_draws && seen < draws; ++turn) {
      State state = nominal_state(model_, scene_);
      if (turn > 0) {
        draw_parameters(model_, scene_.specialisation.fixed, random, turn, state);
        draw_motion(model_, random, turn, state);
      }
      if (declared_.condition && !oracle_meets(model_, *declared_.condition, state)) continue;
      const std::optional<State> point = oracle_point(model_, declared_, std::move(state));
      const std::optional<bool> holds = point ? (this->*judge)(*point) : std::nullopt;
      if (!holds) continue;
      ++seen;
      if (*holds) continue;
      result.witness = describe({model_, scene_, moving_}, *point);
      return ClaimStatus::wrong;
    }
    return seen > 0 ? ClaimStatus::sampled : ClaimStatus::open;
  }

  /// bias - B u is 0 to 40 digits of its terms, of which there are 60.
  [[nodiscard]] std::optional<bool> rests_at(const State& state) const {
    static const cl_R noise = power_of_ten(-40);
    const Arguments<Real> at = arguments_at<Real>(state);
    const std::vector<Real> bias = values(OutputKind::bias, at);
    const std::vector<Real> forces = values(OutputKind::input_matrix, at);
    cl_R scale = 1;
    for (const Parameter& parameter : model_.parameters) {
      if (cln::abs(parameter.value) > scale) scale = cln::abs(parameter.value);
    }
    for (std::size_t i = 0; i < bias.size(); ++i) {
      Real sum = bias[i];
      for (std::size_t k = 0; k < at.u.size(); ++k)
        sum = sum - forces[i * at.u.size() + k] * at.u[k];
      if (!sum.is_defined()) return std::nullopt;
      if (cln::abs(sum.value()) > noise * scale) return false;
    }
    return true;
  }

  [[nodiscard]] std::vector<Real> values(OutputKind kind, const Arguments<Real>& at) const {
    const Function* const function = find_function(moving_, kind);
    return function == nullptr ? std::vector<Real>{} : evaluate(moving_, *function, at);
  }

  /// Both polynomials at n + 1 places, to 30 digits of the larger one.
  [[nodiscard]] std::optional<bool> has_frequencies_at(const State& state) const {
    static const cl_R noise = power_of_ten(-30);
    const std::size_t n = size();
    const Arguments<Real> at = arguments_at<Real>(state);
    const std::vector<Real> mass = values(OutputKind::mass_matrix, at);
    const std::vector<Real> stiffness = slopes_at(at);
    for (std::size_t place = 0; place <= n; ++place) {
      const Real x(cl_R(static_cast<int>(place)) - cl_R(1) / 3);
      std::vector<Real> pencil;
      for (std::size_t i = 0; i < n * n; ++i) pencil.push_back(x * mass[i] - stiffness[i]);
      Real product = determinant(mass, n);
      for (const ExpressionId expression : declared_.frequencies_squared) {
        const auto square = oracle_expression(model_, expression, state);
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

  /// d(bias - B u)/dq
  [[nodiscard]] std::vector<Real> slopes_at(const Arguments<Real>& at) const {
    std::vector<std::uint32_t> velocities(size());
    for (std::uint32_t i = 0; i < velocities.size(); ++i) velocities[i] = i;
    std::vector<Real> slopes =
        position_slopes(model_, moving_, *find_function(moving_, OutputKind::bias), at, velocities);
    const Function* const inputs = find_function(moving_, OutputKind::input_matrix);
    if (inputs == nullptr) return slopes;
    const std::vector<Real> of_inputs = position_slopes(model_, moving_, *inputs, at, velocities);
    const std::size_t n = size();
    for (std::size_t i = 0; i < n * n; ++i) {
      for (std::size_t k = 0; k < at.u.size(); ++k) {
        const std::size_t entry = i / n * at.u.size() + k;
        slopes[i] = slopes[i] - of_inputs[entry * n + i % n] * at.u[k];
      }
    }
    return slopes;
  }

  const Model& model_;
  const Scene& scene_;
  const Program& moving_;
  ClosedForms& forms_;
  const Equilibrium& declared_;
  Arithmetic at_;
  std::vector<Value> residual_ = {};
  std::vector<Value> mass_ = {};
  std::vector<Value> stiffness_ = {};
};

}  // namespace

std::vector<JudgedEquilibrium> judge_equilibria(const CheckedModel& checked,
                                                const Program& recursive) {
  std::vector<JudgedEquilibrium> result;
  const bool is_exact = !checked.model.approximation && checked.model.open_values.empty();
  if (checked.model.equilibria.empty() || !is_exact) return result;
  const Program moving = closed_program(recursive);
  ClosedForms forms = present(moving);
  for (const Equilibrium& declared : checked.model.equilibria) {
    result.push_back(DeclaredEquilibrium(checked, moving, forms, declared)());
  }
  return result;
}

}  // namespace elgen
