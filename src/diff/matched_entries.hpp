// matched_entries: entries that mean the same in two versions: of M those of the same two
// coordinates, wherever they stand.
#pragma once

#include <optional>
#include <vector>

#include "elgen/diff.hpp"

namespace elgen {

/// An entry, numbered over all fields, of either version.
struct MatchedEntry {
  std::optional<std::size_t> before = {};
  std::optional<std::size_t> after = {};
  std::string place = {};  ///< "mass_matrix[1,2]": of the newer version where it is there
  std::string unit = {};
};

/// The entries of two functions of one name, in the order of `after`; removed ones last. Nothing
/// matches an empty function.
[[nodiscard]] std::vector<MatchedEntry> matched_entries(const Model& old_model,
                                                        const Function& before,
                                                        const Model& new_model,
                                                        const Function& after,
                                                        const Renames& renames);

}  // namespace elgen
