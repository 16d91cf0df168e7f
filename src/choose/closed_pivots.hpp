// closed_pivots: the pivots of an elimination by their closed forms.
//
//     before  D_2 = M_22 - M_12*M_12/M_11
//     after   D_2 = (m1 + m2 sin(q1 - q2)^2)/(m1 + m2)*M_22
//
// The first has no right digit where the links are aligned and one mass is far smaller.
// Solutions are divided by the pivots. The closed forms of these are those of the relative pivots
// D_i/M_ii of forward_dynamics.
#pragma once

#include <vector>

#include "choose/precise.hpp"

namespace elgen {

struct ClosedPivot {
  std::size_t velocity = 0;
  Expressions relative = {};  ///< D_i/M_ii
  Expressions diagonal = {};  ///< M_ii
};

/// The pivots that `forward_dynamics` loses digits of, and that have closed forms which keep them.
[[nodiscard]] std::vector<ClosedPivot> closed_pivots(const Program& program,
                                                     const Function& forward_dynamics,
                                                     const ClosedForms& forms,
                                                     const ClosedFunction& closed,
                                                     const ComparisonPoints& points);

/// The recursive `function` with its pivots replaced; they are found by their values, which
/// `forward_dynamics` of the same program gives. As it was where it has none of them. `program` may
/// get more constants.
[[nodiscard]] Function with_closed_pivots(const Function& function,
                                          const Function& forward_dynamics,
                                          const std::vector<ClosedPivot>& pivots, Program& program);

}  // namespace elgen
