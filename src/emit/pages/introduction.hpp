// introduction: a Model and its Program -> the comment a header opens with: title, equation of
// motion with the terms this model has, what q, v, a, u are, and the table of operations.
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Lines as they follow `//`: empty, or beginning with a space.
[[nodiscard]] std::vector<std::string> introduction(const Model& model, const Scene& scene,
                                                    const Program& program);

/// One heading and one line per function; `definitions` is the number of named values in it.
[[nodiscard]] std::vector<std::string> operation_table(const Program& program);

}  // namespace elgen
