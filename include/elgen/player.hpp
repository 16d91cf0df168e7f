// Player: an interactive page, one HTML file that a browser opens without a network. It contains
// the emitted equations in JavaScript, and scripts that integrate them and draw the system.
#pragma once

#include <string>

#include "elgen/pipeline.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// The errors in `options` if the run is for a page. E620: unknown method. E621: too many steps.
/// E647: another order. E913: `row_interval` or `input_hold_time` is set.
[[nodiscard]] Diagnostics check_player_options(const SimulationOptions& options);

/// `options`, changed so that derive_for_run() makes the program of a page: in JavaScript, with the
/// outputs that a page shows.
[[nodiscard]] PipelineOptions player_pipeline_options(PipelineOptions options);

/// The page of a run as HTML. `run_products` has the program of derive_for_run(); `shown_products`
/// has the results to display: steps, equilibria and modes, if any. The bytes are the same on every
/// machine. E538: no start satisfies the constraints. E7xx: as emit(). E916: more than
/// limits.page_bytes.
[[nodiscard]] Result<std::string> player_page(const Products& run_products,
                                              const Products& shown_products,
                                              const SimulationOptions& options,
                                              const Limits& limits);

}  // namespace elgen
