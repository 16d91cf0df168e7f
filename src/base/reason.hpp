// Reasons: a code with many call sites is named by its reason, so that `elgen explain` can say for
// each reason what to do. An unexplained reason does not compile.
#pragma once

#include <string_view>
#include <vector>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// One constant for each row of error_reasons.def: its name is the id, its value the code.
struct Reason {
#define ELGEN_REASON(code, id, text) static constexpr Code id = Code::code;
#include "base/error_reasons.def"
#undef ELGEN_REASON
};

/// The texts of the reasons of a code, in the order of the table; empty for most codes.
[[nodiscard]] std::vector<std::string_view> reasons_of(Code code);

}  // namespace elgen
