// Toolchain: compiles every emitted header with the user's compiler and loads its functions.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/emitted_files.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/limits.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The signature of every compiled function: all leaves, then the result. Arguments a function does
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

/// How headers are compiled.
enum class Build : std::uint8_t {
  as_written,  ///< strict flags, no contraction: the bits of the arithmetic that is written
  native,      ///< -O3 -march=native, no contraction: the same bits
  as_users,  ///< -O3 -march=native, contraction on: of Eigen nothing, of batches sines and cosines
  to_time,   ///< -O2 -march=native, contraction on
};

/// A number that a header declares beside its functions.
struct DeclaredNumber {
  std::string name = {};  ///< "l[1] (double)", "the place of l[1] (double)", "input_limits[0].low"
  double declared = 0;    ///< as compiled
  double of_model = 0;    ///< rounded to the scalar
};

/// The function by which a header in packs gives the sine and the cosine of the angle t.
inline constexpr std::string_view sine_and_cosine = "sine and cosine";

/// One emitted header; on vectors of Eigen and on arrays of states there are others beside it.
struct CompiledHeader {
  std::string types = {};  ///< "Eigen", "batch"; empty for those of the language itself
  bool in_packs = false;   ///< sines and cosines are polynomials; called for one state of several
  std::unique_ptr<CompiledModel> functions = {};
  Build build = Build::as_written;
  std::string lacking = {};                   ///< why there are no functions; else empty
  std::vector<DeclaredNumber> declared = {};  ///< by all headers; with the first one
};
using CompiledHeaders = std::vector<CompiledHeader>;

struct CompileOptions {
  Limits limits = {};
  std::vector<Build> builds = {Build::as_written};
  /// Counts of coordinates, rates, inputs, open values and parameters; the values of the
  /// parameters, and where they stand in their struct; in C++ ranges and limits too, and of batches
  /// the numbers of their sines and cosines.
  bool declarations = false;
};

/// All headers, in each build in turn, the first of them in the language's own types; one run of
/// the compiler for each build, or for each header where the program is long. $CXX where it is set,
/// else c++, g++, clang++, whichever is there. Headers of a build whose flags the compiler does not
/// take, and those on Eigen where it is not installed, lack their functions. E704 without a
/// compiler, E706 without room for its files, E909 where it takes longer than `limits.seconds` by
/// the clock; with the compiler's words, E705 where it refuses what was emitted, E709 where it
/// cannot work.
[[nodiscard]] Result<CompiledHeaders> compile(const EmittedFiles& files, const Model& model,
                                              const Scene& scene, const Program& program,
                                              const CompileOptions& options);

/// The compiler, library and processor that compiled functions are made and timed by.
struct Machine {
  std::string compiler = {};   ///< "g++ (Debian 12.2.0-14) 12.2.0"
  std::string processor = {};  ///< "AMD EPYC 7B13"
  std::string c_library = {};  ///< "glibc 2.36"
};

/// This one. E704 and E909 as of compile.
[[nodiscard]] Result<Machine> this_machine(const Limits& limits);

}  // namespace elgen
