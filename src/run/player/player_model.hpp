// player_model: the data of a system that the page's script reads besides its functions, as JSON.
#pragma once

#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/real.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// A start at rest with a button on the page.
struct ShownStart {
  std::string name = {};  ///< "At rest: theta = 0 (stable)", "Mode of 4.43 rad/s: theta = 0"
  std::vector<double> q = {};
};

/// The equilibria, and starts displaced by 0.1 along their normal modes with omega^2 > 0; 12 at
/// most. Models with rotations have no starts along modes.
[[nodiscard]] std::vector<ShownStart> shown_starts(const Model& model, const Products& read);

/// Names, units, starts, places, laws and equilibria as JSON. `<` is escaped, so that no markup of
/// HTML occurs.
[[nodiscard]] std::string player_model(const CheckedModel& checked, const Program& program,
                                       const Products& read, const SimulationOptions& options);

}  // namespace elgen
