// equations: Lagrange's equations as sums in the order of a book, and what they say of the
// accelerations.
//
//     d/dt dL/dv - dL/dq + dD/dv = Q
//
// Summands of L whose part of a row holds rates or accelerations are added up, since books give
// each product of rates one coefficient. The other summands stand alone.
#pragma once

#include <optional>
#include <vector>

#include "forms/present/arithmetic.hpp"
#include "forms/typeset/arrange.hpp"

namespace elgen {

/// The row of a velocity, from its function (elgen/steps.hpp).
struct EquationRow {
  std::vector<Fraction> inertia = {};  ///< d/dt dL/dv - dL/dq, summand by summand
  std::vector<Fraction> dissipation = {};
  Fraction force = {};
};

/// Arranges rows; new atoms are added to the algebra.
class Equations {
 public:
  Equations(Algebra& algebra, Arranger& arranger)
      : algebra_(algebra), arithmetic_(algebra), arranger_(arranger) {}

  /// None where a form is missing.
  [[nodiscard]] std::optional<EquationRow> row(const ClosedFunction& function);

  /// Each summand for itself; nothing where they are 0 together.
  [[nodiscard]] BookSum each(const std::vector<Fraction>& summands) {
    return arranger_.each_in_front(settled(summands));
  }
  /// In the order of a row; `own` is its velocity. Dissipation stands behind what moves.
  [[nodiscard]] BookSum arranged(std::vector<Fraction> summands, std::uint32_t own,
                                 const std::vector<Fraction>& dissipation = {});
  /// d/dt dL/dv - dL/dq + dD/dv.
  [[nodiscard]] BookSum left(const EquationRow& row, std::uint32_t own) {
    return arranged(row.inertia, own, row.dissipation);
  }

  /// The acceleration where its row holds no other, or one other whose row holds no third.
  [[nodiscard]] std::optional<BookSum> solved(const std::vector<std::optional<EquationRow>>& rows,
                                              std::uint32_t own);

 private:
  /// M a = rest of a row.
  struct Linear;

  [[nodiscard]] std::vector<Fraction> settled(const std::vector<Fraction>& summands);
  [[nodiscard]] Fraction total(const std::vector<Fraction>& summands);
  [[nodiscard]] std::optional<Linear> linear(const std::optional<EquationRow>& row);
  [[nodiscard]] BookSum divided_terms(const EquationRow& row, const Fraction& inertia,
                                      std::uint32_t own);

  Algebra& algebra_;
  Arithmetic arithmetic_;
  Arranger& arranger_;
};

}  // namespace elgen
