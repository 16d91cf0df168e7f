// The order of the stages, and the only place that knows it:
//
//     parse -> check -> inspect -> formulate -> specialise -> derive -> lower -> cancel -> present
//     -> choose -> emit -> readback -> self-check
//
//     specialise -> steps    the derivation as a student writes it
//     cancel -> parts        what solutions are judged by
#include "elgen/pipeline.hpp"

#include <algorithm>
#include <utility>

#include "elgen/cancel.hpp"
#include "elgen/choose.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/inspect.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "elgen/specialise.hpp"
#include "pipeline/dumps.hpp"
#include "pipeline/parts.hpp"
#include "pipeline/presented.hpp"
#include "pipeline/readable_steps.hpp"
#include "pipeline/stages.hpp"

namespace elgen {

namespace {

Result<Syntaxes> parse(const Inputs& inputs, const Limits& limits) {
  Result<FileSyntax> model = parse_model(inputs.model, limits);
  if (inputs.scene == nullptr) {
    if (!model) return model.diagnostics;
    return {{std::move(*model), std::nullopt}, std::move(model.diagnostics)};
  }
  Result<FileSyntax> scene = parse_scene(inputs.scene, limits);
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

/// The reduction goes with the program whose closed forms it changed.
Result<Choice> chosen(const Program& recursive, const Presented& forms, const Scene& scene) {
  const bool is_reduced = forms.reduced.has_value();
  Result<Choice> choice = choose(recursive, is_reduced ? forms.reduced->forms : forms.exact, scene);
  if (choice && is_reduced) choice->program.reduction = forms.reduced->reduction;
  return choice;
}

/// Each stage runs when its product is first asked for, after those it needs; null where it, or one
/// that it needs, failed.
class Compilation {
 public:
  Compilation(const Inputs& inputs, const PipelineOptions& options)
      : inputs_(inputs), options_(options), run_(options) {}

  /// A model that was checked before is not checked again.
  Compilation(CheckedModel checked, const PipelineOptions& options)
      : options_(options), run_(options) {
    syntaxes_.was_asked_for = true;
    checked_ = {std::move(checked), true};
    inspection_ = {Inspection{}, true};
  }

  void reach(std::string_view goal) {
    for (const Row& row : rows()) {
      if (row.name == goal) row.reach(*this);
    }
  }

  Products products() && {
    Products out;
    out.checked = std::move(checked_.product);
    if (forms_.product) out.closed_forms = std::move(forms_.product->exact);
    if (choice_.product) out.program = std::move(choice_.product->program);
    if (choice_.product) out.costs = std::move(choice_.product->costs);
    if (parts_.product) out.parts = std::move(parts_.product->program);
    out.steps = std::move(steps_.product);
    out.files = std::move(files_.product);
    out.written = std::move(written_);
    out.readback = readback_.product;
    out.self_check = std::move(self_check_.product);
    out.diagnostics = std::move(run_.diagnostics);
    sort_by_position(out.diagnostics);
    out.dump = std::move(run_.dumped);
    out.times = std::move(run_.times);
    return out;
  }

  static std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const Row& row : rows()) names.emplace_back(row.name);
    return names;
  }

 private:
  struct Row {
    std::string_view name;
    void (*reach)(Compilation&);
  };

  static const std::vector<Row>& rows() {
    using C = Compilation;
    static const std::vector<Row> table{
        {"parse", [](C& c) { c.syntaxes(); }},        {"check", [](C& c) { c.checked(); }},
        {"inspect", [](C& c) { c.inspection(); }},    {"formulate", [](C& c) { c.formulated(); }},
        {"specialise", [](C& c) { c.lagrangian(); }}, {"steps", [](C& c) { c.steps(); }},
        {"derive", [](C& c) { c.equations(); }},      {"lower", [](C& c) { c.lowered(); }},
        {"cancel", [](C& c) { c.recursive(); }},      {"present", [](C& c) { c.forms(); }},
        {"choose", [](C& c) { c.choice(); }},         {"emit", [](C& c) { c.files(); }},
        {"readback", [](C& c) { c.readback(); }},     {"parts", [](C& c) { c.parts(); }},
        {"self-check", [](C& c) { c.self_check(); }}};
    return table;
  }

  Syntaxes* syntaxes() {
    return run_.product("parse", syntaxes_, [this] { return parse(inputs_, options_.limits); });
  }

  CheckedModel* checked() {
    const auto make = [this](const Syntaxes& s) {
      return check(s.model, s.scene ? &*s.scene : nullptr, options_.scene, options_.limits);
    };
    return run_.product("check", checked_, make, syntaxes());
  }

