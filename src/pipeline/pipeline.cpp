// The stages, from the inputs to the files and their self-check:
//
//     parse -> check -> inspect -> formulate -> specialise -> derive -> lower -> cancel (and
//     compose outputs) -> present -> choose -> typeset -> emit -> self-check
//
// Other stages start from specialise:
//
//     specialise -> steps                 the derivation, as a student writes it
//     specialise -> choose                the functions that a `step` calls, derived separately
//     specialise -> equilibria -> modes   equilibria, and linear motions about them
//     specialise -> other analyses        the rows of analyses.def
//
// An analysis of the Lagrangian derives its own outputs.
#include "elgen/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "elgen/cancel.hpp"
#include "elgen/choose.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/compose.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/inspect.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "elgen/specialise.hpp"
#include "pipeline/combined_stages.hpp"
#include "pipeline/stages.hpp"

namespace elgen {

namespace {

struct ParsedFiles {
  FileSyntax model;
  std::optional<FileSyntax> scene;
};

/// The product of the stage inspect, which only reports diagnostics.
struct Inspection {};

Result<ParsedFiles> parse(const PipelineSources& inputs, const Limits& limits) {
  Result<FileSyntax> model = parse_model(inputs.model, limits);
  Result<FileSyntax> scene;
  if (inputs.scene != nullptr) scene = parse_scene(inputs.scene, limits);
  Diagnostics all = std::move(model.diagnostics);
  all.insert(all.end(), scene.diagnostics.begin(), scene.diagnostics.end());
  if (!model || (inputs.scene != nullptr && !scene)) return all;
  return {{std::move(*model), std::move(scene.value)}, std::move(all)};
}

/// E539 for each of `goals` that is an analysis without support for constraints. No error if the
/// model has no constraints.
Diagnostics check_analyses(const Model& model, const std::vector<Goal>& goals) {
  Diagnostics errors;
  if (model.constraints.empty()) return errors;
  for (const AnalysisRow& row : analysis_table) {
    const bool is_wanted = std::ranges::find(goals, row.stage) != goals.end();
    if (!is_wanted || row.constraint_hint.empty()) continue;
    errors.push_back({Code::E539, model.constraints.front().span,
                      fmt::format("`{}` does not support constraints", name_of(row.stage)),
                      std::string(row.constraint_hint)});
  }
  return errors;
}

/// The scene that inspect() checks, with the outputs that the goals need.
Scene inspected_scene(const CheckedModel& checked, const std::vector<Goal>& goals) {
  Scene scene = checked.scene;
  // A derivation by steps shows no outputs, so outputs that the model lacks are not reported.
  const auto shows_outputs = [](Goal goal) { return goal != Goal::steps; };
  if (std::ranges::none_of(goals, shows_outputs)) scene.omitted_outputs.clear();
  const auto needs_scene = [](Goal goal) {
    const AnalysisRow* const row = find_analysis(goal);
    return row == nullptr || !row->inspects_outputs;
  };
  if (std::ranges::none_of(goals, needs_scene)) scene.outputs.clear();
  for (const Goal goal : goals) {
    if (needs_scene(goal)) continue;
    const std::vector<OutputRequest> outputs = find_analysis(goal)->outputs(checked.model);
    scene.outputs.insert(scene.outputs.end(), outputs.begin(), outputs.end());
  }
  return scene;
}

/// The model that check() returns, with the values of momenta in `[routh]`. Errors of check(),
/// set_routh_momenta() and check_analyses().
Result<CheckedModel> check_inputs(const ParsedFiles& syntaxes, const PipelineOptions& options) {
  Result<CheckedModel> result = check(syntaxes.model, syntaxes.scene ? &*syntaxes.scene : nullptr,
                                      options.scene, options.limits);
  if (!result) return result;
  Diagnostics errors = set_routh_momenta(*result);
  if (errors.empty()) errors = check_analyses(result->model, options.goals);
  Diagnostics all = std::move(result.diagnostics);
  all.insert(all.end(), errors.begin(), errors.end());
  if (!errors.empty()) return all;
  return {std::move(*result), std::move(all)};
}

/// Also derives outputs_for_self_check(). If they exceed the limits, the check does without them.
Result<SelfCheck> run_self_check(const Lagrangian& lagrangian, const CheckedModel& checked,
                                 const Program& program, const Limits& limits) {
  const std::vector<OutputRequest> requests = outputs_for_self_check(checked.model, program);
  Result<Program> more = Program();
  if (!requests.empty()) more = derive_recursive_program(lagrangian, requests, limits);
  SelfCheck check = self_check(checked.model, checked.scene, program, more ? *more : Program());
  if (check.failure.empty()) return check;
  if (check.has_undefined_output) {
    return Diagnostic{Code::E521, check.place.value_or(Span{}), check.failure, check.remedy};
  }
  return Diagnostic{Code::E911, {}, "self-check failed: " + check.failure};
}

/// The stages in their order. Each stage has a product, and names the stages that it needs.
class Compilation {
 public:
  Compilation(const PipelineSources& inputs, const PipelineOptions& options)
      : inputs_(inputs), options_(options), run_(options) {}

