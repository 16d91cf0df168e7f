// Reads exact numbers from text, in 64 digits.
#pragma once

#include <string>

#include "elgen/evaluate.hpp"
#include "oracle/model_builder.hpp"

namespace elgen::test {

inline Real real(const std::string& text) { return Real(exact(text)); }

}  // namespace elgen::test
