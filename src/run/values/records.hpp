// records: the oracle's values of an output at a state.
#pragma once

#include <string>
#include <string_view>

#include "elgen/values.hpp"

namespace elgen {

/// A table of the scene's outputs, still without records. Omits `dynamics`, which repeats other
/// outputs.
[[nodiscard]] ValueTable make_value_table(const CheckedModel& checked, int digits);

/// The values of table.functions[function] at `state`. E521 if the output is undefined at the
/// state, or if the largest number of digits does not decide its values.
[[nodiscard]] Result<ValueRecord> make_value_record(const ValueTable& table, std::size_t function,
                                                    std::string place, const State& state);

/// E521: the output or input `name` is undefined, or undecided.
[[nodiscard]] Diagnostic no_value_error(std::string_view name, const Span& span,
                                        const StableValues& settled);

}  // namespace elgen
