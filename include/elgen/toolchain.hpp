// Toolchain: compiles every emitted header with the user's compiler and loads its functions.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elgen/emitted_files.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/limits.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// What every compiled function looks like: all leaves, then the result. Arguments a function does
/// not take are ignored.
template <class Scalar>
using DriverFunction = void (*)(
#define ELGEN_LEAVES(kind, member, ...) const Scalar *member,
#define ELGEN_LEAF(kind, member, ...) Scalar member,
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
    Scalar* result);

/// The functions of one emitted header, instantiated for one built-in scalar.
class CompiledModel {
 public:
  virtual ~CompiledModel() = default;
  /// The function itself, while the CompiledModel lives; null where it is not there for double. Its
  /// result has the entries of all fields, in the order of Function::fields.
  [[nodiscard]] virtual DriverFunction<double> find(std::string_view function) const = 0;
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

/// How headers are compiled.
enum class Build : std::uint8_t {
  as_written,  ///< strict flags, no contraction: the bits of the arithmetic that is written
  as_users,    ///< -O3 -march=native, contraction on; without the header on types of Eigen
};

/// $CXX where it is set, else c++, g++, clang++, whichever is there. E704 without a compiler, E706
/// without room for its files, E909 where it takes longer than `limits.seconds` by the clock; with
/// the compiler's words, E705 where it refuses what was emitted, E709 where it cannot work.
[[nodiscard]] Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program,
                                              const Limits& limits,
                                              Build build = Build::as_written);

}  // namespace elgen
