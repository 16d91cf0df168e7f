// compile: writes the emitted headers and a driver of each into a temporary directory, has the
// user's compiler make shared objects of them, and loads those. The directory is gone when compile
// returns; the loaded objects stay. Interrupts end the compiler, and then wait for that.
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/no_interrupts.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/compiler.hpp"
#include "toolchain/driver.hpp"
#include "toolchain/temporary_directory.hpp"

namespace elgen {
namespace {

/// A dlopen handle.
class Library {
 public:
  explicit Library(const std::filesystem::path& object)
      : handle_(dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL)) {}
  Library(Library&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Library& operator=(Library&&) = delete;
  ~Library() {
    if (handle_ != nullptr) dlclose(handle_);
  }

  [[nodiscard]] bool loaded() const { return handle_ != nullptr; }

  template <class Scalar>
  [[nodiscard]] DriverFunction<Scalar> find(const std::string& symbol) const {
    return reinterpret_cast<DriverFunction<Scalar>>(dlsym(handle_, symbol.c_str()));
  }

 private:
  void* handle_;
};

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

bool write(const std::filesystem::path& path, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream.good();
}

bool write_all(const std::filesystem::path& directory, const EmittedFiles& files,
               const std::vector<Driver>& drivers) {
  const bool headers = std::all_of(
      files.files.begin(), files.files.end(),
      [&directory](const auto& file) { return write(directory / file.first, file.second); });
  return headers && std::all_of(drivers.begin(), drivers.end(), [&directory](const Driver& driver) {
           return write(directory / driver.file, driver.text);
         });
}

/// Empty where a symbol is missing; functions the driver has for one scalar alone lack the other.
std::vector<LoadedFunction> load(const Library& library, const DriverInput& input) {
  const std::size_t scalars = driver_scalars(input).size();
  std::vector<LoadedFunction> functions;
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    const Function& function = input.program.functions[i];
    const LoadedFunction loaded{function.name, entry_count(function),
                                library.find<double>(driver_symbol("double", i)),
                                library.find<float>(driver_symbol("float", i))};
    const std::size_t found =
        (loaded.in_double != nullptr ? 1U : 0U) + (loaded.in_float != nullptr ? 1U : 0U);
    if (found != scalars) return {};
    functions.push_back(loaded);
  }
  return functions;
}

Diagnostic nowhere(Code code, std::string message) { return {code, {}, std::move(message)}; }

/// What becomes of one driver.
Result<CompiledHeader> compile_one(const Driver& driver, const Compiler& compiler, Build build,
                                   const std::filesystem::path& directory,
                                   const DriverInput& input) {
  const std::filesystem::path object = directory / (driver.file + ".so");
  const ProcessResult compiled = compile_shared(compiler, build, directory / driver.file, object);
  if (!compiled.succeeded()) return why_refused(compiler, compiled, directory, driver);
  Library library(object);
  if (!library.loaded()) {
    return nowhere(Code::E709, fmt::format("what `{}` made could not be loaded: {}",
                                           fmt::join(compiler.command, " "), dlerror()));
  }
  std::vector<LoadedFunction> functions = load(library, input);
  if (functions.size() != input.program.functions.size()) {
    return nowhere(Code::E705, "a compiled function is missing from the loaded object");
  }
  return CompiledHeader{driver.types,
                        std::make_unique<LoadedModel>(std::move(library), std::move(functions))};
}

}  // namespace

Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model, const Scene& scene,
                                const Program& program, const Limits& limits, Build build) {
  const DriverInput input{model, scene, program};
  const std::vector<Driver> sources = drivers(input);
  const NoInterrupts until_removed;
  const std::optional<TemporaryDirectory> directory = TemporaryDirectory::create();
  if (!directory || !write_all(directory->path(), files, sources)) {
    return nowhere(Code::E706, "no temporary directory could be written; $TMPDIR names another");
  }
  const Result<Compiler> compiler = find_compiler(limits.seconds);
  if (!compiler) return compiler.diagnostics;
  CompiledHeaders headers;
  for (const Driver& driver : sources) {
    if (build == Build::as_users && !driver.types.empty()) continue;
    Result<CompiledHeader> header = compile_one(driver, *compiler, build, directory->path(), input);
    if (!header) return header.diagnostics;
    headers.push_back(std::move(*header));
  }
  return headers;
}

}  // namespace elgen
