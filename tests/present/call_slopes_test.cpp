// call_slopes: derivatives in closed form, as texts.
#include "present/call_slopes.hpp"

#include <catch2/catch.hpp>

#include "drop/term_text.hpp"

using namespace elgen;

namespace {

/// The slopes of a function of x, or of x and y.
std::vector<std::string> slopes_of(FunctionId function) {
  Algebra algebra;
  Arithmetic arithmetic(algebra);
  const Value x = arithmetic.leaf(Opcode::coordinate, 0);
  const Value call = arithmetic.call(function, x, arithmetic.leaf(Opcode::coordinate, 1));
  REQUIRE(call);
  const Atom atom = algebra.atoms[call->numerator.begin()->first.at(0).atom];
  std::vector<std::string> texts;
  for (const Value& slope : call_slopes(arithmetic, atom, *call)) {
    texts.push_back(slope ? term_text(algebra, {{{}, {"x", "y"}, {}, {}, {}, "t"}, false}, *slope)
                          : "none");
  }
  return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("slopes are those of the table of functions") {
  CHECK(slopes_of(FunctionId::tanh) == Texts{"1 - tanh(x)^2"});
  CHECK(slopes_of(FunctionId::exp) == Texts{"exp(x)"});
  CHECK(slopes_of(FunctionId::log) == Texts{"1/x"});
  CHECK(slopes_of(FunctionId::sinh) == Texts{"cosh(x)"});
  CHECK(slopes_of(FunctionId::atan) == Texts{"(1)/(1 + x^2)"});
  CHECK(slopes_of(FunctionId::atan2) == Texts{"(y)/(x^2 + y^2)", "(-x)/(x^2 + y^2)"});
}

TEST_CASE("functions with kinks have none") {
  CHECK(slopes_of(FunctionId::abs) == Texts{"none"});
  CHECK(slopes_of(FunctionId::max) == Texts{"none", "none"});
}
