// compile: has a workshop make shared objects of the drivers of all headers, and loads those.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/no_interrupts.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/driver.hpp"
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
  LoadedModel(Library library, std::vector<LoadedFunction> functions)
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
    ((*found).*function)(
#define ELGEN_LEAVES(kind, member, ...) arguments.member.data(),
#define ELGEN_LEAF(kind, member, ...) arguments.member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
        result.data());
    return result;
  }

  Library library_;
  std::vector<LoadedFunction> functions_;
};

/// None where a symbol is missing; functions the driver has for one scalar alone lack the other.
std::optional<std::vector<LoadedFunction>> load(const Library& library, const Driver& driver,
                                                const DriverInput& input) {
  const std::size_t scalars = scalars_of(driver, input).size();
  std::vector<LoadedFunction> functions;
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    const Function& function = input.program.functions[i];
    if (!is_wrapped(driver, function)) continue;
    const LoadedFunction loaded{function.name, entry_count(function),
                                library.find<DriverFunction<double>>(driver_symbol("double", i)),
                                library.find<DriverFunction<float>>(driver_symbol("float", i))};
    const std::size_t found =
        (loaded.in_double != nullptr ? 1U : 0U) + (loaded.in_float != nullptr ? 1U : 0U);
    if (found != scalars) return std::nullopt;
    functions.push_back(loaded);
  }
  return functions;
}

/// One driver, compiled and loaded.
Result<CompiledHeader> compile_one(const Driver& driver, Build build, const Workshop& workshop,
                                   const DriverInput& input) {
  Result<Library> library = workshop.build(driver, build);
  if (!library) return library.diagnostics;
  std::optional<std::vector<LoadedFunction>> functions = load(*library, driver, input);
  if (!functions) return missing_function();
  return CompiledHeader{driver.types, driver.in_packs,
                        std::make_unique<LoadedModel>(std::move(*library), std::move(*functions))};
}

}  // namespace

Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model, const Scene& scene,
                                const Program& program, const CompileOptions& options) {
  const DriverInput input{model, scene, program};
  const std::vector<Driver> sources = drivers(input);
  const NoInterrupts until_removed;
  const Result<Workshop> workshop = Workshop::open(files, sources, options.limits);
  if (!workshop) return workshop.diagnostics;
  CompiledHeaders headers;
  for (const Driver& driver : sources) {
    if (options.build == Build::as_users && !driver.types.empty()) continue;
    Result<CompiledHeader> header = compile_one(driver, options.build, *workshop, input);
    if (!header) return header.diagnostics;
    headers.push_back(std::move(*header));
  }
  return headers;
}

}  // namespace elgen
