// check: the syntax of a model and a scene -> Model and Scene.
//
// The order of the steps matters and is fixed only here. Sizes and names come first, so that
// expressions may use names that the file declares later. Resolved expressions are checked for
// cycles, ingredients (leaves and functions), degrees and units. The scene is last, except for the
// entries that it adds to those of the model. Errors are collected throughout; a step that could
// only repeat earlier errors is skipped.
#include <memory>
#include <utility>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/expressions/expand.hpp"
#include "check/expressions/open_functions.hpp"
#include "check/expressions/parameters.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/rotations.hpp"
#include "check/expressions/traits.hpp"
#include "check/expressions/units.hpp"
#include "check/expressions/wrench_input.hpp"
#include "check/judge/judge.hpp"
#include "check/names/context.hpp"
#include "check/scene/scene.hpp"
#include "elgen/scene.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

struct EntryReadRule {
  std::string_view entry;
  void (*read)(ValueReader& values, const EntrySyntax& entry, std::uint32_t target);
};

/// Reads the instances of the entries in `readers`, in the order of the file.
void read_entries(Context& context, const std::vector<EntryInstance>& instances,
                  const std::vector<EntryReadRule>& readers) {
  for (const auto& [entry, scope, target] : instances) {
    for (const EntryReadRule& reader : readers) {
      if (entry->name != reader.entry) continue;
      ValueReader values(context, scope);
      reader.read(values, *entry, target);
    }
  }
}

/// Reads each entry after the entries that provide its units or axes.
void read_all_entries(Context& context, const FileSyntax& syntax) {
  const std::vector<EntryInstance> instances = expand_entries(context, syntax);
  if (context.is_beyond_limits) return;
  read_parameters(context, syntax);
  read_entries(context, instances, {{"function", read_arguments}});
  read_entries(context, instances,
               {{"coordinate", read_coordinate},
                {"input", read_input},
                {"function", read_function},
                {"prescribed", read_prescribed}});
  read_entries(context, instances, {{"frame", read_frame}});
  check_rotations(context);
  read_entries(context, instances, {{"point", read_point}, {"body", read_body}});
  for (const EntrySyntax& entry : syntax.entries) read_table(context, entry);
  read_entries(
      context, instances,
      {{"input", read_wrench_input}, {"force", read_force}, {"equilibrium", read_equilibrium}});
  read_constraints(context, instances);
  read_entries(context, instances, {{"output", read_output}});
}

/// The entries of a scene that are read like those of a model. E112 for an input that is no
/// external force.
FileSyntax entries_added_by(const FileSyntax* scene, Context& context) {
  FileSyntax added;
  if (scene == nullptr) return added;
  for (const EntrySyntax& entry : scene->entries) {
    const bool is_input = entry.name == "input";
    if (is_input && !is_wrench_input(entry)) {
      context.report.add(Reason::input_of_scene, entry.span,
                         "an input of a scene has `wrench` or `at`");
      context.symbols.mark_failed(entry.find("name")->value.expression.text);
    } else if (is_input || entry.name == "frame" || entry.name == "output") {
      added.entries.push_back(entry);
    }
  }
  return added;
}

/// Reads the entries that the scene adds, after all entries of the model.
void read_added_entries(Context& context, const FileSyntax* scene) {
  const FileSyntax added = entries_added_by(scene, context);
  const std::vector<EntryInstance> instances = expand_entries(context, added);
  if (context.is_beyond_limits) return;
  read_entries(context, instances, {{"input", read_input}, {"frame", read_frame}});
  read_entries(context, instances, {{"input", read_wrench_input}});
  read_entries(context, instances, {{"output", read_output}});
  Model& model = context.model;
  for (Equilibrium& equilibrium : model.equilibria) equilibrium.inputs.resize(model.inputs.size());
}

/// Sets UserOutput::argument_kinds, without q, from the leaves in the values of each output.
void set_output_arguments(Model& model, const std::vector<ExpressionTraits>& traits) {
  for (UserOutput& output : model.outputs) {
    for (const ExpressionId value : output.values) {
      const Ingredients made_of = traits[value].ingredients;
      if ((made_of & uses_rate) != 0) output.argument_kinds |= Opcode::velocity;
      if ((made_of & uses_acceleration) != 0) output.argument_kinds |= Opcode::acceleration;
      if ((made_of & uses_input) != 0) output.argument_kinds |= Opcode::input;
    }
    if (output.solves_motion) output.argument_kinds = Opcode::velocity | Opcode::input;
  }
}

