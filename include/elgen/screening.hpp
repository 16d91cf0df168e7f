// Screening: states by the million in 50 digits, to find the thousand that are worth a visit in
// 60-digit arithmetic, in as many processes as there are cores, or on as many machines.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/shard.hpp"
#include "elgen/toolchain.hpp"

namespace elgen {

/// All of so many random states are visited; of more only the worst.
inline constexpr std::size_t most_visited_samples = 2000;
/// The first states, of every region, and the worst of all others.
inline constexpr std::size_t visits_after_screening = 1000;

struct ScreenedFigure {
  std::uint64_t state = 0;  ///< its number among all states of a seed
  double figure = 0;
  friend bool operator==(const ScreenedFigure&, const ScreenedFigure&) = default;
};

/// Those of one scalar.
struct ScreenedStates {
  ScalarKind scalar = ScalarKind::double_precision;
  std::uint64_t states = 0;  ///< that were looked at
  /// Of each figure of each field (figures_per_field) the largest, largest first, of equal ones the
  /// first states; at most visits_after_screening.
  std::vector<std::vector<ScreenedFigure>> worst = {};
  friend bool operator==(const ScreenedStates&, const ScreenedStates&) = default;
};
using Screening = std::vector<ScreenedStates>;

struct ScreeningOptions {
  std::size_t samples = 0;  ///< random states; the extremes are screened too
  std::uint64_t seed = 1;
  Shard shard = {};           ///< every count-th state, from its number on
  std::size_t jobs = 1;       ///< processes
  std::uint64_t seconds = 0;  ///< of processor time that each may use: what a message says of it
  /// Told of each step: "screening in double, 12 % of 1000334 states".
  std::function<void(const std::string&)> on_step = {};
};

/// In double, and in float where the model fits it. The same whatever the number of jobs. E710: a
/// process failed; E909: one took longer than it may. Cost: a double pendulum in all
/// its outputs takes about 1 ms a state.
[[nodiscard]] Result<Screening> screen(const Model& model, const Scene& scene,
                                       const Program& program, const ScreeningCode& code,
                                       const ScreeningOptions& options);

/// Of all shards what one process finds.
[[nodiscard]] Screening joined(const std::vector<Screening>& shards);

/// The numbers of the states to visit, ascending: the first, then the worst of each figure of each
/// field in turn, the second of each, and so on.
[[nodiscard]] std::vector<std::uint64_t> states_to_visit(const ScreenedStates& screened);

}  // namespace elgen
