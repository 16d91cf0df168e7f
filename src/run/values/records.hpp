// records: a function at a state, as the oracle has it.
#pragma once

#include <string>
#include <string_view>

#include "elgen/values.hpp"

namespace elgen {

/// A table of the outputs of a scene, those that hold others left out, without records.
[[nodiscard]] ValueTable table_of(const CheckedModel& checked, int digits);

/// E521 if the function has no value at the state, or its digits do not tell the value.
[[nodiscard]] Result<ValueRecord> record_at(const ValueTable& table, std::size_t function,
                                            std::string place, const State& state);

/// E521 of an output or input without settled values.
[[nodiscard]] Diagnostic no_value(std::string_view name, const Span& span,
                                  const SettledValues& settled);

}  // namespace elgen
