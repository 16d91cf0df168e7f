// What becomes of a table of elgen tradeoff: it is printed, written, and chosen from.
#pragma once

#include <optional>
#include <string>

#include "cli/options.hpp"
#include "elgen/tradeoff.hpp"

namespace elgen::cli {

struct TradeoffOutput {
  std::string as = {};                   ///< what is printed; empty: as --format says
  std::string file = {};                 ///< of the table; empty: none
  std::optional<double> max_error = {};  ///< of the row that is named
  std::string scene_file = {};           ///< of that row; empty: none
  bool force = false;
};

/// E913: an ending that says nothing; E703, E708: what stands in the place of a file.
[[nodiscard]] Diagnostics refuse_output(const TradeoffOutput& output);

/// Of a table that was judged, of designs from `inputs` where a scene is wanted. E632 where no row
/// is within max_error; E706.
ExitCode deliver(const GlobalOptions& global, const TradeoffOutput& output, const Inputs& inputs,
                 const TradeoffTable& table);

}  // namespace elgen::cli
