// A Model and a Scene as text, one entry a line.
#pragma once

#include <string>

#include "elgen/scene.hpp"

namespace elgen::test {

[[nodiscard]] std::string dump(const Model& model);
[[nodiscard]] std::string dump(const Scene& scene);

}  // namespace elgen::test
