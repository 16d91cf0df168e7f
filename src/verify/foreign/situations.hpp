// Situations: at rest, moving, driven and so on. The situations in which code is wrong show its
// mistake.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "elgen/foreign.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// States take turns in the situations. `driven`: with inputs and accelerations, but without rates.
enum class Situation : std::uint8_t { whole, rest, driven, moving, varied };
inline constexpr std::size_t situation_count = 5;

/// The drawn states at which foreign code is called.
struct ForeignStates {
  std::vector<Arguments<double>> values = {};
  std::vector<Situation> situations = {};
  std::size_t unmet = 0;  ///< skipped: no step of Newton's method reaches the constraints
};

/// The drawn states for an output; `is_moved`: moved onto the constraints.
[[nodiscard]] ForeignStates states_of(const Subject& subject, const ForeignOptions& options,
                                      OutputKind output, bool is_moved);

/// "inputs", "accelerations" or both: the ones that the output takes.
[[nodiscard]] std::string_view drive_of(const OutputRequest& output);

/// For each parameter that no scene fixes, appends a copy of the first state with another value of
/// this parameter. Returns these parameters.
[[nodiscard]] std::vector<std::uint32_t> add_changed_parameters(
    const Subject& subject, std::vector<Arguments<double>>& states);

}  // namespace elgen
