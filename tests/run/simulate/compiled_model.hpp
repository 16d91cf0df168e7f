// Compiles systems from model texts, and runs the systems.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "elgen/pipeline.hpp"
#include "elgen/simulate.hpp"
#include "support/models.hpp"

namespace elgen::test {

/// Options as given by --state, --input and --set.
inline SceneOptions start_options(const std::string& starts, const std::string& laws = {},
                                  const std::string& values = {}) {
  SceneOptions options;
  if (!starts.empty()) options.starts = {make_source("command line", starts)};
  if (!laws.empty()) options.laws = {make_source("command line", laws)};
  if (!values.empty()) options.values = {make_source("command line", values)};
  return options;
}

/// A system derived as by `elgen simulate`, compiled when first needed. Throws the diagnostics on
/// failure.
class CompiledSystem {
 public:
  explicit CompiledSystem(const std::string& text, const SceneOptions& given = {},
                          const std::optional<StepSpec>& step = {})
      : text_(text), given_(given), products_(derived(step)) {
    if (!products_.files) throw std::runtime_error(format(products_.diagnostics));
  }

  [[nodiscard]] const CheckedModel& checked() const { return *products_.checked; }
  [[nodiscard]] const Program& program() const { return *products_.program; }
  [[nodiscard]] const CompiledModel& functions() const {
    if (headers_.empty()) {
      Result<CompiledHeaders> headers =
          compile(*products_.files, checked().model, checked().scene, program(), {});
      if (!headers) throw std::runtime_error(format(headers.diagnostics));
      headers_ = std::move(*headers);
    }
    return *headers_.front().functions;
  }

  [[nodiscard]] Result<Trajectory> run(const SimulationOptions& options) const {
    const std::optional<StepSpec> step = step_for_run(options);
    if (!step) return simulate(checked(), program(), &functions(), options);
    const Products products = derived(step);
    if (!products.program) return products.diagnostics;
    return simulate(*products.checked, *products.program, nullptr, options);
  }
  /// The trajectory of a run; throws the diagnostics if the run fails.
  [[nodiscard]] Trajectory trajectory(const SimulationOptions& options) const {
    Result<Trajectory> result = run(options);
    if (!result) throw std::runtime_error(format(result.diagnostics));
    return *result;
  }

 private:
  [[nodiscard]] Products derived(const std::optional<StepSpec>& step) const {
    PipelineOptions options;
    options.scene = given_;
    const Model model = checked_model(text_, given_).model;
    options.scene.outputs = {make_source("outputs", outputs_for_run(model))};
    options.scene.step = step;
    options.goals = {Goal::emit};
    return run_pipeline({make_source("test.toml", text_), nullptr}, options);
  }

  std::string text_;
  SceneOptions given_;
  Products products_;
  mutable CompiledHeaders headers_ = {};
};

/// Options for a method with constant steps.
inline SimulationOptions steps_of(const std::string& method, double step, double time) {
  return {.method = method, .duration = time, .step = step};
}

/// The period 2 pi/agm(1, cos(1/2)) of q'' = -sin(q) from rest at 1 rad.
inline constexpr double pendulum_period = 6.69997566437;

}  // namespace elgen::test
