// Own bound: how far a program may be from the truth by rounding alone, run along the program
// itself.
#pragma once

#include <vector>

#include "accuracy/bounded.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// The numerical regime of a function at one state.
enum class Regime : std::uint8_t {
  regular,
  undefined,        ///< an intermediate has no value (1/0, sqrt(-1))
  overflow,         ///< an exact intermediate exceeds max/16 of the scalar
  ill_conditioned,  ///< a divisor or radicand is uncertain by more than a tenth: no first-order
                    ///< bound
  unsettled,        ///< 1000 digits do not tell whether the exact value is the oracle's
};

/// An undefined value outweighs an overflow, and that a lost bound.
[[nodiscard]] Regime worse(Regime x, Regime y);

struct BoundedRun {
  Regime regime = Regime::regular;
  std::vector<Bound> entries = {};  ///< of all fields
  Real largest = {};                ///< magnitude of the largest intermediate
};

/// Runs exact values and bounds along a function; along a step, and where
/// constraints are solved for, by RunningBoundRules.
/// `accelerations`, where there are some, take the place of the state's, and may be known to their
/// bounds only.
[[nodiscard]] BoundedRun bounded_run(const Program& program, const Function& function,
                                     const State& state, const Rounding& rounding,
                                     const std::vector<Bound>& accelerations = {});

/// The closed form's bound, but the code's own where the code underflows on the way: what is lost
/// there grows by what multiplies it afterwards, which the closed form does not know.
[[nodiscard]] const Bound& judging_bound(const Bound& own, const Bound& closed);

/// B, grown to n B/8 where n > 8 roundings meet in the entry, such that 8 u of it cover all of
/// them.
[[nodiscard]] Real covering_bound(const Bound& entry);

/// |x - exact| less `operations` times the smallest denormal, which underflow may cost; undefined
/// where x is not a number.
[[nodiscard]] Real excess_error(double x, const Real& exact, std::size_t operations,
                                const Rounding& rounding);

/// excess/(u bound): 0 where there is no excess, infinite where it has no value or the bound is 0.
[[nodiscard]] double in_bounds(const Real& excess, const Real& bound, const Rounding& rounding);

/// |x - exact| / (u B), B the covering bound, less what underflow may cost.
[[nodiscard]] double error_in_bounds(double x, const Bound& entry, std::size_t operations,
                                     const Rounding& rounding);

}  // namespace elgen
