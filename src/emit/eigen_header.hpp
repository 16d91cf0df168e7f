// eigen_header: EmissionInput -> the functions of the C++ header on types of Eigen, as
// templates/cpp/eigen.hpp.mustache pictures them.
#pragma once

#include <string>

#include "emission_input.hpp"

namespace elgen {

/// The text with its body hash.
[[nodiscard]] std::string eigen_header(const EmissionInput& input);

/// E701 for functions that would take a name of this header.
[[nodiscard]] Diagnostics eigen_check_names(const Scene& scene, const Program& program);

}  // namespace elgen
