// cpp_artifacts: the C++17 headers, on arrays, on Eigen's matrices and on arrays of states.
#pragma once

#include <string>

#include "emit/text/emission_input.hpp"

namespace elgen {

// Texts with their body hash.
[[nodiscard]] std::string cpp_header(const EmissionInput& input);
[[nodiscard]] std::string eigen_header(const EmissionInput& input);
[[nodiscard]] std::string batch_header(const EmissionInput& input);

// E701 for parameters, functions and namespaces whose name the emitted code needs.
[[nodiscard]] Diagnostics cpp_check_names(const Model& model, const Scene& scene,
                                          const Program& program);
[[nodiscard]] Diagnostics eigen_check_names(const Model& model, const Scene& scene,
                                            const Program& program);
[[nodiscard]] Diagnostics batch_check_names(const Model& model, const Scene& scene,
                                            const Program& program);

}  // namespace elgen
