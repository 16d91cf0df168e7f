// Expectations: [[expect]] -> Model::expectations.
#pragma once

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Resolves every closed form and compares its shape with that of the output. Closed forms of sized
/// models grow faster than the model, so that those of more than 4096 nodes are kept only where
/// `large`. E517, E601, E603, E505.
void read_expectations(Context& context, const FileSyntax& syntax, bool large);

}  // namespace elgen
