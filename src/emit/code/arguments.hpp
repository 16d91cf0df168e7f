// arguments: how leaves are read from the arguments of an emitted function.
//
//     parameter l[3], coordinate x    ->   l[2] of p, q[0]
#pragma once

#include <string>
#include <vector>

#include "elgen/arguments.hpp"

namespace elgen {

/// "m", "l[2]": the member of the emitted parameters that each parameter leaf is.
[[nodiscard]] std::vector<std::string> parameter_members(const Model& model,
                                                         const LeafNames& leaves);

/// "q[0]", "t": a leaf that is no parameter.
[[nodiscard]] std::string variable_text(const Instruction& instruction);

}  // namespace elgen
