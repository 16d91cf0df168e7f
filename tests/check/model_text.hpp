// A Model as text, one entry a line.
#pragma once

#include <string>

#include "elgen/model.hpp"

namespace elgen::test {

[[nodiscard]] std::string dump(const Model& model);

}  // namespace elgen::test
