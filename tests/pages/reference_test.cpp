// models/REFERENCE.md is the key table in Markdown. ELGEN_UPDATE=1 writes it, as the CMake target
// `reference` does, for review of the difference.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "elgen/syntax.hpp"
#include "pages/page.hpp"
#include "support/shell.hpp"

namespace elgen::test {

TEST_CASE("the reference of entries and keys is current") {
  const std::filesystem::path path = source / "models/REFERENCE.md";
  if (std::getenv("ELGEN_UPDATE") != nullptr) write_text(path, reference_page());
  CHECK(read_text(path) == reference_page());
}

}  // namespace elgen::test
