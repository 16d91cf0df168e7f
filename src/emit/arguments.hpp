// arguments: which arguments an emitted function takes, and how its leaves are read from them.
//
//     inverse_dynamics, time occurs   ->   p, q, v, a, t
//     parameter l[3], coordinate x    ->   l[2] of p, q[0]
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

enum class Argument : std::uint8_t {
  parameters,
  coordinates,
  velocities,
  accelerations,
  inputs,
  time
};

/// Those of the output table, in one order: parameters, q, then v, a, u and t as far as the
/// function takes them.
[[nodiscard]] std::vector<Argument> arguments_of(const Model& model, const Function& function);

/// By argument, in their order.
inline constexpr std::array<std::string_view, 6> argument_names{"p", "q", "v", "a", "u", "t"};

[[nodiscard]] constexpr std::string_view argument_name(Argument argument) {
  return argument_names[static_cast<std::size_t>(argument)];
}

/// How many numbers it holds; one for time.
[[nodiscard]] std::size_t argument_size(const Model& model, Argument argument);

/// "m", "l[2]": the member of the emitted parameters that each parameter leaf is.
[[nodiscard]] std::vector<std::string> parameter_members(const Model& model,
                                                         const LeafNames& leaves);

/// The one that a leaf is read from; none for what is no leaf.
[[nodiscard]] std::optional<Argument> argument_of(Opcode opcode);

/// "q[0]", "t": a leaf that is no parameter.
[[nodiscard]] std::string variable_text(const Instruction& instruction);

}  // namespace elgen
