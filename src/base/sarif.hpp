// sarif: diagnostics as a log of SARIF 2.1.0 (OASIS), one run of elgen.
#pragma once

#include <string>
#include <string_view>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// The log up to its results; `sarif_end` closes it. All codes are rules.
[[nodiscard]] std::string sarif_start();
inline constexpr std::string_view sarif_end = "\n]}]}\n";

/// A result, an object on one line.
[[nodiscard]] std::string sarif_result(const Diagnostic& diagnostic,
                                       const std::string& fingerprint);

}  // namespace elgen
