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

/// A system with the state and values for its comparison.
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

/// The trial of a drawn state, with its true values. Throws std::domain_error if there are none.
[[nodiscard]] Trial make_trial(const System& system, std::uint64_t seed);

/// Generates into `folder` and compares the shown equations.
[[nodiscard]] std::vector<Finding> compare_shown(Trial& trial, const std::filesystem::path& folder);

/// Generates again: the bytes must be the same. `verify` must accept the model with all its true
/// claims, and must reject a false claim.
[[nodiscard]] std::vector<Finding> compare_verdicts(const Trial& trial,
                                                    const std::filesystem::path& folder);

/// Compiles and runs the emitted code of trials generated in `folder`. Returns the findings of each
/// trial.
[[nodiscard]] std::vector<std::vector<Finding>> compare_compiled(
    const std::vector<Trial>& trials, const std::filesystem::path& folder);

/// Runs all comparisons for one system, in a program of its own.
[[nodiscard]] std::vector<Finding> all_findings(const System& system, std::uint64_t seed);

/// The file name that a trial passes to elgen.
[[nodiscard]] std::string input_file(const System& system);
void write_files(const System& system, const std::filesystem::path& folder,
                 const std::vector<Claim>& claims = {});

}  // namespace elgen::test::random
