// Readers of scene files and options, one for each part. `scene` and `syntax` may be null.
#pragma once

#include <string>
#include <vector>

#include "check/names/context.hpp"
#include "elgen/model.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Reads the scene, except for the starts and laws, which are already read. An option overrides the
/// scene. E112, E204, E205, E319, E518, E602, E603, E606, E609, and the errors of require_request()
/// and of the functions below up to read_independent_velocities().
void read_scene(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                Scene& scene);

/// Reads `[emit]`; the language of the options overrides the language of the scene. E112: `files`
/// lacks `header`. E204, E205: the namespace. E610: the language takes one scalar, and the scene
/// requests others. E611: the language does not support a key.
[[nodiscard]] Emission read_emission(Context& context, const FileSyntax* syntax,
                                     const SceneOptions& options, const Scene& scene);

/// Sets Emission::has_batch_header, Numerics::trigonometry_error and has_library_sines. Needs
/// Numerics::inner. E611 if the language is not C++; E625 if batches do not support the scalars or
/// the accuracy.
void read_batch(Context& context, const FileSyntax* syntax, Scene& scene);

/// Sets Numerics::inner. Only outputs of the scene may compute in float, not outputs of the
/// options. E611 if the language is not C++; E628 if the scalar is not double alone, or an output
/// or key does not support `inner`.
void read_inner_scalar(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                       Scene& scene);

/// Reads the keys of an output's entry except name and form; an entry without keys sets nothing.
/// E103 for a key that the output does not take, and the errors of read_step.
void read_options(const Model& model, const ValueSyntax& entry, OutputRequest& output,
                  Report& report);

/// Sets OutputRequest::step. E105: no method; E620: unknown method; E626: iterations of an explicit
/// method, or out of range; E647: the method lacks the order; E539: `projected` in a model without
/// constraints.
void read_step(const Model& model, const ValueSyntax& entry, OutputRequest& output, Report& report);

/// Reports symplectic methods in models with constraints (E539) or rotations (E622). Other
/// conditions of these methods are checked when M and the forces are derived.
void check_steps(Context& context, const std::vector<OutputRequest>& outputs);

/// Sets Numerics::max_error and the ranges; the ranges of the options come last. E640, E630, E606.
void read_error_bound(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                      Numerics& numerics);

/// Fills Model::affine_parameters. E602, E649.
void read_regressor(Context& context, const FileSyntax* scene, const FixedParameters& fixed);

/// Velocities for OutputRequest::independent, sorted. E612.
[[nodiscard]] std::vector<std::uint32_t> read_independent_velocities(Context& context,
                                                                     const FileSyntax* scene);

/// Fills Model::approximation. E614, E633, E635.
void read_approximation(Context& context, const FileSyntax* scene);

/// --state: sets Coordinate::start_value, Velocity::start_rate and Scene::state_overrides. E606,
/// E612, and the errors of expressions.
void read_starts(Context& context, const SceneOptions& options, Scene& scene);

/// --input: sets Scene::laws, which are checked with the expressions of the model. E201, E606.
void read_laws(Context& context, const SceneOptions& options, Scene& scene);

/// --set: sets Parameter::value. --over: sets Numerics::varied_parameters. E602, E606 if the scene
/// fixes the parameter, E112, E518.
void read_parameter_values(Context& context, const SceneOptions& options, Scene& scene);

/// Fills the lists of Model::reduction, and adds the momenta of cyclic coordinates to the
/// parameters. E208, E612, and the errors of the values. E615: a lock's value does not fit, or no
/// coordinate remains. E635: a cyclic coordinate is a rotation or locked, no coordinate remains, or
/// the name of the momentum is in use.
void read_held_coordinates(Context& context, const FileSyntax* scene);

/// Sets CyclicCoordinate::momentum to `value` if `parameter` is a cyclic momentum. Then
/// set_routh_momenta() does not compute this momentum.
void set_cyclic_momentum(Model& model, std::uint32_t parameter, const cln::cl_R& value);

/// Sets UserOutput::is_requested: true for all outputs if the scene has no `[outputs]`, otherwise
/// true if the scene declares the output, or if the scene or an option names a function of it.
void mark_wanted_outputs(Model& model, const FileSyntax* scene, const SceneOptions& options);

/// Adds to a model the outputs that an animated page needs: one for each kind in ShownValues that
/// has values in this model. Fills Scene::page_outputs.
void add_shown_outputs(Model& model, Scene& scene);

/// The reduced model: functions of time replace the locked coordinates of Model::reduction, and 0
/// replaces the cyclic coordinates. Its `reduction.unreduced` is the given model. A model without
/// held coordinates is returned unchanged. The equilibria and the [[expect]] of the model are
/// removed, because they describe the unreduced model; the [[expect]] of the scene stay.
[[nodiscard]] Model eliminate_held_coordinates(Model whole);

/// Reports E635 if an input, a force or D acts on a cyclic coordinate or contains it, if L is not
/// quadratic in the rates, or if a lock requests its reaction. The model must have no cycles.
void check_routh(Context& context, const Scene& scene);

/// Why a coordinate is not cyclic, and the entry at fault: "the input `u` acts on it".
struct CyclicObstacle {
  std::string reason = {};
  Span span = {};
};

/// The inputs, laws, forces and D that act on a coordinate or contain it. The model must have no
/// cycles.
[[nodiscard]] std::vector<CyclicObstacle> find_cyclic_obstacles(const Model& model,
                                                                const Scene& scene,
                                                                const HeldCoordinate& variable);

}  // namespace elgen
