// Parameters: [parameters] -> Model::parameters and Model::parameter_arrays.
#pragma once

#include "context.hpp"
#include "elgen/syntax.hpp"

namespace elgen::checking {

/// Declares the name and adds the elements, without values.
void declare_parameter(Context& context, const KeySyntax& key);

/// Reads value, unit, assumption and range of every declared parameter. E105, E112, E402, E518.
void read_parameters(Context& context, const ModelSyntax& syntax);

}  // namespace elgen::checking
