// compile_screening: the screening driver of the C++ header, compiled and loaded.
#include <utility>

#include "base/no_interrupts.hpp"
#include "elgen/toolchain.hpp"
#include "toolchain/screen_driver.hpp"
#include "toolchain/workshop.hpp"

namespace elgen {
namespace {

template <class Scalar>
void call(ScreenFunction<Scalar> function, const Arguments<Scalar>& state, double* figures) {
  function(
#define ELGEN_LEAVES(kind, member, ...) state.member.data(),
#define ELGEN_LEAF(kind, member, ...) state.member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
      figures);
}

class LoadedScreening final : public ScreeningCode {
 public:
  explicit LoadedScreening(Library library)
      : library_(std::move(library)),
        in_double_(library_.find<ScreenFunction<double>>(screen_symbol("double"))),
        in_float_(library_.find<ScreenFunction<float>>(screen_symbol("float"))) {}

  [[nodiscard]] bool is_complete() const { return in_double_ != nullptr; }

  void judge(const Arguments<double>& state, double* figures) const override {
    call(in_double_, state, figures);
  }
  void judge(const Arguments<float>& state, double* figures) const override {
    call(in_float_, state, figures);
  }

 private:
  Library library_;
  ScreenFunction<double> in_double_;
  ScreenFunction<float> in_float_;  ///< null where the numbers do not fit it
};

}  // namespace

Result<std::unique_ptr<ScreeningCode>> compile_screening(const EmittedFiles& files,
                                                         const Model& model, const Scene& scene,
                                                         const Program& program,
                                                         const Limits& limits) {
  const Driver driver = screen_driver({model, scene, program});
  const NoInterrupts until_removed;
  const Result<Workshop> workshop = Workshop::open(files, {driver}, limits);
  if (!workshop) return workshop.diagnostics;
  Result<Library> library = workshop->build(driver, Build::as_written);
  if (!library) return library.diagnostics;
  auto code = std::make_unique<LoadedScreening>(std::move(*library));
  if (!code->is_complete()) return missing_function();
  return Result<std::unique_ptr<ScreeningCode>>(std::move(code));
}

}  // namespace elgen
