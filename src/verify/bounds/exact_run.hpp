// Exact runs: evaluate a function in 64 digits at one state. Each value has a running error E, a
// bound on the rounding errors that the same run has in the scalar (accuracy/running_errors.hpp).
#pragma once

#include <vector>

#include "accuracy/running_errors.hpp"
#include "elgen/scene.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// The numerical regime of a function at one state.
enum class Regime : std::uint8_t {
  regular,
  undefined,        ///< an intermediate has no value (1/0, sqrt(-1))
  overflow,         ///< an exact intermediate, or its rounding, exceeds max/16 of the scalar
  ill_conditioned,  ///< a divisor, radicand or argument is uncertain by > 1/1000: E is no bound
  unsettled,        ///< no run with more digits decides if the exact value equals the oracle's
};

/// The worse of both; from the worst: undefined, overflow, ill_conditioned, unsettled, regular.
[[nodiscard]] Regime worse_regime(Regime x, Regime y);

struct ExactRun {
  Regime regime = Regime::regular;
  std::vector<RunningValue<Real>> values = {};   ///< of all instructions
  std::vector<RunningValue<Real>> entries = {};  ///< of all fields
};

[[nodiscard]] ExactRun run_exactly(const Program& program, const Function& function,
                                   const State& state, const RoundingConstants<Real>& rounding);

/// An exact run of a step whose accelerations are in float (Instruction::is_inner). Values of both
/// scalars have their own roundings. E of the entries is in u of double, so a rounding in float
/// counts as 2^29. The sum x + 0 counts as exact: a step of length 0 has E = 0. If `packs` is not
/// null, sines and cosines have the errors and the domain of packs.
[[nodiscard]] ExactRun run_mixed_exactly(const Program& program, const Function& function,
                                         const State& state, const Numerics* packs);

/// max(0, |x - exact| - operations eta), eta the smallest denormal: each operation that underflows
/// may have an error of eta. Undefined if x is not finite.
[[nodiscard]] Real excess_error(double x, const Real& exact, std::size_t operations,
                                const RoundingConstants<Real>& rounding);

/// excess/(u scale), u the unit roundoff. 0 if the excess is 0; infinite if the excess is undefined
/// or the scale is 0.
[[nodiscard]] double error_in_roundoffs(const Real& excess, const Real& scale,
                                        const RoundingConstants<Real>& rounding);

}  // namespace elgen
