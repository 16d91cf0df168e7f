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

/// What drivers are made from.
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

/// Those of a header on arrays of states: the scene's.
[[nodiscard]] std::vector<ScalarKind> batch_scalars(const Scene& scene);

/// Those of this driver.
[[nodiscard]] std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input);

/// Whether the header has the function: a batch has none with more than 4096 entries.
[[nodiscard]] bool is_wrapped(const Driver& driver, const Function& function);

/// The driver's name for Program::functions[function]: "elgen_driver_double_3".
[[nodiscard]] std::string driver_symbol(std::string_view scalar, std::size_t function);

}  // namespace elgen
