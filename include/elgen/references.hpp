// References: what the expressions of a Model are made of, through its names.
#pragma once

#include <vector>

#include "elgen/model.hpp"

namespace elgen {

/// What an expression refers to: its operands, or the expression that its name stands for.
[[nodiscard]] std::vector<ExpressionId> references(const Model& model, ExpressionId expression);

/// The roots and everything below them, each once, operands before their users. Chains of names may
/// be thousands of links long: nothing here is recursive. Cost: one visit per expression.
[[nodiscard]] std::vector<ExpressionId> reached(const Model& model,
                                                const std::vector<ExpressionId>& roots);

}  // namespace elgen
