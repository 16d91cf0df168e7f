// Two programs over the leaves of both.
#include "diff/joint_program.hpp"

#include <catch2/catch.hpp>

#include "diff/versions.hpp"
#include "evaluate/subject.hpp"
#include "lower/graph/prune.hpp"
#include "lower/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const Program before = elgen::testing::read_program(
    "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
    "  2 = multiply 0 1\n  result 1 1 = 2\n");
const Program after = elgen::testing::read_program(
    "parameters k m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
    "  2 = multiply 0 1\n  3 = parameter k\n  4 = add 2 3\n  result 1 1 = 4\n");

}  // namespace

TEST_CASE("leaves meet by their names, and what is computed alike is one instruction") {
  JointProgram joint(before, after, {});
  CHECK(joint.program().leaves.parameters == std::vector<std::string>{"k", "m"});
  const JointFunction both = joint.joined(before.functions[0], after.functions[0]);
  CHECK(both.function.instructions.size() == 5);
  CHECK(both.function.instructions[both.after[0]].a == both.before[0]);
}

TEST_CASE("leaves that only the older version has come last") {
  const JointProgram joint(after, before, {});
  CHECK(joint.program().leaves.parameters == std::vector<std::string>{"m", "k"});
}

TEST_CASE("a renamed leaf is the same leaf") {
  Program other = before;
  other.leaves.parameters = {"mass"};
  JointProgram joint(before, other, {{"m", "mass"}});
  const JointFunction both = joint.joined(before.functions[0], other.functions[0]);
  CHECK(both.before == both.after);
  JointProgram apart(before, other, {});
  const JointFunction two = apart.joined(before.functions[0], other.functions[0]);
  CHECK(two.before != two.after);
}

TEST_CASE("parameters of the newer version may have values") {
  JointProgram joint(before, after, {});
  const JointFunction both =
      joint.joined(before.functions[0], after.functions[0], {{"k", rational_constant(5)}});
  const Function function = with_entries(both.function, {both.before[0], both.after[0]});
  Arguments<double> at;
  at.parameters = {100, 2};
  at.q = {3};
  CHECK(evaluate(joint.program(), function, at) == std::vector<double>{6, 11});
}
