// arguments: which arguments an emitted function takes, and how its leaves are read from them.
//
//     inverse_dynamics, time occurs   ->   p, q, v, a, t
//     parameter l[3], coordinate x    ->   l[2] of p, q[0]
#pragma once

#include <cstdint>
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

/// "p", "q", "v", "a", "u", "t"
[[nodiscard]] std::string_view argument_name(Argument argument);

/// How many numbers it holds; one for time.
[[nodiscard]] std::size_t argument_size(const Model& model, Argument argument);

/// "m", "l[2]": the member of the emitted parameters that each parameter leaf is.
[[nodiscard]] std::vector<std::string> parameter_members(const Model& model,
                                                         const LeafNames& leaves);

/// "q[0]", "t": a leaf that is no parameter.
[[nodiscard]] std::string variable_text(const Instruction& instruction);

/// True where `word` stands in `text` as an identifier of its own: not as a member or part of a
/// name.
[[nodiscard]] bool mentions(std::string_view text, std::string_view word);

}  // namespace elgen
