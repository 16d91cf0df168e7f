// Runs of a model or scene in time by all steps that can be emitted, as a table.
#pragma once

#include "cli/options.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen::cli {

struct RunRequest {
  std::string path = {};  ///< as the command line has it
  Inputs inputs = {};
  double time = 0;
};

/// Not judged. Warnings of the model are among the diagnostics; methods that are not for the system
/// are named in a sentence. E621, E623, E624 of the reference, and what its stages say of a model.
/// Cost: a derivation and a compilation for each method and order.
[[nodiscard]] Result<TradeoffTable> measured_runs(const RunRequest& request, const Limits& limits);

}  // namespace elgen::cli
