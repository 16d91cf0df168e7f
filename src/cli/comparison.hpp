// What `elgen verify` does of a model that was derived: compile, screen where there are many
// states, and compare.
#pragma once

#include "cli/options.hpp"
#include "elgen/certificate.hpp"

namespace elgen::cli {

struct ComparisonOptions {
  VerifyOptions verify = {};  ///< but for what is compiled and derived
  std::size_t jobs = 1;       ///< processes that screen
};

/// Whether so many samples are screened.
[[nodiscard]] bool is_screened(const VerifyOptions& options);

/// The states of one shard, shown and timed.
[[nodiscard]] Result<Screening> screened(const std::string& path, Products& products,
                                         const ComparisonOptions& options, const Shard& shard,
                                         const Limits& limits);

/// Screens what `screening` does not know yet, and verifies, shown and timed.
[[nodiscard]] Result<Verification> compared(const std::string& path, Products& products,
                                            const ComparisonOptions& options, const Limits& limits,
                                            const Screening* screening = nullptr);

}  // namespace elgen::cli
