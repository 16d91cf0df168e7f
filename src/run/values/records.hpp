// records: the values of a function at a state, by the oracle.
#pragma once

#include <string>
#include <string_view>

#include "elgen/values.hpp"

namespace elgen {

/// A table of the outputs of a scene, without records. Outputs that repeat others are omitted.
[[nodiscard]] ValueTable table_of(const CheckedModel& checked, int digits);

/// E521 if the function has no value at the state, or the digits do not determine it.
[[nodiscard]] Result<ValueRecord> record_at(const ValueTable& table, std::size_t function,
                                            std::string place, const State& state);

/// E521 for an output or input without settled values.
[[nodiscard]] Diagnostic no_value(std::string_view name, const Span& span,
                                  const StableValues& settled);

}  // namespace elgen
