// Batches: whether functions on arrays are emitted, and how accurate their sines and cosines are.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// Sets Emission::batch and Numerics::trigonometry_error. E611 where the language is not C++, E625
/// where the scalars or the accuracy are those of no batch. `syntax` may be null.
void read_batch(Context& context, const FileSyntax* syntax, Scene& scene);

}  // namespace elgen
