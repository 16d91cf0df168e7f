// Numbers as text, the same in every locale and process.
#pragma once

#include <cln/real.h>

#include <string>

namespace elgen {

/// "3", "-1/2"; a number that is no rational as a decimal of 30 digits, "3.14159…e0".
[[nodiscard]] std::string number_text(const cln::cl_R& value);

}  // namespace elgen
