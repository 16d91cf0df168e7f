// Expressions are read by the precedence of C and C++, and with the names that are in scope.
#include <catch2/catch.hpp>

#include "changes.hpp"

namespace elgen {

using test::c99;
using test::Change;
using test::cpp;
using test::expect_refused;

TEST_CASE("another expression is refused") {
  const std::string h = "wide.hpp";
  const std::string mass = "> mass_matrix(";
  for (const Change& change : std::vector<Change>{
           {cpp(), h, mass, "t_679f3 * p.l}}", "t_679f3 * (p.l)) }}", "instead of"},
           {cpp(), h, mass, "p.M + p.m", "p.M + q[0]", "has `q[0]` instead of `m`"},
           {cpp(), h, mass, "p.M + p.m", "p.M + v[0]", "`v` is not declared here"},
           {cpp(), h, mass, "p.M + p.m", "p.M + 1.0", "an operand"},
           {cpp(), h, mass, "p.M + p.m", "p.M + p.none", "`none` is not declared here"},
           {cpp(), h, mass, "p.M + p.m", "p.M + cos(q[1])", "has `cos(q[1])`"},
           {cpp(), h, mass, "p.M + p.m", "p.M + -p.m", "has `-m`"},
           {cpp(), h, mass, "p.M + p.m", "p.M + --p.m", "an operand"},
           {c99(), "wide_scene.h", "_mass_matrix(", "p->M + p->m", "p->M + 1", "no literal"}}) {
    expect_refused(change);
  }
}

TEST_CASE("brackets that change nothing are read") {
  std::string text = test::file_of(cpp(), "wide.hpp")->text;
  const std::string from = "p.M + p.m, t_bff8f";
  text.replace(text.find(from), from.size(), "((p.M) + (p.m)), (t_bff8f)");
  std::vector<SourcePointer> sources;
  CHECK(test::read_changed(cpp(), "wide.hpp", text, sources).empty());
}

}  // namespace elgen
