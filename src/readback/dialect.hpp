// dialect: how the files of one language write what all of them say, and what they say it of.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The shapes of file that there are.
enum class Shape : std::uint8_t { cpp, eigen, c99 };

struct CodeDialect {
  Shape shape = Shape::cpp;
  std::string scalar = {};  ///< "Scalar", "double"
  std::string member = {};  ///< "." or "->"
  std::string open = {};    ///< of the index of a result: "[" or "("
  std::string close = {};
  std::string prefix = {};                         ///< of the names of C functions
  ScalarKind kind = ScalarKind::double_precision;  ///< of C
};

[[nodiscard]] CodeDialect dialect_of(Shape shape, const Scene& scene);

/// "cart_pole": the namespace of C++, the start of every name in C.
[[nodiscard]] const std::string& name_space_of(const Scene& scene);

[[nodiscard]] std::string upper_case(std::string text);

/// What a file is about.
struct Origin {
  const Model& model;
  const Scene& scene;
  const Program& program;
};

/// Those that a function of the program reads, in the order of the model.
[[nodiscard]] std::vector<ParameterArray> read_parameters(const Origin& origin);

/// Whether a function gives several named arrays.
[[nodiscard]] bool is_struct(const Function& function);

/// Entries of a field in the order of storage.
[[nodiscard]] std::vector<std::uint32_t> stored_entries(const Field& field, Storage storage);

}  // namespace elgen
