// Scene: what a scene file and options want of a resolved model.
#pragma once

#include "check/expressions/expand.hpp"
#include "check/names/context.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// What the scene is made from; `scene` may be null.
struct SceneInput {
  const SceneSyntax* scene = nullptr;
  const SceneOptions& options;
  const std::vector<SizeOverride>& sizes;
};

/// "double"
[[nodiscard]] std::string_view name_of(ScalarKind kind);

/// E112, E518, E601–E611, E617, E505, E108. An option given replaces what the scene says of the
/// same.
[[nodiscard]] Scene read_scene(Context& context, const SceneInput& input);

}  // namespace elgen
