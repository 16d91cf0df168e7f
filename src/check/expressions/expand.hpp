// Expansion: entries of the file, with their repetitions, become instances that declare names.
#pragma once

#include <cstdint>
#include <vector>

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// One entry of the file for one combination of running indices; `target` is its index in the
/// Model.
struct EntryInstance {
  const EntrySyntax* entry = nullptr;
  IndexScope scope;
  std::uint32_t target = 0;
};

/// Declares every name of the model, so that expressions may refer forward. Appends an empty
/// coordinate, point, … to the Model for each instance. E2xx, E906, E907.
///
///     [[point]] for = "i in 1..2", name = "p[i]"   ->   p[1] with i = 1, p[2] with i = 2
[[nodiscard]] std::vector<EntryInstance> expand_entries(Context& context, const FileSyntax& syntax);

}  // namespace elgen
