// Foreign code: calls foreign functions, which elgen did not write, at states of a model.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct ForeignFunction {
  std::string code = {};      ///< path of a shared library, or a command line, split at blanks
  std::string name = {};      ///< symbol of the library, or the name that the command receives
  std::uint64_t seconds = 0;  ///< wall-clock limit for all states together, in s
};

struct ForeignResults {
  /// The results at each state, in order. After a failure, the last states may be missing.
  std::vector<std::vector<double>> values = {};
  /// The failure of the code before or after its last result: "ends early"; empty: no failure.
  std::string failure = {};
  /// The output of the code on stderr (of a library also on stdout), as lines of a message:
  /// ":\n    Traceback".
  std::string error_output = {};
};

/// Calls `function` at each state. The results should be the entries of fields of `output`, in
/// order. The arguments are the arguments of emitted code, but with all parameters of the model. A
/// library function is called in a separate process, with a pointer to doubles for each argument
/// and for the result. A command receives one line of JSON for each state and answers with one line
/// of numbers in brackets. E716: the function cannot be called.
[[nodiscard]] Result<ForeignResults> call_foreign_function(
    const ForeignFunction& function, const Model& model, const OutputRequest& output,
    const std::vector<Arguments<double>>& states);

}  // namespace elgen
