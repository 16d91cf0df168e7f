// Scene: what a scene file and options want of a resolved model.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// E103, E105, E112, E518, E601–E611, E620, E505, E108. An option given replaces what the scene
/// says of the same. `syntax` may be null.
[[nodiscard]] Scene read_scene(Context& context, const FileSyntax* syntax,
                               const SceneOptions& options);

}  // namespace elgen
