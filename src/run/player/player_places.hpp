// player_places: the points, bodies and frames that the page draws, and the directions in which it
// draws them.
#pragma once

#include "base/json.hpp"
#include "elgen/pipeline.hpp"

namespace elgen {

/// Adds to `json` the places, the lines between them, the place with a trail, and the axes of the
/// page.
void add_places(Json& json, const CheckedModel& checked, const Program& program);

}  // namespace elgen
