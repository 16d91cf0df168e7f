// Situations: the states at which foreign code is called, in groups such as "at rest" or "moving".
// The groups in which the code is wrong show its mistake.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "elgen/foreign.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// The kinds of states, used in turn:
///
///     general            velocities, accelerations and inputs are random
///     rest               velocities, momenta, accelerations and inputs are 0
///     driven             velocities and momenta are 0
///     moving             accelerations and inputs are 0
///     varied_parameters  as general, with parameters between half and twice their values
enum class Situation : std::uint8_t { general, rest, driven, moving, varied_parameters };
inline constexpr std::size_t situation_count = 5;

/// The states at which foreign code is called.
struct ForeignStates {
  std::vector<Arguments<double>> values = {};
  std::vector<Situation> situations = {};
  std::size_t unmet = 0;  ///< states without a projection onto the constraints; skipped
};

/// The states drawn for an output; if `is_moved`, projected onto the constraints.
[[nodiscard]] ForeignStates draw_foreign_states(const SystemUnderTest& subject,
                                                const ForeignOptions& options, OutputKind output,
                                                bool is_moved);

/// "inputs", "accelerations" or "inputs or accelerations", whichever the output takes; "inputs" if
/// it takes neither.
[[nodiscard]] std::string_view drive_text(const OutputRequest& output);

/// For each parameter that the scene does not fix, appends a copy of the first state; in the copy,
/// this parameter has another value. Returns the parameters.
[[nodiscard]] std::vector<std::uint32_t> add_parameter_variations(
    const SystemUnderTest& subject, std::vector<Arguments<double>>& states);

}  // namespace elgen
