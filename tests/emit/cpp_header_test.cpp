// cpp_header: which parts a header has; the golden header shows them whole.
#include <algorithm>

#include "emit/cpp/cpp_artifacts.hpp"
#include "fixture.hpp"
#include "support/shell.hpp"

using namespace elgen;
using elgen::test::mentions;
using elgen::testing::cart_pole;
using elgen::testing::Subject;

namespace {

std::string cpp_text(const Subject& subject) {
  return cpp_header(emission_input(subject.model, subject.scene, subject.program));
}

}  // namespace

TEST_CASE("helpers stand only where they are used") {
  Subject subject = cart_pole();
  const std::string with_pivots = cpp_text(subject);
  CHECK(mentions(with_pivots, "bool is_regular("));
  CHECK(mentions(with_pivots, "Scalar number_1_3()"));
  CHECK_FALSE(mentions(with_pivots, "sign_of"));
  CHECK_FALSE(mentions(with_pivots, "filled"));
  subject.program = elgen::testing::read_program(
      "coordinates x theta\nfunction applied_force\n  0 = velocity x\n  1 = sign 0\n"
      "  result 2 1 = 1 1\n");
  const std::string with_kinks = cpp_text(subject);
  CHECK(mentions(with_kinks, "Scalar sign_of(const Scalar& x)"));
  CHECK_FALSE(mentions(with_kinks, "is_regular"));
  CHECK_FALSE(mentions(with_kinks, "number_"));
}

TEST_CASE("a constant is one function however often it occurs") {
  Subject subject = cart_pole();
  elgen::testing::load_constant(subject, rational_constant(cln::cl_RA(1) / 3));
  elgen::testing::load_constant(subject, rational_constant(cln::cl_RA(1) / 3));
  const std::string text = cpp_text(subject);
  const std::string name = "number_1_3() noexcept";
  CHECK(text.find(name) == text.rfind(name));
}

TEST_CASE("no line is longer than 100 columns, none ends with a space, no blank line is doubled") {
  const std::string text = cpp_text(cart_pole());
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const std::string line = text.substr(begin, end - begin);
    INFO(line);
    CHECK(line.size() <= 100);
    CHECK((line.empty() || line.back() != ' '));
    begin = end + 1;
  }
  CHECK_FALSE(mentions(text, "\n\n\n"));
}
