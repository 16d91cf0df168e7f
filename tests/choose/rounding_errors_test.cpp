// Ways to write one value, and which of them may stand for which.
#include "choose/rounding_errors.hpp"

#include <catch2/catch.hpp>

#include "choose/chosen.hpp"
#include "lower/expression_leaves.hpp"
#include "lower/graph/from_program.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::vector<std::string> names{"a", "b", "c", "d", "e"};
const LeafNames leaves{{{}, names, names, names, {}, "t"}, false};

/// Graphs of their own: the two ways are not joined into one, as those of a model text would be.
bool is_precise(const char* way, const char* reference, Leaves kind) {
  return is_as_precise(testing::expressions_of({way}), testing::expressions_of({reference}),
                       mixed_points(leaves), kind);
}

/// Functions of which a closed form is emitted that is less precise than the one that judges it.
std::vector<std::string> imprecise(const std::string& text) {
  const Program program = chosen(text).choice.program;
  const MixedPoints points = mixed_points(program.leaves);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < program.functions.size(); ++i) {
    const Function& function = program.functions[i];
    const Function& readable = program.readable[i];
    if (function.form != Form::closed || readable.fields.empty()) continue;
    const std::vector<std::uint32_t> entries = entries_of(readable);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const Expressions emitted = from_program(program, function, {entries_of(function)[e]});
      const Expressions judge = from_program(program, readable, {entries[e]});
      // B counts the rounding of what sums of angles are made of: either is no more than it says.
      const bool is_precise = is_as_precise(emitted, judge, points, Leaves::exact) ||
                              is_as_precise(emitted, judge, points, Leaves::rounded);
      if (!is_precise) result.push_back(function.name + " " + std::to_string(e));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("terms that cancel are seen, other countings of the same roundings are admitted") {
  const char* const plain = "b + a*d";
  const char* const cancelling = "b + 2*a*(c + 1/2*d) - 2*a*c";
  CHECK_FALSE(is_precise(cancelling, plain, Leaves::exact));
  CHECK_FALSE(is_precise(cancelling, plain, Leaves::rounded));
  CHECK(is_precise(plain, cancelling, Leaves::exact));
  const char* const square = "(a - sqrt(c^2 + d^2))^2";
  const char* const multiplied_out = "a^2 + c^2 + d^2 - 2*a*sqrt(c^2 + d^2)";
  CHECK(is_precise(square, multiplied_out, Leaves::exact));
  CHECK(is_precise(square, multiplied_out, Leaves::rounded));
  CHECK(is_precise("sin(2*c)", "2*sin(c)*cos(c)", Leaves::exact));
  CHECK(is_precise("2*sin(c)*cos(c)", "sin(2*c)", Leaves::exact));
}

TEST_CASE("a sum of angles has as many digits as its angles, and no more") {
  const char* const shifted = "cos(c + 1)";
  const char* const apart = "cos(c)*cos(1) - sin(c)*sin(1)";
  CHECK_FALSE(is_precise(shifted, apart, Leaves::exact));
  CHECK(is_precise(shifted, apart, Leaves::rounded));
}

TEST_CASE("a difference of angles is rounded where the angles themselves are not") {
  const char* const whole = "a + cos(c - d)";
  const char* const apart = "a + cos(c)*cos(d) + sin(c)*sin(d)";
  CHECK_FALSE(is_precise(whole, apart, Leaves::exact));
  CHECK(is_precise(whole, apart, Leaves::rounded));
  CHECK(is_precise(whole, whole, Leaves::exact));
}

TEST_CASE("nothing is admitted where nothing has a value") {
  CHECK_FALSE(is_precise("sqrt(-(1 + c^2))", "sqrt(-(1 + c^2))", Leaves::exact));
}

TEST_CASE("the code of a closed form is as precise as what judges it") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    CHECK(imprecise(text) == std::vector<std::string>());
  }
  // The shortest way to write its second velocity force is as it was derived, where c cos(y) x' y'
  // cancels: elsewhere the constant angle 1 + sqrt(2) is joined with y.
  CHECK(imprecise(model_text("phase", R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
p = 1
[energy]
T = "(-cos(sqrt(2) + 1))/2*(dot(x) + sin(y)*dot(y))^2 + 3/2*dot(x)^2 + (p + cos(x - y)^2)/2*dot(y)^2"
)toml"))
            .empty());
}
