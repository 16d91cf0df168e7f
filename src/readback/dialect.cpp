// dialect: the words of each shape.
#include "readback/dialect.hpp"

namespace elgen {

CodeDialect dialect_of(Shape shape, const Scene& scene) {
  if (shape != Shape::c99) {
    const bool is_eigen = shape == Shape::eigen;
    return {shape, "Scalar", ".", is_eigen ? "(" : "[", is_eigen ? ")" : "]"};
  }
  const ScalarKind kind = scene.numerics.scalars.front();
  return {shape, std::string(name_of(kind)), "->", "[", "]", name_space(scene) + "_", kind};
}

}  // namespace elgen
