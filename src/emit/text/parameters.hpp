// parameters: what the emitted code calls the parameters of a Model, and says of them.
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen {

/// "m", "l[2]": the member of the emitted parameters that each parameter leaf is.
[[nodiscard]] std::vector<std::string> parameter_members(const Model& model,
                                                         const LeafNames& leaves);

/// "cart mass [kg] in [0, 2]"; the name where nothing is known of it.
[[nodiscard]] std::string parameter_doc(const ParameterArray& array);

}  // namespace elgen
