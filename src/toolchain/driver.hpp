// The C interface to an emitted header: one function per model function and scalar, with flat
// arrays.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The model, scene and program that drivers are made from.
struct DriverInput {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

/// A translation unit that includes one emitted header, in the header's language, and wraps each
/// function for each scalar. `parameters` are those of Program::leaves; results follow each other
/// in the order of Function::fields, matrices row by row.
struct Driver {
  std::string types = {};  ///< "Eigen", "batch"; empty for those of the language itself
  std::string file = {};
  std::string text = {};
  std::string needs = {};  ///< "Eigen/Core": a header that is no part of the language
  bool in_packs = false;   ///< sines and cosines are those of PackTrigonometry
};

/// One for every header among the emitted files.
[[nodiscard]] std::vector<Driver> drivers(const DriverInput& input);

/// The scalars a driver wraps functions for: of generic code double, and float where its numbers
/// fit that, else the scene's own.
[[nodiscard]] std::vector<ScalarKind> driver_scalars(const DriverInput& input);

/// Those of this driver: of a header on arrays of states the scene's.
[[nodiscard]] std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input);

/// Whether the header has the function: a batch has none with more than 4096 entries.
[[nodiscard]] bool is_wrapped(const Driver& driver, const Function& function);

/// The driver's name for Program::functions[function]: "elgen_driver_double_3".
[[nodiscard]] std::string driver_symbol(std::string_view scalar, std::size_t function);

// The parts that the drivers of all languages are put together from.

/// "  result.l[1] = values[3];" for every run-time parameter, in the order of the program's leaves.
[[nodiscard]] std::string parameter_assignments(const DriverInput& input);

/// Where the header has entry (i, j) of a result: the driver gives them row by row.
[[nodiscard]] std::string_view stored_position(const Scene& scene);

/// "  append(to, result.gravity.data(), 2, 1);" for each field; `data` gives the address of one.
[[nodiscard]] std::string appended(const DriverInput& input, const Function& function,
                                   std::string_view to, std::string_view data);

/// "const double* parameters, const double* q, …, double t, ": what a driver function declares
/// before its result, each after `attribute`.
[[nodiscard]] std::string declared_leaves(std::string_view scalar, std::string_view attribute = "");

/// `append` and `parameters_from`, which the drivers in C++17 have in common.
[[nodiscard]] std::string cpp_helpers(const DriverInput& input);

/// The drivers of C++17, on arrays of states and in Eigen's types too, and of C99.
[[nodiscard]] std::string cpp_driver(const DriverInput& input);
[[nodiscard]] std::string eigen_driver(const DriverInput& input);
[[nodiscard]] std::string batch_driver(const DriverInput& input);
[[nodiscard]] std::string c99_driver(const DriverInput& input);

}  // namespace elgen
