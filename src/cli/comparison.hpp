// What `elgen verify` does of a model that was derived: compile, and compare.
#pragma once

#include "cli/options.hpp"
#include "elgen/certificate.hpp"

namespace elgen::cli {

/// Verifies, shown and timed, with what is compiled and derived beside `options`.
[[nodiscard]] Result<Verification> compared(const std::string& path, Products& products,
                                            const VerifyOptions& options, const Limits& limits);

}  // namespace elgen::cli
