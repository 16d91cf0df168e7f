// The words of each shape of file.
#include "readback/dialect.hpp"

#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {
TEST_CASE("C names begin with the prefix, and use one scalar") {
  const CodeDialect c = dialect_of(Shape::c99, test::c99().checked.scene);
  CHECK(c.scalar == "float");
  CHECK(c.prefix == "wide_scene_");
  CHECK(c.member == "->");
  CHECK(dialect_of(Shape::eigen, test::eigen().checked.scene).open == "(");
}

}  // namespace elgen
