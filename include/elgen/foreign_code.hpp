// Foreign code: functions that elgen did not write, called at states of a model.
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
  std::string code = {};      ///< the path of a shared library; else a command, split at blanks
  std::string name = {};      ///< in the library, or as the command is told it
  std::uint64_t seconds = 0;  ///< by the clock, for all states together
};

struct ForeignAnswers {
  std::vector<std::vector<double>> values = {};  ///< state by state, as far as it came
  /// Why there are no more, or how the code fails after the last one; empty: these are all.
  std::string failure = {};
  /// Its words on stderr, of a library on stdout too, as lines of a message: ":\n    Traceback".
  std::string said = {};
};

/// The numbers that the function gives at each state, which should be those of fields of an output,
/// in order. It takes what emitted code takes, but all parameters of the model. The
/// function of a library is called in a process of its own and has a pointer to doubles for each
/// argument, the result behind them. A command gets a line of JSON for each state and answers with
/// a line of numbers in brackets. E716 where nothing can be called.
[[nodiscard]] Result<ForeignAnswers> call_foreign(const ForeignFunction& function,
                                                  const Model& model, const OutputRequest& output,
                                                  const std::vector<Arguments<double>>& states);

}  // namespace elgen
