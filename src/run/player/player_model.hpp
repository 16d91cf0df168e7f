// player_model_json: the data of a system, as JSON, for the page's script. The functions of the
// system are a separate script.
#pragma once

#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "elgen/real.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// A start at rest, for which the page has a button.
struct ShownStart {
  std::string name = {};  ///< "At rest: theta = 0 (stable)", "Mode of 4.43 rad/s: theta = 0"
  std::vector<double> q = {};
};

/// The equilibria. For models without rotations, also each equilibrium plus 0.1 times the shape of
/// each normal mode with omega^2 > 0. At most 12 starts.
[[nodiscard]] std::vector<ShownStart> shown_starts(const Model& model, const Products& read);

/// Names, units, starts, places, laws and equilibria as JSON. `<` is escaped, because the JSON is
/// written into an HTML page.
[[nodiscard]] std::string player_model_json(const CheckedModel& checked, const Program& program,
                                            const Products& read, const SimulationOptions& options);

}  // namespace elgen
