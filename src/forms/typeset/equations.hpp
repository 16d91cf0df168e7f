// equations: Lagrange's equations as sums in textbook order, and their solutions for accelerations.
//
//     d/dt dL/dv - dL/dq + dD/dv = Q
//
// Summands of L that give rates or accelerations in a row are added up, because textbooks write one
// coefficient per product of rates. Other summands stay separate.
#pragma once

#include <optional>
#include <vector>

#include "forms/present/arithmetic.hpp"
#include "forms/typeset/arrange.hpp"

namespace elgen {

/// Lagrange's equation of one velocity: sum of `inertia` + sum of `dissipation` = `force`.
struct EquationRow {
  std::vector<Fraction> inertia = {};  ///< d/dt dL/dv - dL/dq of each summand of L
  std::vector<Fraction> dissipation = {};
  Fraction force = {};
};

/// Arranges rows. Adds new atoms to the algebra.
class EquationArranger {
 public:
  EquationArranger(Algebra& algebra, Arranger& arranger)
      : algebra_(algebra), arithmetic_(algebra), arranger_(arranger) {}

  /// The row in the closed forms of `function`; none if a closed form is missing.
  [[nodiscard]] std::optional<EquationRow> read_row(const ClosedFunction& function);

  /// Arranges each summand separately; empty if all summands add up to 0.
  [[nodiscard]] TextbookSum arrange_summands(const std::vector<Fraction>& summands) {
    return arranger_.factor_out_each(nonzero_summands(summands));
  }
  /// Arranges the row of velocity `own`. The terms of `dissipation` follow the terms with rates.
  [[nodiscard]] TextbookSum arrange_row(std::vector<Fraction> summands, std::uint32_t own,
                                        const std::vector<Fraction>& dissipation = {});
  /// d/dt dL/dv - dL/dq + dD/dv.
  [[nodiscard]] TextbookSum arrange_left_side(const EquationRow& row, std::uint32_t own) {
    return arrange_row(row.inertia, own, row.dissipation);
  }

  /// The acceleration of velocity `own` as a sum. None if rows[own] contains two other
  /// accelerations, or one other acceleration whose row contains a third acceleration.
  [[nodiscard]] std::optional<TextbookSum> solve_acceleration(
      const std::vector<std::optional<EquationRow>>& rows, std::uint32_t own);

 private:
  /// A row in the form M a = rest.
  struct LinearRow;

  [[nodiscard]] std::vector<Fraction> nonzero_summands(const std::vector<Fraction>& summands);
  [[nodiscard]] Fraction total(const std::vector<Fraction>& summands);
  [[nodiscard]] std::optional<LinearRow> split_accelerations(const std::optional<EquationRow>& row);
  [[nodiscard]] TextbookSum divide_by_inertia(const EquationRow& row, const Fraction& inertia,
                                              std::uint32_t own);

  Algebra& algebra_;
  Arithmetic arithmetic_;
  Arranger& arranger_;
};

}  // namespace elgen
