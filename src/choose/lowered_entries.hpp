// lowered_entries: the entries of a function as instructions.
#pragma once

#include "choose/entries.hpp"
#include "lower/graph/angle_sums.hpp"

namespace elgen {

/// All entries over one graph, as they are read or in their shortest forms, whichever is cheaper.
/// `shape` says which they are; `program` gets their constants.
[[nodiscard]] Function lowered_together(const ReadableEntries& entries, const Function& shape,
                                        Program& program, Splits splits);

/// As they are read, entry by entry, so that nothing is taken apart for what another entry shares.
[[nodiscard]] Function lowered_one_by_one(const ReadableEntries& entries, const Function& shape,
                                          Program& program);

}  // namespace elgen
