// stages: what is the same for every stage of a Compilation: it runs once, after those it needs, on
// a clock of its own, and what it finds or throws becomes diagnostics.
#pragma once

#include <chrono>
#include <new>
#include <optional>
#include <utility>

#include "elgen/pipeline.hpp"

namespace elgen {

/// A stage's product, once it was asked for.
template <class T>
struct Stage {
  std::optional<T> product = {};
  bool was_asked_for = false;
};

/// Runs stages, and keeps what they say of themselves.
class StageRunner {
 public:
  explicit StageRunner(const PipelineOptions& options) : options_(options) {}

  /// The stage's product, made from those it needs when it is first asked for; null where it, or
  /// one that it needs, failed. After an error no stage runs.
  template <class T, class Make, class... Needs>
  T* product(const std::string& name, Stage<T>& stage, const Make& make, Needs*... needs) {
    const bool can_run = !stage.was_asked_for && !has_errors(diagnostics);
    stage.was_asked_for = true;
    if (can_run && (... && (needs != nullptr))) {
      stage.product = timed(name, [&] { return make(*needs...); });
    }
    return stage.product ? &*stage.product : nullptr;
  }

  Diagnostics diagnostics = {};
  std::string dumped = {};  ///< the product of options.dump_stage
  std::vector<StageTime> times = {};

 private:
  template <class Make>
  auto timed(const std::string& name, const Make& make) -> decltype(make().value) {
    const auto start = std::chrono::steady_clock::now();
    auto result = guarded(name, make);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    times.push_back({name, elapsed.count()});
    diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
    if (result && name == options_.dump_stage) dumped = dump(*result);
    return std::move(result.value);
  }

  /// A mistake of ours must not swallow what earlier stages found.
  template <class Make>
  auto guarded(const std::string& name, const Make& make) -> decltype(make()) {
    try {
      if (options_.on_stage) options_.on_stage(name);
      return make();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& mistake) {
      return Diagnostic{Code::E912, {}, "internal error in `" + name + "`: " + mistake.what()};
    }
  }

  const PipelineOptions& options_;
};

}  // namespace elgen
