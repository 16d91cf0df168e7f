// records: a function at a state, as the oracle has it.
#pragma once

#include <optional>

#include "elgen/values.hpp"

namespace elgen {

/// A table of the outputs of a scene, those that hold others left out, without records.
[[nodiscard]] ValueTable table_of(const CheckedModel& checked, int digits);

/// None where the function has no value at the state.
[[nodiscard]] std::optional<ValueRecord> record_at(const ValueTable& table, std::size_t function,
                                                   std::string place, const State& state);

}  // namespace elgen
