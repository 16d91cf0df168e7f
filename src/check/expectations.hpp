// Expectations: [[expect]] -> Model::expectations.
#pragma once

#include "context.hpp"
#include "elgen/syntax.hpp"

namespace elgen::checking {

/// Resolves every closed form and compares its shape with that of the output. Sized forms
/// (`mass_matrix_entry`) of more than `entries_in_full` entries are expanded only where `large`;
/// otherwise their first entry is resolved, so that its mistakes are reported, and not kept.
/// E517, E601, E603, E505.
void read_expectations(Context& context, const ModelSyntax& syntax, bool large);

}  // namespace elgen::checking
