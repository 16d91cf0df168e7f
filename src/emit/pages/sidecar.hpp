// sidecar: EmissionInput -> the equations as JSON, for programs that read them.
#pragma once

#include <string>

#include "emit/text/emission_input.hpp"

namespace elgen {

/// One key order, LF, exact numbers as strings; stamped with its own body hash.
[[nodiscard]] std::string sidecar(const EmissionInput& input);

}  // namespace elgen
