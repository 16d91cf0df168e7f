// parameters: which parameters of a Model the emitted code takes, and what it calls and says of
// them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Those that a function of the program reads, whole arrays of them: a parameter that the scene has
/// fixed, or whose terms are not asked for, is no argument.
[[nodiscard]] std::vector<ParameterArray> emitted_parameters(const Model& model,
                                                             const Program& program);

/// "m", "l[2]": the member of the emitted parameters that each parameter leaf is.
[[nodiscard]] std::vector<std::string> parameter_members(const Model& model,
                                                         const LeafNames& leaves);

/// The scalars in them.
[[nodiscard]] std::size_t emitted_parameter_count(const Model& model, const Program& program);

/// "cart mass [kg] in [0, 2]"; the name where nothing is known of it.
[[nodiscard]] std::string parameter_doc(const ParameterArray& array);

}  // namespace elgen
