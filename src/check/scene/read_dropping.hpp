// read_dropping: `drop_below` of a scene's [approximate].
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Sets scene.dropping where `syntax`, which may be null, has the key; the outputs have been read.
/// E617 where one of them cannot be reduced, or the share is not between 0 and 1.
void read_dropping(Context& context, const FileSyntax* syntax, Scene& scene);

}  // namespace elgen
