// The order of the stages, and the only place that knows it:
//
//     parse -> check -> inspect -> formulate -> specialise -> derive -> lower -> cancel -> present
//     -> choose -> emit -> readback -> parts -> self-check
//
// parts: what solutions are judged by, from the program before forms were chosen.
#include "elgen/pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "elgen/cancel.hpp"
#include "elgen/choose.hpp"
#include "elgen/drop.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/inspect.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "elgen/specialise.hpp"
#include "elgen/steps.hpp"

namespace elgen {

namespace {

struct Syntaxes {
  ModelSyntax model;
  std::optional<SceneSyntax> scene;
};

std::string dump(const Syntaxes& s) { return dump(s.model) + (s.scene ? dump(*s.scene) : ""); }
std::string dump(const CheckedModel& c) { return dump(c.model) + dump(c.scene); }

/// inspect only reports; its dump is what it found.
struct Inspection {
  Diagnostics found;
};
std::string dump(const Inspection& inspection) { return format(inspection.found); }
std::string dump(const ReadableSteps& steps) { return dump(steps.program); }

/// What solutions are judged by; none where nothing is solved, or where a limit was reached.
struct Parts {
  std::optional<Program> program;
};
std::string dump(const Parts& parts) { return parts.program ? dump(*parts.program) : ""; }
std::string dump(const SelfCheck& check) { return receipt(check) + "\n"; }

/// Times each stage, collects its diagnostics and its dump, and says whether the next one may run.
class Stages {
 public:
  Stages(const PipelineOptions& options, Products& products)
      : options_(options), products_(products) {}

  /// The stage's value, or nothing where it failed, was the last one wanted, or came after such a
  /// one.
  template <class Stage>
  auto run(const std::string& name, const Stage& stage) -> decltype(stage().value) {
    if (done_) return {};
    const auto start = std::chrono::steady_clock::now();
    auto result = guarded(name, [&] {
      if (options_.on_stage) options_.on_stage(name);
      return stage();
    });
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    products_.times.push_back({name, elapsed.count()});
    auto& all = products_.diagnostics;
    all.insert(all.end(), result.diagnostics.begin(), result.diagnostics.end());
    if (result && name == options_.dump_stage) products_.dump = dump(*result);
    done_ = !result || has_errors(all) || name == options_.stop_after;
    return std::move(result.value);
  }

  [[nodiscard]] bool done() const { return done_; }

  /// Time of the stages so far: what the self-check may take a share of.
  [[nodiscard]] double seconds() const {
    double sum = 0.0;
    for (const StageTime& time : products_.times) sum += time.seconds;
    return sum;
  }

 private:
  /// A mistake of ours must not swallow what earlier stages found.
  template <class Stage>
  static auto guarded(const std::string& name, const Stage& stage) -> decltype(stage()) {
    try {
      return stage();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& mistake) {
      return Diagnostic{Code::E912, {}, "internal error in `" + name + "`: " + mistake.what()};
    }
  }

  const PipelineOptions& options_;
  Products& products_;
  bool done_ = false;
};

Result<Syntaxes> parse(const Inputs& inputs, const Limits& limits) {
  Result<ModelSyntax> model = parse_model(inputs.model, limits);
  if (inputs.scene == nullptr) {
    if (!model) return model.diagnostics;
    return {{std::move(*model), std::nullopt}, std::move(model.diagnostics)};
  }
  Result<SceneSyntax> scene = parse_scene(inputs.scene, limits);
  Diagnostics all = std::move(model.diagnostics);
  all.insert(all.end(), scene.diagnostics.begin(), scene.diagnostics.end());
  if (!model || !scene) return all;
  return {{std::move(*model), std::move(*scene)}, std::move(all)};
}

std::vector<SourcePointer> sources_of(const EmittedFiles& files) {
  std::vector<SourcePointer> sources;
  for (const auto& [path, text] : files.files) sources.push_back(make_source(path, text));
  return sources;
}

/// A quarter of the generation time, and at least 20 ms: enough states to notice, too few to wait
/// for.
Result<SelfCheck> checked(const CheckedModel& checked, const Program& program,
                          const std::optional<Program>& parts, double generation) {
  SelfCheck check = self_check(checked.model, checked.scene, program,
                               std::max(0.02, generation / 4), parts ? &*parts : nullptr);
  if (check.failure.empty()) return check;
  if (check.lacks_value) {
    return Diagnostic{Code::E521, check.place.value_or(Span{}), check.failure,
                      "declare a `range` inside the domain"};
  }
  return Diagnostic{Code::E911, {}, "self-check failed: " + check.failure};
}

/// The outputs, and the parts of those that are reduced, each once.
std::vector<OutputRequest> with_parts(const Scene& scene) {
  std::vector<OutputRequest> all;
  for (const OutputRequest& output : scene.outputs) {
    if (output.kind != OutputKind::dynamics) all.push_back(output);
  }
  for (const OutputRequest& part : scene.dropping->parts) {
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const OutputRequest& output) {
      return output.kind == part.kind;
    });
    if (!is_known) all.push_back(part);
  }
  return all;
}

