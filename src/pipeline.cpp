// The order of the stages, and the only place that knows it:
//
//     parse -> check -> inspect -> formulate -> specialise -> derive -> lower -> cancel -> present
//     -> choose -> emit -> self-check
//
//     specialise -> steps    the derivation as a student writes it
//     cancel -> parts        what solutions are judged by
//     specialise -> choose   what `step` calls, derived in its own name
#include "elgen/pipeline.hpp"

#include <utility>

#include "elgen/cancel.hpp"
#include "elgen/choose.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/inspect.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "elgen/specialise.hpp"
#include "pipeline/chosen.hpp"
#include "pipeline/parts.hpp"
#include "pipeline/readable_steps.hpp"
#include "pipeline/stages.hpp"

namespace elgen {

namespace {

struct Syntaxes {
  FileSyntax model;
  std::optional<FileSyntax> scene;
};

/// inspect only reports.
struct Inspection {};

Result<Syntaxes> parse(const Inputs& inputs, const Limits& limits) {
  Result<FileSyntax> model = parse_model(inputs.model, limits);
  Result<FileSyntax> scene;
  if (inputs.scene != nullptr) scene = parse_scene(inputs.scene, limits);
  Diagnostics all = std::move(model.diagnostics);
  all.insert(all.end(), scene.diagnostics.begin(), scene.diagnostics.end());
  if (!model || (inputs.scene != nullptr && !scene)) return all;
  return {{std::move(*model), std::move(scene.value)}, std::move(all)};
}

Result<SelfCheck> checked(const CheckedModel& checked, const Program& program,
                          const Program& parts) {
  SelfCheck check = self_check(checked.model, checked.scene, program, &parts);
  if (check.failure.empty()) return check;
  if (check.lacks_value) {
    return Diagnostic{Code::E521, check.place.value_or(Span{}), check.failure, check.remedy};
  }
  return Diagnostic{Code::E911, {}, "self-check failed: " + check.failure};
}

/// The stages in their order, each with what it makes and what it needs for that.
class Compilation {
 public:
  Compilation(const Inputs& inputs, const PipelineOptions& options)
      : inputs_(inputs), options_(options), run_(options) {}

  /// A model that was checked before is not checked again.
  Compilation(CheckedModel checked, const PipelineOptions& options)
      : options_(options), run_(options) {
    checked_.set(std::move(checked));
    inspection_.set({});
  }

  void reach(std::string_view goal) {
    for (const auto& [name, reach] : run_.stages) {
      if (name == goal) reach();
    }
  }

  Products products() && {
    Products out;
    out.checked = std::move(checked_.product);
    if (options_.goals == std::vector<std::string>{"lower"}) {
      out.lowered = std::move(lowered_.product);
    }
    out.closed_forms = std::move(forms_.product);
    if (choice_.product) out.program = std::move(choice_.product->program);
    if (choice_.product) out.costs = std::move(choice_.product->costs);
    if (parts_.product) out.parts = std::move(*parts_.product);
    out.steps = std::move(steps_.product);
    out.files = std::move(files_.product);
    out.self_check = std::move(self_check_.product);
    out.diagnostics = std::move(run_.diagnostics);
    sort_by_position(out.diagnostics);
    out.dump = std::move(run_.dumped);
    out.times = std::move(run_.times);
    return out;
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& stage : run_.stages) names.push_back(stage.first);
    return names;
  }

 private:
  Inputs inputs_ = {};
  const PipelineOptions& options_;
  StageRunner run_;

  Stage<Syntaxes> syntaxes_{run_, "parse", std::tie(),
                            [this](const Limits& limits) { return parse(inputs_, limits); }};

  Stage<CheckedModel> checked_{
      run_, "check", std::tie(syntaxes_), [this](const Syntaxes& s, const Limits& limits) {
        return check(s.model, s.scene ? &*s.scene : nullptr, options_.scene, limits);
      }};

  Stage<Inspection> inspection_{run_, "inspect", std::tie(checked_), [this](CheckedModel& c) {
                                  // A derivation step by step shows no output, so none is missing
                                  // from it.
                                  if (options_.goals == std::vector<std::string>{"steps"})
                                    c.scene.left_out.clear();
                                  return Result<Inspection>({}, inspect(c.model, c.scene));
                                }};

  Stage<Lagrangian> formulated_{
      run_, "formulate", std::tie(checked_, inspection_),
      [](const CheckedModel& c, const Inspection&) { return formulate(c.model); }};

  Stage<Lagrangian> lagrangian_{run_, "specialise", std::tie(formulated_, checked_), specialise};

  Stage<ReadableSteps> steps_{run_, "steps", std::tie(lagrangian_, checked_), readable_steps};

  Stage<EquationsOfMotion> equations_{
      run_, "derive", std::tie(lagrangian_, checked_),
      [](const Lagrangian& l, const CheckedModel& c, const Limits& limits) {
        return derive(l, c.scene.outputs, limits);
      }};

  Stage<Program> lowered_{run_, "lower", std::tie(equations_, checked_),
                          [](const EquationsOfMotion& e, const CheckedModel& c,
                             const Limits& limits) { return lower(e, c.scene.outputs, limits); }};

  Stage<Program> recursive_{run_, "cancel", std::tie(lowered_),
                            [](Program& p) { return cancel(std::move(p)); }};

  Stage<ClosedForms> forms_{run_, "present", std::tie(recursive_),
                            [](const Program& p) { return present(p); }};

  Stage<Choice> choice_{run_, "choose", std::tie(lagrangian_, recursive_, forms_, checked_),
                        chosen};

  Stage<EmittedFiles> files_{run_, "emit", std::tie(checked_, choice_),
                             [](const CheckedModel& c, const Choice& chosen) {
                               return emit(c.model, c.scene, chosen.program);
                             }};

  Stage<Program> parts_{run_, "parts", std::tie(lagrangian_, checked_, recursive_), parts};

  Stage<SelfCheck> self_check_{
      run_, "self-check", std::tie(checked_, choice_, recursive_, files_),
      [](const CheckedModel& c, const Choice& chosen, const Program& p, const EmittedFiles&) {
        return checked(c, chosen.program, known_parts(c, p));
      }};
};

}  // namespace

const std::vector<std::string>& stage_names() {
  static const std::vector<std::string> names = Compilation(Inputs{}, PipelineOptions{}).names();
  return names;
}

Products run_pipeline(const Inputs& inputs, const PipelineOptions& options) {
  Compilation compilation(inputs, options);
  for (const std::string& goal : options.goals) compilation.reach(goal);
  return std::move(compilation).products();
}

std::vector<StageTime> times_alone(const CheckedModel& checked, std::size_t output,
                                   const Limits& limits) {
  PipelineOptions options;
  options.limits = limits;
  CheckedModel one = checked;
  one.scene.outputs = {checked.scene.outputs[output]};
  Compilation compilation(std::move(one), options);
  compilation.reach("choose");
  return std::move(compilation).products().times;
}

}  // namespace elgen
