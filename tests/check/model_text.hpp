// Prints a Model as text, one entry per line.
#pragma once

#include <string>

#include "elgen/model.hpp"

namespace elgen::test {

[[nodiscard]] std::string dump(const Model& model);

}  // namespace elgen::test
