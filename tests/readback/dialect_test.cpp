// What functions read, and how their entries are stored.
#include "readback/dialect.hpp"

#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {
namespace {

Origin origin() {
  return {test::cpp().checked.model, test::cpp().checked.scene, test::cpp().program};
}

}  // namespace

TEST_CASE("parameters are those that functions read") {
  CHECK(read_parameters(origin()).size() == 6);
  const Program none;
  CHECK(read_parameters({test::cpp().checked.model, test::cpp().checked.scene, none}).empty());
}

TEST_CASE("column-major entries go down the columns") {
  const Field field{"", 2, 3, {1, 2, 3, 4, 5, 6}};
  CHECK(stored_entries(field, Storage::row_major) == field.entries);
  CHECK(stored_entries(field, Storage::column_major) ==
        std::vector<std::uint32_t>{1, 4, 2, 5, 3, 6});
}

TEST_CASE("C names begin with the prefix, and use one scalar") {
  const CodeDialect c = dialect_of(Shape::c99, test::c99().checked.scene);
  CHECK(c.scalar == "float");
  CHECK(c.prefix == "wide_scene_");
  CHECK(c.member == "->");
  CHECK(dialect_of(Shape::eigen, test::eigen().checked.scene).open == "(");
}

}  // namespace elgen
