// compile: builds a shared object from each driver unit in a workshop, and loads it.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/no_interrupts.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver.hpp"
#include "toolchain/interpreted.hpp"
#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

struct LoadedFunction {
  std::string name;
  std::size_t entries = 0;
  DriverFunction<double> in_double = nullptr;
  DriverFunction<float> in_float = nullptr;
};

class LoadedModel final : public CompiledModel {
 public:
  LoadedModel(std::shared_ptr<const SharedLibrary> library, std::vector<LoadedFunction> functions)
      : library_(std::move(library)), functions_(std::move(functions)) {}

  [[nodiscard]] DriverFunction<double> find(std::string_view function) const override {
    const auto found = std::ranges::find(functions_, function, &LoadedFunction::name);
    return found == functions_.end() ? nullptr : found->in_double;
  }
  [[nodiscard]] std::vector<double> call(std::string_view function,
                                         const Arguments<double>& arguments) const override {
    return invoke(function, arguments, &LoadedFunction::in_double);
  }
  [[nodiscard]] std::vector<float> call(std::string_view function,
                                        const Arguments<float>& arguments) const override {
    return invoke(function, arguments, &LoadedFunction::in_float);
  }
  [[nodiscard]] bool has(ScalarKind scalar) const override {
    return !functions_.empty() &&
           (scalar == ScalarKind::double_precision ? functions_.front().in_double != nullptr
                                                   : functions_.front().in_float != nullptr);
  }

 private:
  template <class Scalar>
  std::vector<Scalar> invoke(std::string_view name, const Arguments<Scalar>& arguments,
                             DriverFunction<Scalar> LoadedFunction::*function) const {
    const auto found = std::ranges::find(functions_, name, &LoadedFunction::name);
    if (found == functions_.end() || (*found).*function == nullptr) return {};
    std::vector<Scalar> result(found->entries);
    call_compiled_function((*found).*function, argument_pointers(arguments), result.data());
    return result;
  }

  std::shared_ptr<const SharedLibrary> library_;
  std::vector<LoadedFunction> functions_;
};

/// The functions of a driver. `in_double` or `in_float` is null if the driver lacks this scalar.
std::vector<LoadedFunction> functions_of(const Driver& driver, const SharedLibrary& library,
                                         const Program& program) {
  std::vector<LoadedFunction> functions;
  const auto add = [&](std::string name, std::size_t number, std::size_t entries) {
    functions.push_back({std::move(name), entries,
                         library.find<DriverFunction<double>>(
                             driver_symbol(driver.name, name_of(scalar_kind<double>), number)),
                         library.find<DriverFunction<float>>(
                             driver_symbol(driver.name, name_of(scalar_kind<float>), number))});
  };
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    if (is_wrapped(driver, function)) add(function.name, i, entry_count(function));
  }
  if (driver.uses_packs && !driver.is_wide)
    add(std::string(sine_and_cosine), program.functions.size(), 2);
  return functions;
}

std::size_t scalar_count(const LoadedFunction& function) {
  return (function.in_double != nullptr ? 1U : 0U) + (function.in_float != nullptr ? 1U : 0U);
}

/// The header of a driver; `library` is the object of the driver's unit, or null if the compiler
/// does not accept the flags of the build.
Result<CompiledHeader> load_header(const Driver& driver, BuildFlags build,
                                   const std::shared_ptr<const SharedLibrary>& library,
                                   const DriverInput& input) {
  CompiledHeader header{driver.types, driver.uses_packs, nullptr, build};
  header.is_wide = driver.is_wide;
  if (library == nullptr) {
    header.failure_reason = "the compiler does not take -O3 -march=native";
    return header;
  }
  std::vector<LoadedFunction> functions = functions_of(driver, *library, input.program);
  const auto have = [&functions](std::size_t scalars) {
    return std::ranges::all_of(functions, [scalars](const LoadedFunction& function) {
      return scalar_count(function) == scalars;
    });
  };
  if (!driver.needs.empty() && have(0)) {
    header.failure_reason = fmt::format("<{}> is not installed", driver.needs);
    return header;
  }
  if (!have(scalars_of(driver, input).size())) return missing_function_error();
  header.functions = std::make_unique<LoadedModel>(library, std::move(functions));
  return header;
}

/// Sets the declared numbers to the values that the library returns; false if the library lacks the
/// function `declarations_symbol`.
bool read_declared_numbers(const SharedLibrary& library, std::vector<DeclaredNumber>& numbers) {
  const auto give = library.find<void (*)(double*)>(declarations_symbol);
  if (give == nullptr) return false;
  std::vector<double> given(numbers.size());
  give(given.data());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i].declared = given[i];
  return true;
}

/// The driver units of all builds; `declared` is appended to the first unit.
std::vector<DriverUnit> all_units(const DriverInput& input, const std::vector<BuildFlags>& builds,
                                  const std::string& declared) {
  std::vector<DriverUnit> all;
  for (const BuildFlags build : builds) {
    std::vector<DriverUnit> some = make_driver_units(input, build, all.empty() ? declared : "");
    std::ranges::move(some, std::back_inserter(all));
  }
  return all;
}

}  // namespace

namespace {

template <class Scalar>
FunctionResults<Scalar> call_each_state(const CompiledModel& code,
                                        const std::vector<std::string_view>& functions,
                                        const std::vector<Arguments<Scalar>>& states) {
  FunctionResults<Scalar> values(functions.size());
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (const auto& state : states) values[i].push_back(code.call(functions[i], state));
  }
  return values;
}

}  // namespace

Result<FunctionResults<double>> CompiledModel::call_at_states(
    const std::vector<std::string_view>& functions,
    const std::vector<Arguments<double>>& states) const {
  return call_each_state(*this, functions, states);
}

Result<FunctionResults<float>> CompiledModel::call_at_states(
    const std::vector<std::string_view>& functions,
    const std::vector<Arguments<float>>& states) const {
  return call_each_state(*this, functions, states);
}

Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model, const Scene& scene,
                                const Program& program, const CompileOptions& options) {
  const DriverInput input{model, scene, program};
  if (language_row(scene.emission.language).is_interpreted) {
    return load_interpreted_module(files, input, options.limits);
  }
  DeclarationReader declared;
  if (options.reads_declared_numbers) declared = make_declaration_reader(input);
  const std::vector<DriverUnit> units = all_units(input, options.builds, declared.text);
  std::vector<SourceFile> sources;
  for (const DriverUnit& unit : units) sources.push_back(unit.source);
  const SignalBlocker until_removed;
  const Result<CompilerSession> workshop = CompilerSession::open(files, sources, options.limits);
  if (!workshop) return workshop.diagnostics;
  CompiledHeaders headers;
  for (const auto& [source, build, all] : units) {
    Result<SharedLibrary> built = workshop->build(source, build);
    const bool is_flag_refused =
        !built && build != BuildFlags::as_written && !workshop->accepts_flags(build, source);
    if (!built && !is_flag_refused) return built.diagnostics;
    std::shared_ptr<const SharedLibrary> library;
    if (built) library = std::make_shared<const SharedLibrary>(std::move(*built));
    const bool declares = headers.empty() && options.reads_declared_numbers && library != nullptr;
    if (declares && !read_declared_numbers(*library, declared.numbers))
      return missing_function_error();
    for (const Driver& driver : all) {
      Result<CompiledHeader> header = load_header(driver, build, library, input);
      if (!header) return header.diagnostics;
      headers.push_back(std::move(*header));
    }
  }
  headers.front().declared = std::move(declared.numbers);
  return headers;
}

}  // namespace elgen
