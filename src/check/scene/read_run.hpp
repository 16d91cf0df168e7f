// What a run starts from: options that take the places of values of the model.
#pragma once

#include "check/names/context.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// --state: Coordinate::start_value and Velocity::start_rate. E606, E612, and what is said of
/// expressions.
void read_starts(Context& context, const SceneOptions& options);

/// --input: Input::law, which is judged with what the model says. E201, E606.
void read_laws(Context& context, const SceneOptions& options);

/// --set: Parameter::value of what the scene does not fix. E602, E606, E112, E518.
void read_values(Context& context, const Scene& scene, const SceneOptions& options);

}  // namespace elgen
