// After denominators are cleared, an equation is a sum of monomials in q, v, a and t, with
// coefficients in the parameters. The equation holds for all motions if each coefficient is 0.
#include "analyse/exact_generators.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "analyse/formulas.hpp"
#include "forms/present/polynomial.hpp"

namespace elgen {
namespace {

using FormEchelon = Echelon<FormField>;

/// sum_u x_u coefficient_u = 0 for the unknowns x_u; coefficients contain parameters only.
using Equation = FormEchelon::Row;

class MonomialEquations {
 public:
  MonomialEquations(ClosedForms& forms, FormField& field)
      : algebra_(forms.algebra),
        field_(field),
        motions_(forms.algebra, [](const Atom& leaf) { return leaf.leaf != Opcode::parameter; }) {}

  /// Adds one equation for each monomial of a row; false if the budget is exceeded.
  bool add_row(std::vector<OptionalFraction> row) {
    if (!clear_denominators(row)) return false;
    std::map<Monomial, std::map<std::size_t, Polynomial>, MonomialLess> sums;
    for (std::size_t u = 0; u < row.size(); ++u) {
      for (const auto& [monomial, coefficient] : row[u]->numerator) {
        Monomial moving;
        Monomial constant;
        for (const AtomPower& power : monomial) {
          check_independence(power.atom);
          (motions_.contains(power.atom) ? moving : constant).push_back(power);
        }
        add_term(sums[moving][u], constant, coefficient);
      }
    }
    for (const auto& [monomial, coefficients] : sums) {
      Equation equation;
      for (const auto& [u, sum] : coefficients) {
        if (!sum.empty()) equation.push_back({u, fraction_of(sum)});
      }
      if (!equation.empty()) equations_.push_back(std::move(equation));
    }
    return true;
  }

  [[nodiscard]] bool is_complete() const { return is_complete_ && roots_.size() < 2; }
  [[nodiscard]] bool has_root() const { return !roots_.empty(); }
  [[nodiscard]] std::vector<Equation> equations() && { return std::move(equations_); }

 private:
  /// Sets is_complete_ to false if the atoms may depend on each other. Powers 0 and 1 of a single
  /// root are independent. But sqrt(a) sqrt(b) may be a third root, and a root of an expression in
  /// sines and cosines may equal a sine.
  void check_independence(AtomId id) {
    if (algebra_.atoms[id].kind != AtomKind::root) {
      is_complete_ = is_complete_ && is_independent(algebra_, id);
    } else if (roots_.insert(id).second) {
      const Fraction& radicand = algebra_.atoms[id].arguments[0];
      is_complete_ = is_complete_ && has_only_leaves(radicand.numerator) &&
                     std::ranges::all_of(radicand.denominator, [this](const auto& factor) {
                       return has_only_leaves(algebra_.factors[factor.first].shown);
                     });
    }
  }

  [[nodiscard]] bool has_only_leaves(const Polynomial& sum) const {
    return std::ranges::all_of(sum, [this](const auto& term) {
      return std::ranges::all_of(term.first, [this](const AtomPower& power) {
        return algebra_.atoms[power.atom].kind == AtomKind::leaf;
      });
    });
  }

  using Denominator = std::map<std::uint32_t, std::int32_t>;

  /// Multiplies a row by its common denominator until no denominator remains: squares of roots may
  /// introduce new denominators. Returns false if an entry has no form.
  bool clear_denominators(std::vector<OptionalFraction>& row) {
    for (;;) {
      Denominator common;
      for (const OptionalFraction& entry : row) {
        if (!entry) return false;
        for (const auto& [factor, exponent] : entry->denominator) {
          common[factor] = std::max(common[factor], exponent);
        }
      }
      if (common.empty()) return true;
      for (OptionalFraction& entry : row) entry = scale_to_denominator(common, *entry);
    }
  }

  /// `entry` times the product `common`.
  OptionalFraction scale_to_denominator(Denominator common, const Fraction& entry) {
    for (const auto& [factor, exponent] : entry.denominator) common[factor] -= exponent;
    OptionalFraction result = Fraction{entry.numerator, {}};
    for (const auto& [factor, exponent] : common) {
      for (std::int32_t i = 0; i < exponent; ++i) {
        result = field_.multiply(result, fraction_of(algebra_.factors[factor].shown));
      }
    }
    return result;
  }

