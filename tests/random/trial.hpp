// One random system put through elgen: generated, shown, compiled, verified, each against the
// truth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "random/shown.hpp"

namespace elgen::random {

/// A disagreement between elgen and the truth.
struct Finding {
  /// "shown mass_matrix"; a smaller system fails in the same way if it has the same kind.
  std::string kind;
  std::string text;  ///< numbers, or what elgen printed
};

/// A system with the numbers at which it is looked at.
struct Trial {
  System system;
  std::uint64_t seed = 0;
  Layout layout;
  State state;
  Values given;      ///< truth where the parameters have the values of the files
  Values drawn;      ///< truth where they have drawn ones
  Names names;       ///< of the drawn numbers, for what is shown
  Shown shown = {};  ///< at the given parameters; empty where it cannot be read
};

/// Draws a state and evaluates the definition. Throws std::domain_error where there is no value.
[[nodiscard]] Trial prepared(const System& system, std::uint64_t seed);

/// Generates into `folder` and compares what is shown.
[[nodiscard]] std::vector<Finding> compare_shown(Trial& trial, const std::filesystem::path& folder);

/// Generates once more, which must give the same bytes; verifies the model as it is, with true
/// claims, and with a false one.
[[nodiscard]] std::vector<Finding> compare_verdicts(const Trial& trial,
                                                    const std::filesystem::path& folder);

/// Compiles and runs the emitted code of trials that were generated below `folder`; by trial.
[[nodiscard]] std::vector<std::vector<Finding>> compare_compiled(
    const std::vector<Trial>& trials, const std::filesystem::path& folder);

/// All of these for one system that does not share its program with others.
[[nodiscard]] std::vector<Finding> examined(const System& system, std::uint64_t seed);

/// How the files of a trial are called below the folder.
[[nodiscard]] std::string input_file(const System& system);
void write_files(const System& system, const std::filesystem::path& folder,
                 const std::vector<Claim>& claims = {});

}  // namespace elgen::random
