// parameters: which parameters of a Model the emitted code takes, and what it says of them.
#pragma once

#include <cstddef>
#include <string>

#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Parameters that stay run-time parameters: not all of their elements are fixed by the scene.
[[nodiscard]] bool is_emitted(const ParameterArray& array, const Scene& scene);

/// The scalars in them.
[[nodiscard]] std::size_t emitted_parameter_count(const Model& model, const Scene& scene);

/// "cart mass [kg] in [0, 2]"; the name where nothing is known of it.
[[nodiscard]] std::string parameter_doc(const ParameterArray& array);

}  // namespace elgen
