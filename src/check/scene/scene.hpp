// The requests of a scene file and options to a resolved model, part by part. `scene` and `syntax`
// may be null.
#pragma once

#include <string>
#include <vector>

#include "check/names/context.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// E103, E105, E112, E518, E601–E611, E620, E505, E108. An option given replaces what the scene
/// says of the same.
[[nodiscard]] Scene read_scene(Context& context, const FileSyntax* syntax,
                               const SceneOptions& options);

/// E205, E204 of the namespace; E610 where the language is for one scalar and the scene asks for
/// others; E611 for what the language does not have.
[[nodiscard]] Emission read_emission(Context& context, const FileSyntax* syntax,
                                     const Scene& scene);

/// Sets Emission::batch and Numerics::trigonometry_error. E611 where the language is not C++, E625
/// where the scalars or the accuracy are those of no batch.
void read_batch(Context& context, const FileSyntax* syntax, Scene& scene);

/// Sets Numerics::max_error and its ranges. E640, E630.
void read_promise(Context& context, const FileSyntax* syntax, Numerics& numerics);

/// Fills Model::approximation. E614.
void read_approximation(Context& context, const FileSyntax* scene);

/// --state: Coordinate::start_value and Velocity::start_rate. E606, E612, and what is said of
/// expressions.
void read_starts(Context& context, const SceneOptions& options);

/// --input: Input::law, which is judged with what the model says. E201, E606.
void read_laws(Context& context, const SceneOptions& options);

/// --set: Parameter::value of what the scene does not fix. E602, E606, E112, E518.
void read_values(Context& context, const Scene& scene, const SceneOptions& options);

/// Fills Model::locks, in the order of the coordinates. E612, E615, and what the values'
/// expressions give.
void read_locks(Context& context, const FileSyntax* scene);

/// The model in which functions of time stand for the locked coordinates, fewer of which are left.
/// The model given is kept as `unlocked`. Without locks it is returned as it is. Closed forms of
/// [[expect]] and equilibria are those of the whole model and do not carry over.
[[nodiscard]] Model locked(Model model);

/// E208 or E612 of a key that names no coordinate and no rotation.
void report_unknown_coordinate(Context& context, const KeySyntax& key);

/// Fills Model::cyclic, in the order of v, and adds their momenta to the parameters. E201, E208,
/// E612; E635: of a rotation, of a locked coordinate, of all of them, or the name of the momentum
/// is taken.
void read_routh(Context& context, const FileSyntax* scene);

/// E635: an input, a force or D acts on a cyclic coordinate or contains it, L is not quadratic, or
/// a lock wants its reaction. Of a model without cycles.
void check_routh(Context& context);

/// An entry for which a coordinate is not cyclic: "the input `u` acts on it".
struct CyclicObstacle {
  std::string reason = {};
  Span span = {};
};

/// The inputs, forces and D of a model without cycles that act on a coordinate or contain it.
[[nodiscard]] std::vector<CyclicObstacle> obstacles_of(const Model& model, const Held& variable);

/// The locked model without its cyclic coordinates; the model given is kept as `moving`. Without
/// such coordinates it is returned as it is.
[[nodiscard]] Model reduced(Model model);

}  // namespace elgen
