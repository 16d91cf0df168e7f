// c99_artifact: the C99 header.
#pragma once

#include <string>

#include "emit/text/emission_input.hpp"

namespace elgen {

/// Text with its body hash.
[[nodiscard]] std::string c99_header(const EmissionInput& input);

/// E701 for functions whose name the header needs.
[[nodiscard]] Diagnostics c99_check_names(const Model& model, const Scene& scene,
                                          const Program& program);

}  // namespace elgen
