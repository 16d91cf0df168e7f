// dialect: what functions read, and how their files write it.
#include "readback/dialect.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "evaluate/scalar_literal.hpp"

namespace elgen {

CodeDialect dialect_of(Shape shape, const Scene& scene) {
  if (shape != Shape::c99) {
    const bool is_eigen = shape == Shape::eigen;
    return {shape, "Scalar", ".", is_eigen ? "(" : "[", is_eigen ? ")" : "]"};
  }
  const ScalarKind kind = scene.numerics.scalars.front();
  return {shape, scalar_name(kind), "->", "[", "]", name_space_of(scene) + "_", kind};
}

const std::string& name_space_of(const Scene& scene) {
  const std::string& name = scene.emission.name_space;
  return name.empty() ? scene.base_name : name;
}

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::vector<ParameterArray> read_parameters(const Origin& origin) {
  const auto& [model, scene, program] = origin;
  std::set<std::string> names;
  for (const Function& function : program.functions) {
    for (const Instruction& i : function.instructions) {
      if (i.opcode == Opcode::parameter) names.insert(program.leaves.parameters[i.a]);
    }
  }
  std::set<std::uint32_t> read;
  for (const Parameter& parameter : model.parameters) {
    if (names.count(parameter.name) > 0) read.insert(parameter.array);
  }
  std::vector<ParameterArray> arrays;
  for (const std::uint32_t array : read) arrays.push_back(model.parameter_arrays[array]);
  return arrays;
}

bool is_struct(const Function& function) {
  return function.fields.size() != 1 || !function.fields.front().name.empty();
}

std::vector<std::uint32_t> stored_entries(const Field& field, Storage storage) {
  if (storage == Storage::row_major) return field.entries;
  std::vector<std::uint32_t> entries;
  for (std::size_t column = 0; column < field.columns; ++column) {
    for (std::size_t row = 0; row < field.rows; ++row) {
      entries.push_back(field.entries[row * field.columns + column]);
    }
  }
  return entries;
}

}  // namespace elgen
