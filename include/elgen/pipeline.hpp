// The pipeline: runs the stages on one model and an optional scene. The result is a checked Program
// and its files.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/base_parameters.hpp"
#include "elgen/certificate.hpp"
#include "elgen/choose.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/emitted_files.hpp"
#include "elgen/limits.hpp"
#include "elgen/model.hpp"
#include "elgen/page.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

struct PipelineSources {
  SourcePointer model = {};
  SourcePointer scene = {};  ///< null: the built-in scene `full`
};

/// The stages of the pipeline, in the order of execution (goals.def).
enum class Goal : std::uint8_t {
#define ELGEN_GOAL(id, name) id,
#include "elgen/goals.def"
};
inline constexpr std::array stage_names{
#define ELGEN_GOAL(id, name) std::string_view(name),
#include "elgen/goals.def"
};

[[nodiscard]] constexpr std::string_view name_of(Goal goal) {
  return stage_names[static_cast<std::size_t>(goal)];
}
/// The stage with this name; none if no stage has the name.
[[nodiscard]] std::optional<Goal> find_stage(std::string_view name);

/// A row of analyses.def, for stages and commands.
struct AnalysisRow {
  Goal stage;
  /// The outputs that the analysis needs. Null: the analysis uses the result of another analysis.
  std::vector<OutputRequest> (*outputs)(const Model& model) = nullptr;
  /// True: `inspect` checks these outputs, not the outputs of the scene, because the analysis does
  /// not solve for accelerations.
  bool inspects_outputs = false;
  /// The hint of E539 if the analysis rejects models with constraints; empty: it accepts them.
  std::string_view constraint_hint = {};
  /// True: each open function is replaced by its `sample`, because the analysis needs a potential.
  bool samples_open_functions = false;
};
inline constexpr std::array analysis_table{
#define ELGEN_ANALYSIS(id, name, source, Found, find, page, json, ...) \
  AnalysisRow{.stage = Goal::id, __VA_ARGS__},
#include "elgen/analyses.def"
};

/// The row of the stage `goal`; null if the stage is no analysis.
[[nodiscard]] constexpr const AnalysisRow* find_analysis(Goal goal) {
  const auto* const row = std::ranges::find(analysis_table, goal, &AnalysisRow::stage);
  return row == analysis_table.end() ? nullptr : row;
}

struct PipelineOptions {
  SceneOptions scene = {};
  Limits limits = {};
  /// The stage whose result is written as text to Products::dump; none: no dump.
  std::optional<Goal> dump = {};
  /// The stages to run. Every stage that one of these stages needs also runs.
  std::vector<Goal> goals = {Goal::self_check};
  /// The equilibrium to analyse: the name of an [[equilibrium]], or "" for the start of the model,
  /// which must be an equilibrium. None: all equilibria; the analysis `modes` then uses only the
  /// stable equilibria.
  std::optional<std::string> equilibrium_name = {};
  /// Called at the start of each stage, with its name.
  std::function<void(const std::string&)> on_stage = {};
};

struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

/// The results of the stages. The result of a stage that did not run is empty.
struct Products {
  std::optional<CheckedModel> checked = {};
  std::optional<Program> lowered = {};  ///< the result of the stage lower, before the stage cancel
  std::optional<ClosedForms> closed_forms = {};
  std::optional<Program> program = {};  ///< every function in its chosen form
  std::vector<FormCosts> costs = {};
  std::optional<ReadableDerivation> steps = {};
  std::optional<PagePrograms> page_programs = {};
#define ELGEN_ANALYSIS(id, name, source, Found, ...) std::optional<Found> id = {};
#include "elgen/analyses.def"
  /// One verdict per [[equilibrium]] of the model, in file order.
  std::optional<std::vector<EquilibriumVerdict>> claims = {};
  std::optional<EmittedFiles> files = {};
  std::optional<SelfCheck> self_check = {};
  Diagnostics diagnostics = {};
  std::string dump = {};
  std::vector<StageTime> times = {};
};

/// Runs options.goals and the stages that the goals need, until a stage reports an error. Errors of
/// the stages; also E911: the self-check failed; E521: an output has no value at any state.
[[nodiscard]] Products run_pipeline(const PipelineSources& inputs, const PipelineOptions& options);

/// Runs the stages from `formulate` to `choose` for the request checked.scene.outputs[output]
/// alone. Returns the time of each stage.
[[nodiscard]] std::vector<StageTime> output_stage_times(const CheckedModel& checked,
                                                        std::size_t output, const Limits& limits);

}  // namespace elgen