  const Algebra& algebra_;
  FormField& field_;
  LeafSearch motions_;
  bool is_complete_ = true;
  std::set<AtomId> roots_ = {};
  std::vector<Equation> equations_ = {};
};

/// `equations` without the unknowns that an equation with one term sets to 0. For each of these
/// unknowns x, one equation x = 0 is appended.
std::vector<Equation> eliminate_zero_unknowns(std::vector<Equation> equations) {
  std::set<std::size_t> zeros;
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (Equation& equation : equations) {
      std::erase_if(equation, [&](const auto& term) { return zeros.contains(term.column); });
      if (equation.size() != 1) continue;
      zeros.insert(equation.front().column);
      is_done = false;
    }
    std::erase_if(equations, [](const Equation& equation) { return equation.empty(); });
  }
  for (const std::size_t u : zeros) equations.emplace_back().push_back({u, FormField::integer(1)});
  return equations;
}

/// The derivatives of R; none if a derivative has no form.
std::optional<ResidualSlopes<OptionalFraction>> residual_slopes(
    ClosedForms& forms, const GeneratorLayout& all, const OpenValueRates& open_values,
    const std::vector<OptionalFraction>& residual) {
  const std::size_t n = all.velocity_count;
  const std::vector<Fraction> still(n);
  const auto slopes_along = [&](const LeafRates& rates, std::vector<OptionalFraction>& slopes,
                                std::size_t column, std::size_t columns) {
    slopes.resize(n * columns);
    for (std::size_t i = 0; i < n; ++i) {
      slopes[i * columns + column] = directional_derivative(forms, *residual[i], rates);
      if (!slopes[i * columns + column]) return false;
    }
    return true;
  };
  const Fraction one = fraction_of(cln::cl_RA(1));
  ResidualSlopes<OptionalFraction> slopes;
  for (std::size_t k = 0; k < n; ++k) {
    LeafRates by_position{still, still, still, open_values};
    LeafRates by_velocity = by_position;
    LeafRates by_acceleration = by_position;
    by_position.coordinates[k] = one;
    by_velocity.velocities[k] = one;
    by_acceleration.accelerations[k] = one;
    if (!slopes_along(by_position, slopes.by_position, k, n)) return std::nullopt;
    if (!slopes_along(by_velocity, slopes.by_velocity, k, n)) return std::nullopt;
    if (!slopes_along(by_acceleration, slopes.by_acceleration, k, n)) return std::nullopt;
  }
  if (!slopes_along({still, still, still, open_values, one}, slopes.by_time, 0, 1)) {
    return std::nullopt;
  }
  return slopes;
}

}  // namespace

MotionPoint<OptionalFraction> symbolic_motion_point(FormField& field, const Model& model,
                                                    const std::vector<OptionalFraction>& residual) {
  MotionPoint<OptionalFraction> at;
  for (std::uint32_t i = 0; i < model.coordinates.size(); ++i) {
    at.q.push_back(field.leaf(Opcode::coordinate, i));
  }
  for (std::uint32_t i = 0; i < model.velocities.size(); ++i) {
    at.v.push_back(field.leaf(Opcode::velocity, i));
    at.a.push_back(field.leaf(Opcode::acceleration, i));
  }
  at.t = field.leaf(Opcode::time, 0);
  at.residual = residual;
  return at;
}

std::optional<ExactGenerators> exact_generators(ClosedForms& forms, const Model& model,
                                                const OpenValueRates& open_values,
                                                const std::vector<OptionalFraction>& residual) {
  const GeneratorLayout all(model);
  const bool are_known =
      std::ranges::all_of(residual, [](const OptionalFraction& x) { return x.has_value(); });
  if (!all.rotations.empty() || !are_known) return std::nullopt;
  const auto slopes = residual_slopes(forms, all, open_values, residual);
  if (!slopes) return std::nullopt;
  FormField field(forms.algebra);
  MonomialEquations equations(forms, field);
  for (std::vector<OptionalFraction>& row :
       symmetry_conditions(field, all, symbolic_motion_point(field, model, residual), *slopes)) {
    if (!equations.add_row(std::move(row))) return std::nullopt;
  }
  ExactGenerators result;
  result.is_complete = equations.is_complete();
  result.has_root = equations.has_root();
  const FormEchelon echelon(field, eliminate_zero_unknowns(std::move(equations).equations()),
                            all.size());
  if (!echelon.is_defined()) return std::nullopt;
  for (const std::vector<OptionalFraction>& solution : echelon.kernel()) {
    std::vector<Fraction>& entries = result.basis.emplace_back();
    for (const OptionalFraction& entry : solution) entries.push_back(*entry);
  }
  return result;
}

}  // namespace elgen
