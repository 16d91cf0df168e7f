// Emission: what `[emit]` says of language, names, storage and adaptors, checked against
// `[numeric] scalar`.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E205, E204 of the namespace; E610 where the language is for one scalar and the scene asks for
/// others; E611 for what the language does not have. `syntax` may be null.
[[nodiscard]] Emission read_emission(Context& context, const FileSyntax* syntax,
                                     const Scene& scene);

}  // namespace elgen
