// Numbers as text for readers: 60 digits become "1/3" or "0.70711".
#pragma once

#include <cln/real.h>

#include <string>

namespace elgen {

/// The simplest fraction with a relative error below 1e-9 if its denominator has at most three
/// digits; otherwise x with five significant digits. "0" if |x| < 1e-40.
[[nodiscard]] std::string readable_number(const cln::cl_R& x);

/// The exact number as text: "16616.493" or "1/3". If the text is too long: readable_number(x).
[[nodiscard]] std::string exact_number_text(const cln::cl_R& x);

}  // namespace elgen