/// The forms of `program`'s functions out of those of a program that has more.
std::vector<ClosedFunction> selected(const Program& program, const Program& whole,
                                     const ClosedForms& forms) {
  std::vector<ClosedFunction> result;
  for (const Function& function : program.functions) {
    ClosedFunction& closed = result.emplace_back();
    for (std::size_t i = 0; i < whole.functions.size(); ++i) {
      const Function& known = whole.functions[i];
      if (known.kind == function.kind && known.user == function.user) closed = forms.functions[i];
    }
  }
  return result;
}

/// The closed forms of `recursive` without their small terms. The parts are derived with them, so
/// that all are sums over one algebra.
Result<ReducedForms> reduced(const Lagrangian& lagrangian, const CheckedModel& checked,
                             const Program& recursive, const Limits& limits) {
  const auto& [model, scene] = checked;
  const std::vector<OutputRequest> wanted = with_parts(scene);
  const Result<EquationsOfMotion> equations = derive(lagrangian, wanted, limits);
  if (!equations) return equations.diagnostics;
  Result<Program> lowered = lower(*equations, wanted, limits);
  if (!lowered) return lowered.diagnostics;
  const Program program = cancel(std::move(*lowered));
  Result<ReducedForms> reduced = drop_terms(program, present(program), model, *scene.dropping);
  if (!reduced) return reduced.diagnostics;
  Diagnostics refused = check_definiteness(model, scene, reduced->reduction);
  if (!refused.empty()) return refused;
  reduced->forms.functions = selected(recursive, program, reduced->forms);
  return reduced;
}

/// The closed forms as they are, and without small terms where the scene wants that.
struct Presented {
  ClosedForms exact;
  std::optional<ReducedForms> reduced;
};
std::string dump(const Presented& p) { return dump(p.reduced ? p.reduced->forms : p.exact); }

Result<Presented> presented(const Lagrangian& lagrangian, const CheckedModel& checked,
                            const Program& recursive, const Limits& limits) {
  Presented result{present(recursive), {}};
  if (checked.scene.dropping) {
    Result<ReducedForms> without = reduced(lagrangian, checked, recursive, limits);
    if (!without) return without.diagnostics;
    result.reduced = std::move(*without);
  }
  return result;
}

/// The functions of `program` that are needed; none where one is missing.
std::optional<Program> selected(const Program& program, const std::vector<OutputRequest>& needed) {
  Program some{program.leaves, program.constants};
  for (const OutputRequest& request : needed) {
    const auto known = std::find_if(
        program.functions.begin(), program.functions.end(),
        [&request](const Function& function) { return function.kind == request.kind; });
    if (known == program.functions.end()) return std::nullopt;
    some.functions.push_back(*known);
  }
  return some;
}

/// Always in recursive form: what is closed has cancelled terms that solutions do not. `derives`
/// those that the scene has not; else there are none then.
Result<Parts> parts(const Lagrangian& lagrangian, const CheckedModel& checked,
                    const Program& recursive, const Limits& limits, bool derives) {
  const std::vector<OutputRequest> needed = needed_parts(checked.model, checked.scene);
  if (needed.empty()) return Parts{};
  std::optional<Program> known = selected(recursive, needed);
  if (known || !derives) return Parts{std::move(known)};
  // Where a limit is in the way, solutions are judged by the code's own bound.
  const Result<EquationsOfMotion> equations = derive(lagrangian, needed, limits);
  if (!equations) return Parts{};
  Result<Program> lowered = lower(*equations, needed, limits);
  return lowered ? Parts{cancel(std::move(*lowered))} : Parts{};
}

