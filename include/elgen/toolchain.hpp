// Toolchain: compiles every emitted header with the user's compiler and loads its functions.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elgen/emitted_files.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The functions of one emitted header, instantiated for one built-in scalar.
class CompiledModel {
 public:
  virtual ~CompiledModel() = default;
  /// All entries of all fields of an output, in the order of Function::fields.
  [[nodiscard]] virtual std::vector<double> call(std::string_view function,
                                                 const Arguments<double>& arguments) const = 0;
  [[nodiscard]] virtual std::vector<float> call(std::string_view function,
                                                const Arguments<float>& arguments) const = 0;
  /// Whether the code is there for double, for float.
  [[nodiscard]] virtual bool has(ScalarKind scalar) const = 0;
};

/// One emitted header; on vectors of Eigen there is a second one.
struct CompiledHeader {
  std::string types = {};  ///< "Eigen"; empty for those of the language itself
  std::unique_ptr<CompiledModel> functions = {};
};
using CompiledHeaders = std::vector<CompiledHeader>;

/// $CXX, else c++, g++, clang++, whichever is there. Strict flags (-ffp-contract=off). E7xx without
/// a compiler (exit 4), with the compiler's words where it refuses.
[[nodiscard]] Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program);

}  // namespace elgen