  /// Starts from a model that is already checked.
  Compilation(CheckedModel checked, const PipelineOptions& options)
      : options_(options), run_(options) {
    checked_.set(std::move(checked));
    inspection_.set({});
  }

  void run_through(Goal goal) { run_.run_through(goal); }

  Products take_products() && {
    Products out;
    out.checked = std::move(checked_.product);
    if (lowered_.product) out.lowered = compose_outputs(std::move(*lowered_.product));
    out.closed_forms = std::move(forms_.product);
    if (choice_.product) out.program = std::move(choice_.product->program);
    if (choice_.product) out.costs = std::move(choice_.product->costs);
    out.steps = std::move(steps_.product);
    out.page_programs = std::move(book_.product);
#define ELGEN_ANALYSIS(id, ...) out.id = std::move(id##_.product);
#include "elgen/analyses.def"
    out.claims = std::move(claims_.product);
    out.files = std::move(files_.product);
    out.self_check = std::move(self_check_.product);
    out.diagnostics = std::move(run_.diagnostics);
    sort_by_position(out.diagnostics);
    out.dump = std::move(run_.dump_text);
    out.times = std::move(run_.times);
    return out;
  }

 private:
  /// Runs an analysis of the Lagrangian, on the program of the outputs that the analysis needs.
  template <class Found>
  static Result<Found> run_analysis(Goal goal, Result<Found> (*find)(const AnalysisInput&),
                                    const Lagrangian& lagrangian, const CheckedModel& checked,
                                    const PipelineOptions& options) {
    const Result<Program> recursive = derive_recursive_program(
        lagrangian, find_analysis(goal)->outputs(checked.model), options.limits);
    if (!recursive) return recursive.diagnostics;
    return find({checked, *recursive, options.equilibrium_name, options.limits});
  }

  /// Runs an analysis that needs the result of another analysis.
  template <class Found, class Known>
  static Result<Found> run_analysis(Goal, Result<Found> (*find)(const CheckedModel&, const Known&),
                                    const Known& known, const CheckedModel& checked,
                                    const PipelineOptions&) {
    return find(checked, known);
  }

  PipelineSources inputs_ = {};
  const PipelineOptions& options_;
  StageRunner run_;

  Stage<ParsedFiles> syntaxes_{run_, Goal::parse, std::tie(),
                               [this](const Limits& limits) { return parse(inputs_, limits); }};

  Stage<CheckedModel> checked_{run_, Goal::check, std::tie(syntaxes_),
                               [this](const ParsedFiles& s) { return check_inputs(s, options_); }};

