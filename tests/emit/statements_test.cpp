// statements: what is computed under a name, what is written out, and what either is made of.
#include "emit/code/statements.hpp"

#include "fixture.hpp"

using namespace elgen;

namespace {

using Numbers = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a shared value is one statement, before its uses") {
  const Program program = elgen::testing::read_program(
      "parameters a b\nfunction gravity\n  0 = parameter a\n  1 = parameter b\n"
      "  2 = add 0 1\n  3 = multiply 2 2\n  4 = negate 3\n  result 2 1 = 4 2\n");
  const std::vector<Statement> all =
      statements(program.functions.front(), {"", "", "total", "", ""});
  REQUIRE(all.size() == 3);
  CHECK(all[0].instruction == 2);
  CHECK_FALSE(all[0].is_entry);
  CHECK(all[0].uses.empty());
  CHECK(all[0].written == Numbers{2, 0, 1});
  CHECK(all[1].is_entry);
  CHECK(all[1].uses == Numbers{2});
  CHECK(all[1].written == Numbers{4, 3});
  CHECK(all[2].index == 1);
  CHECK(all[2].uses == Numbers{2});
  CHECK(all[2].written.empty());
}
