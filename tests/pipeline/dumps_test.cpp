// The text of what a stage hands on is made of the texts of its parts.
#include "pipeline/dumps.hpp"

#include <catch2/catch.hpp>

namespace elgen {

TEST_CASE("an inspection is what it found") {
  const Inspection inspection{{Diagnostic{Code::E501, {}, "no mass moves"}}};
  CHECK(dump(inspection) == format(inspection.found));
  CHECK(dump(Inspection{}).empty());
}

TEST_CASE("where nothing is solved there are no parts to show") { CHECK(dump(Program{}).empty()); }

}  // namespace elgen
