// records: the oracle's values of an output at a state.
#pragma once

#include <string>
#include <string_view>

#include "elgen/values.hpp"

namespace elgen {

/// A table of the scene's outputs, still without records. Omits `dynamics`, which repeats other
/// outputs.
[[nodiscard]] ValueTable table_of(const CheckedModel& checked, int digits);

/// The values of table.functions[function] at `state`. E521 if the output is undefined at the
/// state, or if the largest number of digits does not decide its values.
[[nodiscard]] Result<ValueRecord> record_at(const ValueTable& table, std::size_t function,
                                            std::string place, const State& state);

/// E521: the output or input `name` is undefined, or undecided.
[[nodiscard]] Diagnostic no_value(std::string_view name, const Span& span,
                                  const StableValues& settled);

}  // namespace elgen
