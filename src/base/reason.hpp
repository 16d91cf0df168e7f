// Reasons: call sites of a code with several causes use a reason instead of the code. `elgen
// explain` says for each reason what to do. A reason without a row in error_reasons.def does not
// compile.
#pragma once

#include <string_view>
#include <vector>

#include "elgen/diagnostic.hpp"

namespace elgen {

/// A struct with one constant for each row of error_reasons.def: the id is the name, and the code
/// is the value.
struct Reason {
#define ELGEN_REASON(code, id, text) static constexpr Code id = Code::code;
#include "base/error_reasons.def"
#undef ELGEN_REASON
};

/// The texts of the reasons of a code, in the order of the table; empty for most codes.
[[nodiscard]] std::vector<std::string_view> reasons_of(Code code);

}  // namespace elgen
