// The symmetries for generic parameters. The conditions on a generator are closed forms, and the
// coefficient of each monomial in q, v, a and t in these forms must be 0.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "analyse/generators.hpp"
#include "forms/present/arithmetic.hpp"
#include "numbers/echelon.hpp"

namespace elgen {

/// Closed forms as the number type of generators.hpp and of Echelon. A form that exceeds the budget
/// becomes none. The pivot of a column is in the shortest row.
class FormField : public Arithmetic {
 public:
  using Number = OptionalFraction;
  using Candidates = std::vector<PivotCandidate<OptionalFraction>>;
  static constexpr EchelonForm form = EchelonForm::reduced;

  /// `work`: limit of term products; the default takes less than two seconds. `terms`: limit of
  /// terms in a form.
  explicit FormField(Algebra& algebra, std::size_t work = 4'000'000, std::size_t terms = 60'000)
      : Arithmetic(algebra, work, terms) {}

  [[nodiscard]] static OptionalFraction integer(int value) {
    return fraction_of(cln::cl_RA(value));
  }
  [[nodiscard]] OptionalFraction subtract_product(const OptionalFraction& x,
                                                  const OptionalFraction& factor,
                                                  const OptionalFraction& y) {
    return subtract(x, multiply(factor, y));
  }
  [[nodiscard]] static bool is_zero(const OptionalFraction& x) { return x && x->numerator.empty(); }
  [[nodiscard]] static bool is_defined(const OptionalFraction& x) { return x.has_value(); }
  [[nodiscard]] static const PivotCandidate<OptionalFraction>* best_pivot(
      const Candidates& candidates, std::size_t) {
    return &*std::ranges::min_element(candidates, {}, &PivotCandidate<OptionalFraction>::length);
  }
};

/// The point of a motion whose q, v, a and t are the leaves and whose R is `residual`.
[[nodiscard]] MotionPoint<OptionalFraction> symbolic_motion_point(
    FormField& field, const Model& model, const std::vector<OptionalFraction>& residual);

/// Generators with coefficients in the parameters.
struct ExactGenerators {
  std::vector<std::vector<Fraction>> basis = {};
  /// True if no other generators exist, because the functions in the equations (leaves, sines,
  /// cosines and at most one root) are independent. If `has_root`, the independence is not proved,
  /// since the root may be the root of a square.
  bool is_complete = false;
  bool has_root = false;
};

/// Solves dR + A^T R = 0 in closed form. None for models with rotations, or if the budget is
/// exceeded. Cost: 3 n + 1 derivatives of R, and an elimination over fractions of polynomials.
[[nodiscard]] std::optional<ExactGenerators> exact_generators(
    ClosedForms& forms, const Model& model, const OpenValueRates& open_values,
    const std::vector<OptionalFraction>& residual);

}  // namespace elgen
