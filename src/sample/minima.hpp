// minima: places at which a potential energy V(q) is stationary; with constraints f(q) = 0,
// stationary among the places that satisfy them. All terms may vanish there, and code may lose
// digits that it keeps elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "elgen/domain.hpp"
#include "elgen/real.hpp"

namespace elgen {

/// V, and dV/dx for each searched coordinate x. find_minima() adds f, and df/dx row by row.
struct PotentialValues {
  Real potential = {};
  std::vector<Real> slopes = {};
  std::vector<Real> residuals = {};
  std::vector<Real> jacobian = {};
};

/// The values at the coordinates q; none if they are undefined.
using PotentialFunction = std::function<std::optional<PotentialValues>(const std::vector<Real>& q)>;

/// The search starts at no more than this many states of its domain.
inline constexpr std::size_t most_drawn_starts = 5;

/// The coordinates q of at most three places inside the declared ranges, or of one place if a
/// searched coordinate is unbounded; the lowest V first. Only the coordinates `searched` change, no
/// components of quaternions; all others stay as in the first state of `domain`. Newton's method
/// starts at most eight times: at the origin, at typed values at which V is stationary (0,
/// parameters in the unit of a coordinate; 1 and 1/2 for ratios), the declared start, each
/// [[equilibrium]], and the first most_drawn_starts states. A start on an axis of symmetry may lead
/// to a saddle. All numbers have 64 digits and rounds are counted, so that all machines find the
/// same places. None if constraints restrict positions, and coordinates and constraints are more
/// than eight. Cost: at most 256 evaluations of V for typed values, and 40 rounds from each start;
/// a round evaluates V once, and after a step once more for each coordinate.
[[nodiscard]] std::vector<std::vector<double>> find_minima(
    const PotentialFunction& potential, const std::vector<std::uint32_t>& searched,
    const Domain& domain);

}  // namespace elgen
