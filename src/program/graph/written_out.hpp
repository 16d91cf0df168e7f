// written_out: how long entries are where nothing is shared.
#pragma once

#include <cstddef>
#include <vector>

#include "elgen/program.hpp"

namespace elgen {

/// Operations of each instruction written out over the leaves alone: functions of functions double
/// with every level. Counted up to just beyond `most`.
[[nodiscard]] std::vector<std::size_t> written_out_sizes(const Function& function,
                                                         std::size_t most);

}  // namespace elgen
