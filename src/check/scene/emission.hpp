// Emission: what `[emit]` says of language, names, storage and adaptors, checked against
// `[numeric] scalar`; whether functions on arrays are emitted, and how accurate their sines are.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E205, E204 of the namespace; E610 where the language is for one scalar and the scene asks for
/// others; E611 for what the language does not have. `syntax` may be null.
[[nodiscard]] Emission read_emission(Context& context, const FileSyntax* syntax,
                                     const Scene& scene);

/// Sets Emission::batch and Numerics::trigonometry_error. E611 where the language is not C++, E625
/// where the scalars or the accuracy are those of no batch. `syntax` may be null.
void read_batch(Context& context, const FileSyntax* syntax, Scene& scene);

}  // namespace elgen