  Stage<Inspection> inspection_{run_, Goal::inspect, std::tie(checked_),
                                [this](const CheckedModel& c) {
                                  const Scene scene = inspected_scene(c, options_.goals);
                                  return Result<Inspection>({}, inspect(c.model, scene));
                                }};

  Stage<UnreducedLagrangian> formulated_{
      run_, Goal::formulate, std::tie(checked_, inspection_),
      [](const CheckedModel& c, const Inspection&) { return formulate(c.model); }};

  Stage<Lagrangian> lagrangian_{run_, Goal::specialise, std::tie(formulated_, checked_),
                                specialise};

  Stage<ReadableDerivation> steps_{run_, Goal::steps, std::tie(lagrangian_, checked_),
                                   make_readable_derivation};

  Stage<EquationsOfMotion> equations_{
      run_, Goal::derive, std::tie(lagrangian_, checked_),
      [](const Lagrangian& l, const CheckedModel& c, const Limits& limits) {
        return derive(l, c.scene.outputs, limits);
      }};

  Stage<Program> lowered_{run_, Goal::lower, std::tie(equations_, checked_),
                          [](const EquationsOfMotion& e, const CheckedModel& c,
                             const Limits& limits) { return lower(e, c.scene.outputs, limits); }};

  Stage<Program> recursive_{run_, Goal::cancel, std::tie(lowered_),
                            [](const Program& p) { return compose_outputs(cancel(p)); }};

  Stage<ClosedForms> forms_{run_, Goal::present, std::tie(recursive_),
                            [](const Program& p) { return present(p); }};

  Stage<FormChoice> choice_{run_, Goal::choose, std::tie(lagrangian_, recursive_, forms_, checked_),
                            choose_forms};

#define ELGEN_ANALYSIS(id, name, source, Found, find, ...)                      \
  Stage<Found> id##_{run_, Goal::id, std::tie(source##_, checked_),             \
                     [this](const auto& known, const CheckedModel& c) {         \
                       return run_analysis(Goal::id, find, known, c, options_); \
                     }};
#include "elgen/analyses.def"

  Stage<std::vector<EquilibriumVerdict>> claims_{run_, Goal::claims,
                                                 std::tie(lagrangian_, checked_), check_claims};

  Stage<PagePrograms> book_{run_, Goal::typeset, std::tie(lagrangian_, forms_, choice_, checked_),
                            make_page_programs};

  Stage<EmittedFiles> files_{
      run_, Goal::emit, std::tie(checked_, choice_, book_),
      [](const CheckedModel& c, const FormChoice& chosen, const PagePrograms& book) {
        return emit(c.model, c.scene, chosen.program, book);
      }};

  Stage<SelfCheck> self_check_{
      run_, Goal::self_check, std::tie(lagrangian_, checked_, choice_, files_),
      [](const Lagrangian& l, const CheckedModel& c, const FormChoice& chosen, const EmittedFiles&,
         const Limits& limits) { return run_self_check(l, c, chosen.program, limits); }};
};

}  // namespace

std::optional<Goal> find_stage(std::string_view name) {
  const auto* const found = std::ranges::find(stage_names, name);
  if (found == stage_names.end()) return std::nullopt;
  return static_cast<Goal>(found - stage_names.begin());
}

Products run_pipeline(const PipelineSources& inputs, const PipelineOptions& options) {
  Compilation compilation(inputs, options);
  for (const Goal goal : options.goals) compilation.run_through(goal);
  return std::move(compilation).take_products();
}

std::vector<StageTime> output_stage_times(const CheckedModel& checked, std::size_t output,
                                          const Limits& limits) {
  PipelineOptions options;
  options.limits = limits;
  CheckedModel one = checked;
  one.scene.outputs = {checked.scene.outputs[output]};
  Compilation compilation(std::move(one), options);
  compilation.run_through(Goal::choose);
  return std::move(compilation).take_products().times;
}

}  // namespace elgen
