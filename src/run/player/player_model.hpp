// player_model_json: the data of a system, as JSON, for the page's script. The functions of the
// system are a separate script.
#pragma once

#include <string>

#include "elgen/pipeline.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// Names, symbols, units, starts, places, laws and equilibria as JSON. `<` is escaped, because the
/// JSON is written into an HTML page.
[[nodiscard]] std::string player_model_json(const CheckedModel& checked, const Program& program,
                                            const Products& read, const SimulationOptions& options);

}  // namespace elgen
