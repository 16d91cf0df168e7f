// stages: the stages of a Compilation and their runner. A stage runs at most once, after the stages
// that it needs. Its time is measured, and its errors and exceptions become diagnostics.
#pragma once

#include <cln/exception.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <functional>
#include <new>
#include <optional>
#include <tuple>
#include <utility>

#include "base/reason.hpp"
#include "elgen/pipeline.hpp"

namespace elgen {

/// Runs stages, and collects their diagnostics and times.
class StageRunner {
 public:
  explicit StageRunner(const PipelineOptions& options) : options_(options) {}
  StageRunner(const StageRunner&) = delete;
  StageRunner& operator=(const StageRunner&) = delete;

  Diagnostics diagnostics = {};
  std::string dump_text = {};  ///< the text of the product that options.dump selects
  std::vector<StageTime> times = {};

  /// Runs a stage and returns its product. None if this stage or an earlier stage has an error, or
  /// if one of `needs` is null.
  template <class T, class Make, class... Needs>
  std::optional<T> run_stage(Goal goal, const Make& make, const Needs*... needs) {
    if (has_errors(diagnostics) || (... || (needs == nullptr))) return std::nullopt;
    const auto start = std::chrono::steady_clock::now();
    Result<T> result = run_guarded<T>(std::string(name_of(goal)), make, *needs...);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    times.push_back({std::string(name_of(goal)), elapsed.count()});
    diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
    if constexpr (requires { dump(*result); }) {  // only equations and programs have a text
      if (result && goal == options_.dump) dump_text = dump(*result);
    }
    return std::move(result.value);
  }

  /// Registers `reach` for `goal`. `reach` runs the stages that the stage of this goal needs, then
  /// this stage.
  void register_stage(Goal goal, std::function<void()> reach) {
    stages_[static_cast<std::size_t>(goal)] = std::move(reach);
  }
  void run_through(Goal goal) const { stages_[static_cast<std::size_t>(goal)](); }

 private:
  /// Calls `make`. Exceptions become diagnostics, so that the diagnostics of earlier stages are
  /// still reported.
  template <class T, class Make, class... Needs>
  Result<T> run_guarded(const std::string& name, const Make& make, const Needs&... needs) {
    try {
      if (options_.on_stage) options_.on_stage(name);
      if constexpr (std::is_invocable_v<Make, const Needs&..., const Limits&>) {
        return make(needs..., options_.limits);
      } else {
        return make(needs...);
      }
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const cln::runtime_exception& limit) {
      return Diagnostic{
          Code::E910, {}, fmt::format("numbers are too large in `{}`: {}", name, limit.what())};
    } catch (const std::exception& mistake) {
      return Diagnostic{
          Reason::exception, {}, "internal error in `" + name + "`: " + mistake.what()};
    }
  }

  const PipelineOptions& options_;
  std::array<std::function<void()>, stage_names.size()> stages_ = {};
};

/// A stage: get() makes its product on the first call, from the products of other stages.
template <class T>
class Stage {
 public:
  /// `needs`: std::tie of the stages whose products `make` takes, in this order; `make` may also
  /// take the limits as last argument.
  template <class Needs, class Make>
  Stage(StageRunner& run, Goal goal, const Needs& needs, Make make)
      : make_([=, &run, make = std::move(make)] {
          const auto made = [&](auto&... stages) {
            return run.run_stage<T>(goal, make, stages.get()...);
          };
          return std::apply(made, needs);
        }) {
    run.register_stage(goal, [this] { get(); });
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// The product; null if this stage, or a stage that it needs, failed.
  const T* get() {
    if (!std::exchange(has_run_, true)) product = make_();
    return product ? &*product : nullptr;
  }

  /// Sets the product, so that the stage does not run.
  void set(T known) {
    has_run_ = true;
    product = std::move(known);
  }

  std::optional<T> product = {};

 private:
  std::function<std::optional<T>()> make_;
  bool has_run_ = false;
};

}  // namespace elgen