/// Reads the [[expect]] of the scene. They describe the model that the scene emits, so their shapes
/// are those of the reduced model.
void read_scene_expectations(Context& context, const FileSyntax* scene, bool keeps_large_forms) {
  if (find_entry(scene, "expect") == nullptr || context.report.error_count() > 0) return;
  const Model emitted = eliminate_held_coordinates(context.model);
  read_expectations(context, *scene, {keeps_large_forms, false, emitted});
}

/// Checks the energies. Then reads the closed forms of [[expect]], which need the outputs of the
/// model, and three parts of the scene: expansion point, starts and laws. Last, checks all
/// expressions together.
void check_model_and_scene(Context& context, const FileSyntax& syntax,
                           const FileSyntax* scene_syntax, const SceneOptions& options,
                           Scene& scene) {
  const bool has_order = check_cycles(context);
  if (has_order) {
    const std::vector<ExpressionTraits> traits = find_traits(context.model);
    set_output_arguments(context.model, traits);
    check_mechanics(context, traits);
  }
  const bool is_judged_alone = find_entry(scene_syntax, "input") != nullptr;
  const bool keeps_large_forms = options.purpose.keeps_large_forms;
  read_expectations(context, syntax, {keeps_large_forms, is_judged_alone, context.model});
  if (!options.purpose.ignores_expansion) read_approximation(context, scene_syntax);
  read_scene_expectations(context, scene_syntax, keeps_large_forms);
  read_starts(context, options, scene);
  read_laws(context, options, scene);
  if (!has_order) return;
  check_function_expressions(context);
  check_routh(context, scene);
  const std::vector<ExpressionTraits> traits = find_traits(context.model);
  check_ingredients(context, traits);
  check_expected_equations(context, traits);
  check_units(context);
}

/// Eliminates the variables that the scene locks or declares cyclic. read_scene() comes later and
/// checks the requested outputs against the reduced model.
void reduce_model(Context& context) {
  context.model = eliminate_held_coordinates(std::move(context.model));
  while (context.constants.size() < context.model.expressions.size()) {
    (void)context.constants.evaluate_next(context.model.expressions);
  }
}

/// The model without the scene, except for its sizes. Its errors are reported, because the scene
/// cannot mend them. Null after an error, or if the scene adds no input: only inputs change the
/// equations and the shapes of outputs.
std::shared_ptr<const Model> check_model_alone(Context& context, const FileSyntax& model,
                                               const FileSyntax* scene,
                                               const SceneOptions& options) {
  if (find_entry(scene, "input") == nullptr) return nullptr;
  FileSyntax sizes{scene->source, {}};
  if (const EntrySyntax* const given = find_entry(scene, "sizes")) sizes.entries.push_back(*given);
  SceneOptions alone;
  alone.sizes = options.sizes;
  alone.purpose.keeps_large_forms = options.purpose.keeps_large_forms;
  Result<CheckedModel> result = check(model, &sizes, alone, context.limits);
  for (Diagnostic& diagnostic : result.diagnostics) {
    const bool is_error = code_row(diagnostic.code).severity == Severity::error;
    if (is_error) context.report.add(std::move(diagnostic));
  }
  return result ? std::make_shared<const Model>(std::move(result->model)) : nullptr;
}

}  // namespace

Result<CheckedModel> check(const FileSyntax& model, const FileSyntax* scene,
                           const SceneOptions& options, const Limits& limits) {
  Context context(limits);
  context.model.source = model.source;
  context.model.canonical_text = canonical_model_text(model);
  context.has_units = uses_units(model);
  context.dimension = majority_dimension(model);
  context.is_planar = is_planar(model);
  read_sizes(context, model, scene, options);
  read_function_replacements(context, model, scene, options);
  read_all_entries(context, model);
  if (!context.is_beyond_limits) read_added_entries(context, scene);
  if (context.is_beyond_limits) return context.report.sorted_diagnostics();
  check_plane(context);
  check_output_names(context.model, context.report);
  read_held_coordinates(context, scene);
  mark_wanted_outputs(context.model, scene, options);
  Scene checked_scene;
  checked_scene.model_alone = check_model_alone(context, model, scene, options);
  check_model_and_scene(context, model, scene, options, checked_scene);
  if (options.purpose.shows_motion && context.report.error_count() == 0)
    add_shown_outputs(context.model, checked_scene);
  if (context.report.error_count() == 0) rewrite_quotients(context);
  if (context.report.error_count() == 0) reduce_model(context);
  if (context.report.error_count() == 0) check_constraints(context);
  read_scene(context, scene, options, checked_scene);
  read_parameter_values(context, options, checked_scene);
  if (context.report.error_count() > 0) return context.report.sorted_diagnostics();
  return {CheckedModel{std::move(context.model), std::move(checked_scene)},
          context.report.sorted_diagnostics()};
}

}  // namespace elgen
