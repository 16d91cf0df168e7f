// Tables of a Markdown page that say something else are refused.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::Change;
using test::cpp;
using test::expect_refused;

TEST_CASE("a Markdown page that says something else is refused") {
  const std::string page = ".md";
  for (const Change& change : std::vector<Change>{
           {cpp(), page, "| $M$", "1.1", "1.2", "`1.2` is not 1.1"},
           {cpp(), page, "| $M$", "`M`", "`N`", "that of `M`"},
           {cpp(), page, "| $k_", "0.7, 2", "2, 0.7", "is not 0.7"},
           {cpp(), page, "| $b$", "0.3", "0.3 (fixed)", "fixed"},
           {cpp(), page, "## Operations", "3", "4", "the row should be"},
           {cpp(), page, "## Operations", "closed", "recursive", "the row should be"}}) {
    expect_refused(change);
  }
}

}  // namespace elgen
