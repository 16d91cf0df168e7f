// The pipeline: runs one model and an optional scene through the stages, to a checked Program and
// its files.
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

struct Inputs {
  SourcePointer model = {};
  SourcePointer scene = {};  ///< null: the built-in scene `full`
};

/// The stages (goals.def).
enum class Goal : std::uint8_t {
#define ELGEN_GOAL(id, name) id,
#include "elgen/goals.def"
};
inline constexpr std::array goal_names{
#define ELGEN_GOAL(id, name) std::string_view(name),
#include "elgen/goals.def"
};

[[nodiscard]] constexpr std::string_view name_of(Goal goal) {
  return goal_names[static_cast<std::size_t>(goal)];
}
/// None if no stage has the name.
[[nodiscard]] std::optional<Goal> find_goal(std::string_view name);

/// A row of analyses.def, for stages and commands.
struct AnalysisRow {
  Goal goal;
  /// The requests that it derives from the Lagrangian. Null: it reads the result of another
  /// analysis.
  std::vector<OutputRequest> (*outputs)(const Model& model) = nullptr;
  /// It solves no equation of motion, so `inspect` checks these outputs instead of the scene's.
  bool inspects_outputs = false;
  /// The hint of E539 for an analysis that refuses constraints; empty: it accepts them.
  std::string_view instead_of_constraints = {};
  /// It needs one potential, so `sample` replaces each open function.
  bool closes_functions = false;
};
inline constexpr std::array analysis_table{
#define ELGEN_ANALYSIS(id, name, source, Found, find, page, json, ...) \
  AnalysisRow{.goal = Goal::id, __VA_ARGS__},
#include "elgen/analyses.def"
};

/// Null if the stage is no analysis.
[[nodiscard]] constexpr const AnalysisRow* find_analysis(Goal goal) {
  const auto* const row = std::ranges::find(analysis_table, goal, &AnalysisRow::goal);
  return row == analysis_table.end() ? nullptr : row;
}

struct PipelineOptions {
  SceneOptions scene = {};
  Limits limits = {};
  /// A stage whose equations or program are dumped as text into Products::dump.
  std::optional<Goal> dump = {};
  /// The stages whose products are wanted. The stages that they need run too.
  std::vector<Goal> goals = {Goal::self_check};
  /// The equilibrium of the analyses: the name of an [[equilibrium]] of the model, or "" for the
  /// start of the model, which must be an equilibrium. None: all equilibria; modes are about the
  /// stable ones.
  std::optional<std::string> about = {};
  /// Is called with the name of each stage when it starts.
  std::function<void(const std::string&)> on_stage = {};
};

struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

/// The products of the stages. The product of a stage that did not run is empty.
struct Products {
  std::optional<CheckedModel> checked = {};
  std::optional<Program> lowered = {};  ///< before cancellation and the choice of forms
  std::optional<ClosedForms> closed_forms = {};
  std::optional<Program> program = {};  ///< every function in its chosen form
  std::vector<FormCosts> costs = {};
  std::optional<ReadableSteps> steps = {};
  std::optional<Book> book = {};
#define ELGEN_ANALYSIS(id, name, source, Found, ...) std::optional<Found> id = {};
#include "elgen/analyses.def"
  /// Verdicts on [[equilibrium]] entries.
  std::optional<std::vector<EquilibriumVerdict>> claims = {};
  std::optional<EmittedFiles> files = {};
  std::optional<SelfCheck> self_check = {};
  Diagnostics diagnostics = {};
  std::string dump = {};
  std::vector<StageTime> times = {};
};

/// Runs the stages that the goals need, until one reports an error. Errors: the errors of the
/// stages; E911: the self-check failed; E521: an output has no value at any state.
[[nodiscard]] Products run_pipeline(const Inputs& inputs, const PipelineOptions& options);

/// The times of the stages from `formulate` to `choose` for one output, by its position in the
/// scene.
[[nodiscard]] std::vector<StageTime> stage_times_of_output(const CheckedModel& checked,
                                                           std::size_t output,
                                                           const Limits& limits);

}  // namespace elgen
