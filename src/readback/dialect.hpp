// dialect: how the files of one language write what all of them say, and what they say it of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"
#include "lower/code_interface.hpp"

namespace elgen {

/// The shapes of file that there are.
enum class Shape : std::uint8_t { cpp, eigen, c99 };

struct CodeDialect {
  Shape shape = Shape::cpp;
  std::string scalar = {};  ///< "Scalar", "double"
  std::string member = {};  ///< "." or "->"
  std::string open = {};    ///< of the index of a result: "[" or "("
  std::string close = {};
  std::string prefix = {};                     ///< of the names of C functions
  std::optional<ScalarKind> scalar_kind = {};  ///< of C; other code is for any scalar
};

[[nodiscard]] CodeDialect dialect_of(Shape shape, const Scene& scene);

/// What a file is about.
struct Origin {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

}  // namespace elgen
