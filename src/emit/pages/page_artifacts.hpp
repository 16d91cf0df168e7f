// page_artifacts: the equations to be read, by programs and by people.
#pragma once

#include <string>

#include "emit/text/emission_input.hpp"

namespace elgen {

/// The equations as JSON, for programs that read them: one key order, LF, exact numbers as strings.
[[nodiscard]] std::string sidecar(const EmissionInput& input);

/// The equations as a page to read; outputs of more than 64 entries are left to the sidecar.
[[nodiscard]] std::string markdown(const EmissionInput& input);

}  // namespace elgen
