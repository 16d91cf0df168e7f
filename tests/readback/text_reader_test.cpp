// The page that `show` prints as text is read before it is printed.
#include <catch2/catch.hpp>

#include "systems.hpp"
#include "written.hpp"

namespace elgen {
namespace {

const test::Written& wide() {
  static const test::Written all = test::written(test::wide_text());
  return all;
}

std::string page() { return text_page(wide().checked.model, wide().checked.scene, wide().program); }

/// What is said of the page with one change behind `anchor`.
std::string said(const std::string& anchor, const std::string& from, const std::string& to) {
  std::string text = page();
  const std::size_t at = text.find(from, text.find(anchor));
  REQUIRE(at != std::string::npos);
  const SourcePointer changed = make_source("page", text.replace(at, from.size(), to));
  const Diagnostics found = read_back_page(changed, wide().checked, wide().program);
  REQUIRE(found.size() == 1);
  CHECK(found.front().code == Code::E915);
  return found.front().message;
}

}  // namespace

TEST_CASE("a page of equations is read") {
  CHECK(read_back_page(make_source("page", page()), wide().checked, wide().program).empty());
}

TEST_CASE("a page of text that says something else is refused") {
  CHECK_THAT(said("\nmass_matrix\n", "M + m", "M - m"), Catch::Contains("`M - m`"));
  CHECK_THAT(said("\ngravity\n", "-m*l", "m*l"), Catch::Contains("`gravity`"));
  CHECK_THAT(said("\nmass_matrix\n", "[1,2]", "[2,1]"), Catch::Contains("no definition"));
  CHECK_THAT(said("\nmass_matrix\n", "  mass_matrix[2,2]", "# mass_matrix[2,2]"),
             Catch::Contains("`mass_matrix[2,2]` is missing"));
  CHECK_THAT(said("\ngravity\n", "gravity\n", "weight\n"), Catch::Contains("is missing"));
  CHECK_THAT(said("\nkinetic_energy\n", "\n\n", "\n  more = 1\n\n"),
             Catch::Contains("one line too many"));
}

}  // namespace elgen
