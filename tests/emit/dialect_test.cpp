// dialect: what C and C++ write alike, but for how members are reached.
#include "emit/c99/c99_dialect.hpp"
#include "emit/cpp/cpp_dialect.hpp"
#include "fixture.hpp"

using namespace elgen;
using elgen::testing::cart_pole;

TEST_CASE("members of parameters and of the workspace") {
  const auto subject = cart_pole();
  const std::string name = subject.program.leaves.parameters.front();
  const auto cpp = cpp_dialect(subject.model, subject.program);
  const auto c99 = c99_dialect(subject.model, subject.scene, subject.program);
  CHECK(cpp->leaf(Opcode::parameter, 0) == "p." + name);
  CHECK(c99->leaf(Opcode::parameter, 0) == "p->" + name);
  CHECK(cpp->shared("sin_theta") == "w.sin_theta");
  CHECK(c99->shared("sin_theta") == "w->sin_theta");
}

TEST_CASE("calls of the library and of the header") {
  const auto subject = cart_pole();
  const auto cpp = cpp_dialect(subject.model, subject.program);
  const auto c99 = c99_dialect(subject.model, subject.scene, subject.program);
  CHECK(cpp->call(FunctionId::max, {{"x"}, {"y"}}).text() == "detail::larger<Scalar>(x, y)");
  CHECK(c99->call(FunctionId::max, {{"x"}, {"y"}}).text() == "cart_pole_larger(x, y)");
  CHECK(cpp->call(FunctionId::abs, {{"x"}}).text() == "abs(x)");
  CHECK(c99->call(FunctionId::abs, {{"x"}}).text() == "fabs(x)");
}