std::string name_of(const Model& model, const Entity& origin) {
  if (origin.kind == EntityKind::point) return model.points[origin.index].name;
  if (origin.kind == EntityKind::body) return model.bodies[origin.index].name;
  return {};
}

/// The steps go the way of every output: lowered, presented, and read in their closed forms.
Result<ReadableSteps> steps(const Lagrangian& lagrangian, const CheckedModel& checked,
                            const Limits& limits) {
  const Result<Steps> derived = derive_steps(lagrangian);
  if (!derived) return derived.diagnostics;
  Result<Program> lowered = lower(derived->equations, derived->requests, limits);
  if (!lowered) return lowered.diagnostics;
  const Program recursive = cancel(std::move(*lowered));
  Result<Choice> choice = choose(recursive, present(recursive), {});
  if (!choice) return choice.diagnostics;
  ReadableSteps result{std::move(choice->program), {}};
  for (const Entity& mass : derived->masses) {
    result.masses.push_back(name_of(checked.model, mass));
  }
  return result;
}

/// What is made of the equations, into `out`; without a Lagrangian no stage runs.
void run_outputs(Stages& stages, Products& out, const std::optional<Lagrangian>& lagrangian,
                 const PipelineOptions& options) {
  const Limits& limits = options.limits;
  const auto equations =
      stages.run("derive", [&] { return derive(*lagrangian, out.checked->scene.outputs, limits); });
  auto lowered =
      stages.run("lower", [&] { return lower(*equations, out.checked->scene.outputs, limits); });
  const auto recursive =
      stages.run("cancel", [&] { return Result<Program>(cancel(std::move(*lowered))); });
  auto forms = stages.run("present",
                          [&] { return presented(*lagrangian, *out.checked, *recursive, limits); });
  auto choice = stages.run("choose", [&] {
    return choose(*recursive, forms->reduced ? forms->reduced->forms : forms->exact,
                  out.checked->scene);
  });
  if (forms) out.closed_forms = std::move(forms->exact);
  if (choice) {
    out.program = std::move(choice->program);
    if (forms->reduced) out.program->reduction = std::move(forms->reduced->reduction);
    out.costs = std::move(choice->costs);
  }
  out.files = stages.run(
      "emit", [&] { return emit(out.checked->model, out.checked->scene, *out.program); });
  out.readback = stages.run("readback", [&] {
    out.written = sources_of(*out.files);
    return read_back(out.written, *out.checked, *out.program);
  });
  auto judging = stages.run("parts", [&] {
    return parts(*lagrangian, *out.checked, *recursive, limits, options.derives_parts);
  });
  if (judging) out.parts = std::move(judging->program);
}

}  // namespace

const std::vector<std::string>& stage_names() {
  static const std::vector<std::string> names{
      "parse",  "check",   "inspect", "formulate", "specialise", "derive", "lower",
      "cancel", "present", "choose",  "emit",      "readback",   "parts"};
  return names;
}

Products run_pipeline(const Inputs& inputs, const PipelineOptions& options) {
  Products out;
  Stages stages(options, out);
  const Limits& limits = options.limits;

  auto syntax = stages.run("parse", [&] { return parse(inputs, limits); });
  out.checked = stages.run("check", [&] {
    return check(syntax->model, syntax->scene ? &*syntax->scene : nullptr, options.scene, limits);
  });
  if (out.checked && options.only_output) {
    std::vector<OutputRequest>& outputs = out.checked->scene.outputs;
    outputs = {outputs[*options.only_output]};
  }
  // A derivation step by step shows no output, so none is missing from it.
  if (out.checked && options.steps) out.checked->scene.left_out.clear();
  stages.run("inspect", [&] {
    Diagnostics found = inspect(out.checked->model, out.checked->scene);
    return Result<Inspection>({found}, found);
  });
  const auto lagrangian = stages.run("formulate", [&] { return formulate(out.checked->model); });
  const auto specialised =
      stages.run("specialise", [&] { return specialise(*lagrangian, *out.checked); });
  if (options.steps) {
    out.steps = stages.run("derive", [&] { return steps(*specialised, *out.checked, limits); });
  } else {
    run_outputs(stages, out, specialised, options);
  }
  if (options.check_itself && !options.steps) {
    const double generation = stages.seconds();
    out.self_check = stages.run(
        "self-check", [&] { return checked(*out.checked, *out.program, out.parts, generation); });
  }
  sort_by_position(out.diagnostics);
  return out;
}

}  // namespace elgen
