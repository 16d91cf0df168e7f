// Situations: at rest, moving, driven and so on. Those in which code is wrong say what is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "elgen/foreign.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {

/// States take turns in them; `driven`: with inputs and accelerations, but without rates.
enum class Situation : std::uint8_t { whole, rest, driven, moving, varied };
inline constexpr std::size_t situation_count = 5;

/// The drawn states at which code is called.
struct ForeignStates {
  std::vector<Arguments<double>> values = {};
  std::vector<Situation> situations = {};
  std::size_t unmet = 0;  ///< states left out: no step of Newton puts them on the constraints
};

/// The drawn states for an output; `is_moved`: moved onto the constraints.
[[nodiscard]] ForeignStates states_of(const Subject& subject, const ForeignOptions& options,
                                      OutputKind output, bool is_moved);

/// "inputs", "accelerations": what an output takes of both.
[[nodiscard]] std::string_view drive_of(const OutputRequest& output);

/// Appends a copy of the first state for each parameter that no scene fixes, with another value of
/// that parameter. Returns these parameters.
[[nodiscard]] std::vector<std::uint32_t> add_changed_parameters(
    const Subject& subject, std::vector<Arguments<double>>& states);

}  // namespace elgen
