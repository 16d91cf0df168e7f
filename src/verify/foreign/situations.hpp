// Situations: states in five of them, so that the states at which code is wrong say what is wrong.
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

/// The drawn states that code is called at. Behind them others may follow.
struct ForeignStates {
  std::vector<Arguments<double>> values = {};
  std::vector<Situation> situations = {};
  std::size_t unmet = 0;  ///< how many states are not among them: off the constraints
};

/// The drawn states for an output; `is_moved`: moved onto the constraints.
[[nodiscard]] ForeignStates states_of(const Subject& subject, const ForeignOptions& options,
                                      OutputKind output, bool is_moved);

/// "inputs", "accelerations": what an output takes of both.
[[nodiscard]] std::string_view drive_of(const OutputRequest& output);

/// Appends for each parameter that may vary the first state with another value of it.
[[nodiscard]] std::vector<std::uint32_t> add_changed_parameters(
    const Subject& subject, std::vector<Arguments<double>>& states);

}  // namespace elgen
