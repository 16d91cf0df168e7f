// The pipeline: one model and perhaps one scene, through every stage, to a checked Program and its
// files.
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
/// None where no stage is called so.
[[nodiscard]] std::optional<Goal> goal_named(std::string_view name);

/// A row of analyses.def, as stages and commands read it.
struct AnalysisRow {
  Goal goal;
  /// The outputs that it derives from the Lagrangian; null: it takes the result of another
  /// analysis.
  std::vector<OutputRequest> (*outputs)(const Model& model) = nullptr;
  /// It solves no equation of motion, so `inspect` judges these outputs and not those of the scene.
  bool inspects_outputs = false;
  /// It refuses constraints (E539), and this is the hint; empty: it takes them.
  std::string_view instead_of_constraints = {};
  /// It needs one potential, so open functions are replaced by their samples.
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
  /// Dumps its product as text into Products::dump, if that is equations or a program.
  std::optional<Goal> dump = {};
  /// The stages whose products are wanted; those that they need run before them.
  std::vector<Goal> goals = {Goal::self_check};
  /// Motions are those about this [[equilibrium]] of the model, or with an empty name about the
  /// start, which has to be one; without a name about all that are stable.
  std::optional<std::string> about = {};
  std::function<void(const std::string&)> on_stage = {};  ///< told each name as it starts
};

struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

/// The products of the stages; a stage that did not run leaves its product empty.
struct Products {
  std::optional<CheckedModel> checked = {};
  std::optional<Program> lowered = {};  ///< before terms cancel and forms are chosen
  std::optional<ClosedForms> closed_forms = {};
  std::optional<Program> program = {};  ///< each function in its chosen form
  std::vector<FormCosts> costs = {};
  std::optional<ReadableSteps> steps = {};
  std::optional<Book> book = {};
#define ELGEN_ANALYSIS(id, name, source, Found, ...) std::optional<Found> id = {};
#include "elgen/analyses.def"
  std::optional<std::vector<JudgedEquilibrium>> claims = {};  ///< of [[equilibrium]]
  std::optional<EmittedFiles> files = {};
  std::optional<SelfCheck> self_check = {};
  Diagnostics diagnostics = {};
  std::string dump = {};
  std::vector<StageTime> times = {};
};

/// Runs the stages that the goals need, until one reports an error. E911: the self-check failed;
/// E521: an output has no value at any state.
[[nodiscard]] Products run_pipeline(const Inputs& inputs, const PipelineOptions& options);

/// The times of the stages from `formulate` to `choose` for one output of the scene, by its place
/// there.
[[nodiscard]] std::vector<StageTime> times_alone(const CheckedModel& checked, std::size_t output,
                                                 const Limits& limits);

}  // namespace elgen
