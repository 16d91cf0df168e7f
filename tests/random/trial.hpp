// A trial: elgen generates, shows, compiles and verifies a random system. Every result is compared
// with the truth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "random/shown.hpp"

namespace elgen::test::random {

/// A disagreement between elgen and the truth.
struct Finding {
  /// For example "shown mass_matrix". Two systems fail in the same way if their findings have the
  /// same kind.
  std::string kind;
  std::string text;  ///< numbers, or the output of elgen
};

/// A system with a state, and the true and the shown values at this state.
struct Trial {
  System system;
  std::uint64_t seed = 0;
  Layout layout;
  State state;
  Values given;      ///< truth with the parameter values of the files
  Values drawn;      ///< truth with random parameter values
  Names names;       ///< values of names in shown equations, with random parameters
  Shown shown = {};  ///< with the files' parameter values; empty if unreadable
};

/// A trial of `system` at a random state. Throws std::domain_error if there are no true values.
[[nodiscard]] Trial make_trial(const System& system, std::uint64_t seed);

/// Generates into `folder`, sets `trial.shown`, and returns the errors of the shown equations.
[[nodiscard]] std::vector<Finding> compare_shown(Trial& trial, const std::filesystem::path& folder);

/// Finds bytes that differ in a second run, a true model that `verify` rejects, and a false claim
/// that `verify` accepts.
[[nodiscard]] std::vector<Finding> compare_verdicts(const Trial& trial,
                                                    const std::filesystem::path& folder);

/// Compiles and runs the emitted code of trials generated in `folder`. Returns the findings of each
/// trial.
[[nodiscard]] std::vector<std::vector<Finding>> compare_compiled(
    const std::vector<Trial>& trials, const std::filesystem::path& folder);

/// The findings of all comparisons for `system`. The compiled programs contain no other system.
[[nodiscard]] std::vector<Finding> all_findings(const System& system, std::uint64_t seed);

/// The file name that a trial passes to elgen.
[[nodiscard]] std::string input_file(const System& system);
void write_files(const System& system, const std::filesystem::path& folder,
                 const std::vector<Claim>& claims = {});

}  // namespace elgen::test::random
