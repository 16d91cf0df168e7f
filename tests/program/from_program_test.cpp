// Conversion of instructions back to sums and products.
#include <catch2/catch.hpp>

#include "program/graph/rebuild.hpp"
#include "program/network/linearise.hpp"
#include "program/network/network.hpp"
#include "program/read_program.hpp"
#include "support/text.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const char* const text =
    "parameters m l\ncoordinates x\nfunction gravity\n"
    "  0 = parameter m\n  1 = parameter l\n  2 = coordinate x\n  3 = sin 2\n  4 = multiply 0 3\n"
    "  5 = negate 4\n  6 = divide 5 1\n  7 = subtract 6 0\n  result 2 1 = 7 3\n";

Program program() { return read_program(text); }

/// The text of the program after the instructions `wanted` became a graph and a function again.
std::string lowered_again(const std::vector<std::uint32_t>& wanted,
                          const std::vector<bool>& zeros = {}) {
  Program result = program();
  const Function function = result.functions[0];
  const Expressions expressions = expressions_from_program(result, function, wanted, zeros);
  Function renewed{.kind = function.kind, .user = function.user, .name = function.name};
  Field field{"", static_cast<std::uint32_t>(wanted.size()), 1, {}};
  for (std::uint32_t i = 0; i < wanted.size(); ++i) field.entries.push_back(i);
  renewed.fields = {field};
  linearise(make_network(expressions), result, renewed);
  result.functions = {renewed};
  return dump(result);
}

}  // namespace

TEST_CASE("wanted values are lowered to the same instructions") {
  CHECK(mentions(lowered_again({3}), "  0 = coordinate x\n  1 = sin 0\n"));
  const std::string whole = lowered_again({7, 3});
  CHECK(mentions(whole, "divide"));
  CHECK(mentions(whole, "negate"));
}

TEST_CASE("instructions known to be zero are removed from their users") {
  std::vector<bool> zeros(8, false);
  zeros[3] = true;
  const std::string left = lowered_again({7, 3}, zeros);
  CHECK_FALSE(mentions(left, "sin"));
  CHECK_FALSE(mentions(left, "divide"));
  CHECK(mentions(left, "negate"));  // -m remains
}
