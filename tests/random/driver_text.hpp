// Programs that call every function of emitted headers at the state of a trial, and print what it
// returns: a line "base/output number" for each entry.
#pragma once

#include <string>

#include "random/trial.hpp"

namespace elgen::random {

enum class Language { cpp, eigen, c };

/// The end of the name of the header in this language.
[[nodiscard]] std::string header_suffix(Language language);

/// The text before the functions of all trials, without the headers.
[[nodiscard]] std::string driver_prelude(Language language);

/// A function `run_BASE` that calls what `declared`, the text of a header, declares. The header on
/// Eigen declares what that on arrays does, whose text is asked for.
[[nodiscard]] std::string driver_function(const Trial& trial, Language language,
                                          const std::string& declared);

}  // namespace elgen::random
