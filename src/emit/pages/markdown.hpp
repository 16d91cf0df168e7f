// markdown: the equations of a scene as a page to read beside its header.
#pragma once

#include <string>

#include "emit/text/emission_input.hpp"

namespace elgen {

/// Outputs of more than 64 entries are left to the sidecar.
[[nodiscard]] std::string markdown(const EmissionInput& input);

}  // namespace elgen
