// Programs that call every function of emitted headers at a trial's state and print the results: a
// line "base/output number" for each entry.
#pragma once

#include <string>

#include "random/trial.hpp"

namespace elgen::test::random {

enum class Language { cpp, eigen, c };

/// The ending of a header's file name in this language.
[[nodiscard]] std::string header_suffix(Language language);

/// The text before the functions of all trials, without `#include`s of emitted headers.
[[nodiscard]] std::string driver_prelude(Language language);

/// A function `run_BASE` that calls every function declared in `declared`, the text of a header.
/// For Eigen pass the header with arrays, which declares the same functions.
[[nodiscard]] std::string driver_function(const Trial& trial, Language language,
                                          const std::string& declared);

}  // namespace elgen::test::random
