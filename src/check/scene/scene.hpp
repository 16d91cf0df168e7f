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

/// Adds to what earlier steps have read into the scene. E103, E105, E112, E518, E601–E611, E620,
/// E505, E108. An option given replaces what the scene says of the same.
void read_scene(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                Scene& scene);

/// E205, E204 of the namespace; E610 where the language is for one scalar and the scene asks for
/// others; E611 for what the language, that of the options if they name one, does not have.
[[nodiscard]] Emission read_emission(Context& context, const FileSyntax* syntax,
                                     const SceneOptions& options, const Scene& scene);

/// Sets Emission::batch, Numerics::trigonometry_error and has_library_sines. E611 where the
/// language is not C++, E625 where the scalars or the accuracy are those of no batch.
void read_batch(Context& context, const FileSyntax* syntax, Scene& scene);

/// Sets Numerics::inner; float is for the outputs of the scene, not for those of the options. E611
/// where the language is not C++, E628 where functions are not those of one state in double.
void read_inner(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                Scene& scene);

/// Sets what the entry of an output says besides its name and form. A value without keys says
/// nothing. E103 for a key that the output does not take, and the errors of read_step.
void read_options(const Model& model, const ValueSyntax& entry, OutputRequest& output,
                  Report& report);

/// Sets OutputRequest::step. E105 if the entry has no method, E620 if the method is unknown, E626
/// if it does not iterate, or not so often, E647 if it does not have the order, E539 if it is to
/// project and the model has no constraints.
void read_step(const Model& model, const ValueSyntax& entry, OutputRequest& output, Report& report);

/// Symplectic methods know of no constraints (E539) and of no rotations (E622). What else they need
/// is seen where M and the forces are derived.
void check_steps(Context& context, const std::vector<OutputRequest>& outputs);

/// Sets Numerics::max_error and its ranges, those of the options last. E640, E630, E606.
void read_promise(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                  Numerics& numerics);

/// Fills Model::regressed. E602, E649.
void read_regressor(Context& context, const FileSyntax* scene, const FixedParameters& fixed);

/// The velocities for OutputRequest::independent. E612.
[[nodiscard]] std::vector<std::uint32_t> read_independent(Context& context,
                                                          const FileSyntax* scene);

/// Fills Model::approximation. E614.
void read_approximation(Context& context, const FileSyntax* scene);

/// --state: Coordinate::start_value, Velocity::start_rate and Scene::stated. E606, E612, and what
/// is said of expressions.
void read_starts(Context& context, const SceneOptions& options, Scene& scene);

/// --input: Scene::laws, which are judged with the expressions of the model. E201, E606.
void read_laws(Context& context, const SceneOptions& options, Scene& scene);

/// --set: Parameter::value of what the scene does not fix. E602, E606, E112, E518.
void read_values(Context& context, const Scene& scene, const SceneOptions& options);

/// Fills the lists of Model::variant, and adds the momenta of cyclic coordinates to the parameters.
/// E208, E612, and what the values' expressions give; E615 of a lock; E635 of a cyclic coordinate:
/// a rotation, a locked one, all of them, or the name of the momentum is taken.
void read_held(Context& context, const FileSyntax* scene);

/// Sets Cyclic::momentum if the parameter is a momentum, which find_momenta() then leaves.
void give_momentum(Model& model, std::uint32_t parameter, const cln::cl_R& value);

/// Sets UserOutput::is_wanted. A scene without `[outputs]` wants all; otherwise an output is wanted
/// if the scene or an option names one of its functions.
void note_wanted(Model& model, const FileSyntax* scene, const SceneOptions& options);

/// Adds the outputs of a page that moves to a model: those of ShownValues that have values. Fills
/// Scene::shown.
void add_shown_outputs(Model& model, Scene& scene);

/// The model without what Model::variant lists: functions of time stand for locked coordinates, 0
/// for cyclic ones. The model given is kept as `whole`. Where nothing is held it is returned as it
/// is. Closed forms of [[expect]] and equilibria are those of the whole model and do not carry
/// over.
[[nodiscard]] Model variant_of(Model whole);

/// E635: an input, a force or D acts on a cyclic coordinate or contains it, L is not quadratic, or
/// a lock wants its reaction. Of a model without cycles.
void check_routh(Context& context, const Scene& scene);

/// An entry for which a coordinate is not cyclic: "the input `u` acts on it".
struct CyclicObstacle {
  std::string reason = {};
  Span span = {};
};

/// The inputs, forces and D of a model without cycles that act on a coordinate or contain it.
[[nodiscard]] std::vector<CyclicObstacle> obstacles_of(const Model& model, const Scene& scene,
                                                       const Held& variable);

}  // namespace elgen
