// [approximate]: the point a scene expands about.
#pragma once

#include "check/names/context.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Fills Model::approximation; `scene` may be null. E614.
void read_approximation(Context& context, const FileSyntax* scene);

}  // namespace elgen
