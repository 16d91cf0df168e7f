// header: EmissionInput -> the C++17 header, as templates/cpp/header.hpp.mustache pictures it.
#pragma once

#include <string>

#include "emission_input.hpp"

namespace elgen {

/// The text with its body hash.
[[nodiscard]] std::string cpp_header(const EmissionInput& input);

}  // namespace elgen
