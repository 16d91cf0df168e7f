// Player: a page that moves, for people who would rather look than read: one file of HTML that a
// browser opens without a network, with the emitted equations in JavaScript and what it needs to
// draw the system and to integrate it.
#pragma once

#include <string>

#include "elgen/pipeline.hpp"
#include "elgen/simulate.hpp"

namespace elgen {

/// The run that the page opens with: rk4, verlet or midpoint in steps of one length.
/// E620 for another method, E621 for too many steps, E647 for another order, E913 with `every` or
/// `hold`.
[[nodiscard]] Diagnostics refuse_player(const SimulationOptions& options);

/// The options by which derived_for_run makes the program of the page: JavaScript, with the outputs
/// that it shows.
[[nodiscard]] PipelineOptions player_pipeline(PipelineOptions options);

/// The page of a run: `moving` has the program of derived_for_run, `read` what is read beside it:
/// steps, equilibria and modes, as far as there are some. The same bytes everywhere. E538 where no
/// start meets the constraints, E7xx for names, E916 beyond limits.page_bytes.
[[nodiscard]] Result<std::string> player_page(const Products& moving, const Products& read,
                                              const SimulationOptions& options,
                                              const Limits& limits);

}  // namespace elgen
