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
      statements(program.functions.front(), {"", "", "total", "", ""}, Pairing::joint);
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

TEST_CASE("a sine and a cosine of one angle are one statement, where the language has one call") {
  const Program program = elgen::testing::read_program(
      "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = add 0 1\n  3 = sin 2\n  4 = cos 2\n  5 = sin 0\n  result 3 1 = 3 4 5\n");
  const std::vector<std::string> names = {"", "", "sum", "sine", "cosine", "other"};
  const std::vector<Statement> joint = statements(program.functions.front(), names, Pairing::joint);
  REQUIRE(joint.size() == 3 + 3);
  CHECK(joint[1].instruction == 3);
  CHECK(joint[1].cosine == 4);
  CHECK(joint[1].uses == Numbers{2});
  CHECK(joint[1].written.empty());  // the calls are not spelt out
  CHECK_FALSE(joint[2].cosine);
  const std::vector<Statement> separate =
      statements(program.functions.front(), names, Pairing::separate);
  REQUIRE(separate.size() == 4 + 3);
  CHECK(separate[1].written == Numbers{3});
  CHECK_FALSE(separate[1].cosine);
}
