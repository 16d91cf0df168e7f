// compile_timed_functions: compiles and loads the timing driver, and keeps the states as the
// driver's arrays. compile_step_loops: compiles and loads the loops over a step.
#include <algorithm>
#include <utility>

#include "base/no_interrupts.hpp"
#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

/// For each leaf, its values in all states.
template <class Scalar>
using StateArrays = LeafMembers<std::vector<Scalar>, std::vector<Scalar>>;

template <class Scalar>
StateArrays<Scalar> arrays_of(const std::vector<Arguments<double>>& states) {
  StateArrays<Scalar> arrays;
  const auto append = [&states](std::vector<Scalar>& array, const auto& value_in) {
    for (const Arguments<double>& state : states) {
      array.push_back(static_cast<Scalar>(value_in(state)));
    }
  };
#define ELGEN_LEAVES(kind, member, ...)                                                     \
  for (std::size_t k = 0; k < states.front().member.size(); ++k) {                          \
    append(arrays.member, [k](const Arguments<double>& state) { return state.member[k]; }); \
  }
#define ELGEN_LEAF(kind, member, ...) \
  append(arrays.member, [](const Arguments<double>& state) { return state.member; });
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  return arrays;
}

template <class Scalar>
class LoadedTimedFunction final : public TimedFunction {
 public:
  LoadedTimedFunction(std::shared_ptr<const SharedLibrary> library,
                      TimingDriverFunction<Scalar> function,
                      const std::vector<Arguments<double>>& states, std::size_t entries,
                      bool varies)
      : library_(std::move(library)),
        function_(function),
        count_(states.size()),
        arrays_(arrays_of<Scalar>(states)),
        results_(entries * states.size()),
        varies_(varies) {
    arrays_.parameters.clear();  // run() uses the parameters of the model
  }

  void run() override { compute(count_, arrays_, results_); }

  [[nodiscard]] std::vector<double> values_at(
      const std::vector<Arguments<double>>& states) const override {
    if (!varies_) return values_of(states);
    std::vector<double> values(results_.size() / count_ * states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      const std::vector<double> entries = values_of({states[i]});
      for (std::size_t k = 0; k < entries.size(); ++k) values[k * states.size() + i] = entries[k];
    }
    return values;
  }

 private:
  [[nodiscard]] std::vector<double> values_of(const std::vector<Arguments<double>>& states) const {
    std::vector<Scalar> results(results_.size() / count_ * states.size());
    compute(states.size(), arrays_of<Scalar>(states), results);
    return {results.begin(), results.end()};
  }

  void compute(std::size_t count, const StateArrays<Scalar>& arrays,
               std::vector<Scalar>& results) const {
    function_(count,
#define ELGEN_LEAVES(kind, member, ...) arrays.member.empty() ? nullptr : arrays.member.data(),
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
              results.data());
  }

  std::shared_ptr<const SharedLibrary> library_;
  TimingDriverFunction<Scalar> function_;
  std::size_t count_;
  StateArrays<Scalar> arrays_;
  std::vector<Scalar> results_;
  bool varies_;  ///< true: each state of values_at() has its own parameters
};

/// The timed function of this symbol; null if the library lacks the symbol.
template <class Scalar>
std::unique_ptr<TimedFunction> load_timed_function(
    const std::shared_ptr<const SharedLibrary>& library, const std::string& symbol,
    const std::vector<Arguments<double>>& states, std::size_t entries, bool varies) {
  const auto function = library->find<TimingDriverFunction<Scalar>>(symbol);
  if (function == nullptr) return nullptr;
  return std::make_unique<LoadedTimedFunction<Scalar>>(library, function, states, entries, varies);
}

Result<std::shared_ptr<const SharedLibrary>> build_for_timing(const EmittedFiles& files,
                                                              const SourceFile& source,
                                                              const Limits& limits) {
  const SignalBlocker until_removed;
  const Result<CompilerSession> workshop = CompilerSession::open(files, {source}, limits);
  if (!workshop) return workshop.diagnostics;
  Result<SharedLibrary> built = workshop->build(source, BuildFlags::timing);
  if (!built) return built.diagnostics;
  return std::make_shared<const SharedLibrary>(std::move(*built));
}

}  // namespace

Result<TimedFunctions> compile_timed_functions(const EmittedFiles& files, const Model& model,
                                               const Scene& scene, const Program& program,
                                               const TimingOptions& options) {
  const SourceFile source = timing_driver({model, scene, program}, options.variants);
  const Result<std::shared_ptr<const SharedLibrary>> library =
      build_for_timing(files, source, options.limits);
  if (!library) return library.diagnostics;
  const std::size_t entries = entry_count(program.functions.front());
  const bool varies = !scene.numerics.varied_parameters.empty();
  TimedFunctions functions;
  for (std::size_t i = 0; i < options.variants.size(); ++i) {
    const bool is_float = options.variants[i].scalar == ScalarKind::single_precision;
    const auto load = is_float ? &load_timed_function<float> : &load_timed_function<double>;
    functions.push_back(load(*library, timed_symbol(i), options.states, entries, varies));
    if (functions.back() == nullptr) return missing_function_error();
  }
  return Result<TimedFunctions>(std::move(functions));
}

Result<StepLoops> compile_step_loops(const EmittedFiles& files, const Model& model,
                                     const Scene& scene, const Program& program,
                                     const Limits& limits) {
  const Result<std::shared_ptr<const SharedLibrary>> library =
      build_for_timing(files, step_driver({model, scene, program}), limits);
  if (!library) return library.diagnostics;
  const auto step = std::ranges::find(program.functions, OutputKind::step, &Function::kind);
  const StepLoops loops{.code = *library,
                        .one_state_loop = (*library)->find<StepLoop>(single_step_loop_symbol),
                        .pack_loop = (*library)->find<StepLoop>(pack_step_loop_symbol),
                        .entries = entry_count(*step)};
  if (loops.one_state_loop == nullptr || loops.pack_loop == nullptr)
    return missing_function_error();
  return loops;
}

}  // namespace elgen
