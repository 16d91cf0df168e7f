// introduction: a Model and its Program -> the opening comment of a header: title, equation of
// motion, definitions of q, v, a, u, and the table of operations.
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The lines of the comment without `//`. Each line is empty or begins with a space.
[[nodiscard]] std::vector<std::string> introduction(const Model& model, const Scene& scene,
                                                    const Program& program);

/// A heading, and a line per function; column `definitions` counts named values.
[[nodiscard]] std::vector<std::string> operation_table(const Program& program);

}  // namespace elgen
