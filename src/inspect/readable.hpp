// Numbers as a reader expects them: 60 digits in, "1/3" or "0.70711" out.
#pragma once

#include <cln/real.h>

#include <string>

namespace elgen {

/// The simplest fraction within 1e-9 of x where its denominator has at most three digits, else five
/// digits; "0" for what is below 1e-40.
[[nodiscard]] std::string readable(const cln::cl_R& x);

/// The number as files have it, "16616.493" or "1/3"; of more characters than are read, readable().
[[nodiscard]] std::string as_typed(const cln::cl_R& x);

}  // namespace elgen
