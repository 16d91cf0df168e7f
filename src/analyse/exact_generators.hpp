// The symmetries of generic parameters: the conditions on a generator as closed forms, of which
// every monomial in q, v, a and t has to vanish by itself.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "analyse/generators.hpp"
#include "forms/present/arithmetic.hpp"
#include "numbers/echelon.hpp"

namespace elgen {

/// Closed forms as the numbers of generators.hpp and of Echelon; none beyond the budget. The best
/// pivot stands in the shortest row.
class FormField {
 public:
  using Number = Value;
  using Candidates = std::vector<PivotCandidate<Value>>;
  static constexpr EchelonForm form = EchelonForm::reduced;

  explicit FormField(Algebra& algebra, std::size_t most_work = work, std::size_t most_terms = terms)
      : arithmetic_(algebra, most_work, most_terms) {}

  [[nodiscard]] Value integer(int value) const { return fraction_of(cln::cl_RA(value)); }
  [[nodiscard]] Value add(const Value& x, const Value& y) { return arithmetic_.add(x, y); }
  [[nodiscard]] Value multiply(const Value& x, const Value& y) {
    return arithmetic_.multiply(x, y);
  }
  [[nodiscard]] Value negate(const Value& x) const { return arithmetic_.negate(x); }
  [[nodiscard]] Value divide(const Value& x, const Value& y) { return arithmetic_.divide(x, y); }
  [[nodiscard]] Value reduce(const Value& x, const Value& factor, const Value& y) {
    return add(x, negate(multiply(factor, y)));
  }
  [[nodiscard]] bool is_zero(const Value& x) const { return x && x->numerator.empty(); }
  [[nodiscard]] bool is_defined(const Value& x) const { return x.has_value(); }
  [[nodiscard]] const PivotCandidate<Value>* best(const Candidates& candidates, std::size_t) const {
    return &*std::ranges::min_element(candidates, {}, &PivotCandidate<Value>::length);
  }
  [[nodiscard]] Value leaf(Opcode kind, std::uint32_t index) {
    return arithmetic_.leaf(kind, index);
  }

 private:
  static constexpr std::size_t work = 4'000'000;  ///< term products: below two seconds
  static constexpr std::size_t terms = 60'000;
  Arithmetic arithmetic_;
};

/// The leaves as they are, with R.
[[nodiscard]] MotionPoint<Value> leaf_point(FormField& field, const Model& model,
                                            const std::vector<Value>& residual);

/// Generators over the parameters.
struct ExactGenerators {
  std::vector<std::vector<Fraction>> basis = {};
  /// No relation joins the functions that occur, if the root is not that of a square: there are no
  /// other generators. They are leaves, sines, cosines and at most one root.
  bool is_complete = false;
  bool has_root = false;
};

/// Solves dR + A^T R = 0 for closed forms. None for models with rotations, and none beyond the
/// budget. Cost: 3 n + 1 derivatives of R, and an elimination over fractions of polynomials.
[[nodiscard]] std::optional<ExactGenerators> exact_generators(ClosedForms& forms,
                                                              const Model& model,
                                                              const OpenTerms& open_values,
                                                              const std::vector<Value>& residual);

}  // namespace elgen