  Inspection* inspection() {
    const auto make = [this](CheckedModel& c) {
      // A derivation step by step shows no output, so none is missing from it.
      if (options_.goals == std::vector<std::string>{"steps"}) c.scene.left_out.clear();
      Diagnostics found = inspect(c.model, c.scene);
      return Result<Inspection>({found}, found);
    };
    return run_.product("inspect", inspection_, make, checked());
  }

  Lagrangian* formulated() {
    const auto make = [](const CheckedModel& c, Inspection&) { return formulate(c.model); };
    return run_.product("formulate", formulated_, make, checked(), inspection());
  }

  Lagrangian* lagrangian() {
    const auto make = [](const Lagrangian& l, const CheckedModel& c) { return specialise(l, c); };
    return run_.product("specialise", lagrangian_, make, formulated(), checked());
  }

  ReadableSteps* steps() {
    const auto make = [this](const Lagrangian& l, const CheckedModel& c) {
      return readable_steps(l, c.model, options_.limits);
    };
    return run_.product("steps", steps_, make, lagrangian(), checked());
  }

  EquationsOfMotion* equations() {
    const auto make = [this](const Lagrangian& l, const CheckedModel& c) {
      return derive(l, c.scene.outputs, options_.limits);
    };
    return run_.product("derive", equations_, make, lagrangian(), checked());
  }

  Program* lowered() {
    const auto make = [this](const EquationsOfMotion& e, const CheckedModel& c) {
      return lower(e, c.scene.outputs, options_.limits);
    };
    return run_.product("lower", lowered_, make, equations(), checked());
  }

  Program* recursive() {
    const auto make = [](Program& p) { return Result<Program>(cancel(std::move(p))); };
    return run_.product("cancel", recursive_, make, lowered());
  }

  Presented* forms() {
    const auto make = [this](const Lagrangian& l, const CheckedModel& c, const Program& p) {
      return presented(l, c, p, options_.limits);
    };
    return run_.product("present", forms_, make, lagrangian(), checked(), recursive());
  }

  Choice* choice() {
    const auto make = [](const Program& p, const Presented& f, const CheckedModel& c) {
      return chosen(p, f, c.scene);
    };
    return run_.product("choose", choice_, make, recursive(), forms(), checked());
  }

  EmittedFiles* files() {
    const auto make = [](const CheckedModel& m, const Choice& c) {
      return emit(m.model, m.scene, c.program);
    };
    return run_.product("emit", files_, make, checked(), choice());
  }

  Readback* readback() {
    const auto make = [this](const EmittedFiles& f, const CheckedModel& m, const Choice& c) {
      written_ = sources_of(f);
      return read_back(written_, m, c.program);
    };
    return run_.product("readback", readback_, make, files(), checked(), choice());
  }

  SolutionParts* parts() {
    const auto make = [this](const Lagrangian& l, const CheckedModel& c, const Program& p) {
      return elgen::parts(l, c, p, options_.limits);
    };
    return run_.product("parts", parts_, make, lagrangian(), checked(), recursive());
  }

  /// Its share of the time that all before it took.
  SelfCheck* self_check() {
    const auto make = [this](const CheckedModel& m, const Choice& c, const Program& p, Readback&) {
      double generation = 0;
      for (const StageTime& time : run_.times) generation += time.seconds;
      return elgen::checked(m, c.program, known_parts(m, p), generation);
    };
    return run_.product("self-check", self_check_, make, checked(), choice(), recursive(),
                        readback());
  }

  Inputs inputs_ = {};
  const PipelineOptions& options_;
  Stage<Syntaxes> syntaxes_ = {};
  Stage<CheckedModel> checked_ = {};
  Stage<Inspection> inspection_ = {};
  Stage<Lagrangian> formulated_ = {};
  Stage<Lagrangian> lagrangian_ = {};
  Stage<ReadableSteps> steps_ = {};
  Stage<EquationsOfMotion> equations_ = {};
  Stage<Program> lowered_ = {};
  Stage<Program> recursive_ = {};
  Stage<Presented> forms_ = {};
  Stage<Choice> choice_ = {};
  Stage<EmittedFiles> files_ = {};
  std::vector<SourcePointer> written_ = {};
  Stage<Readback> readback_ = {};
  Stage<SolutionParts> parts_ = {};
  Stage<SelfCheck> self_check_ = {};
  StageRunner run_;
};

}  // namespace

const std::vector<std::string>& stage_names() {
  static const std::vector<std::string> names = Compilation::names();
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
