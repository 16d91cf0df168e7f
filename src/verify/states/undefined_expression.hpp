// Where an output that has no value at any state comes from.
#pragma once

#include <optional>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// The first expression of the output, operands before their users, that is undefined at all the
/// states; none where only a derivative, or the solution of the equations, is.
[[nodiscard]] std::optional<ExpressionId> undefined_expression(const Model& model,
                                                               const Function& function,
                                                               const std::vector<State>& states);

}  // namespace elgen
