// A page begins with title, equation of motion, variables and notes, and ends with operations.
#include "emit/pages/introduction.hpp"

#include <algorithm>

#include "emit/text/emission_input.hpp"
#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;
using Lines = std::vector<std::string>;

namespace {

bool has_line(const Lines& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

}  // namespace

TEST_CASE("rates are not declared if no function uses them") {
  Subject subject = cart_pole();
  subject.program = read_program(
      "coordinates x theta\nfunction gravity\n  0 = coordinate x\n  result 2 1 = 0 0\n");
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  CHECK(has_line(lines, "   g(q) = B(q) u"));
  CHECK(has_line(lines, "   at rest"));
  CHECK_FALSE(has_line(lines, "   v = dq/dt, a = dv/dt"));
}

TEST_CASE("title, variables and fixed parameters") {
  Subject subject = cart_pole();
  subject.scene.specialisation.fixed[3] = {cln::cl_RA(981) / 100};
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  CHECK(lines.front() == " Cart and pole with a force on the cart");
  CHECK(has_line(lines, "   q = (x [m], theta [rad])"));
  CHECK(has_line(lines, "   v = dq/dt, a = dv/dt"));
  CHECK(has_line(lines, "   u = (u [N])"));
  CHECK(lines.back() == " Fixed: g = 9.81.");
}

TEST_CASE("omitted outputs are listed, if there are any") {
  Subject subject = cart_pole();
  const Lines without = introduction(subject.model, subject.scene, subject.program);
  subject.scene.omitted_outputs = {{OmissionReason::kinked_force, {"linearization"}}};
  const Lines lines = introduction(subject.model, subject.scene, subject.program);
  REQUIRE(lines.size() == without.size() + 2);
  CHECK(lines[without.size()].empty());
  CHECK(lines.back() ==
        " Left out, because forces with abs, sign, min or max have no derivatives: linearization.");
}

TEST_CASE("one row per function, columns aligned") {
  Program program = cart_pole().program;
  program.functions[1].form = Form::closed;
  const Lines table = operation_table(program);
  REQUIRE(table.size() == 1 + program.functions.size());
  CHECK(table[0] == "function             add    mul   div  sqrt sincos other  definitions  form");
  CHECK(table[1] ==
        "mass_matrix            1      4     0     0      1     0            2  recursive");
  CHECK(mentions(table[2], "  closed"));
}

TEST_CASE("the page ends with the operations of every function") {
  const Subject subject = cart_pole();
  const std::string page = markdown_page_text(
      emission_input(subject.model, subject.scene, subject.program, {subject.program}));
  const std::size_t operations = page.find("\n## Operations\n");
  REQUIRE(operations != std::string::npos);
  for (const Function& function : subject.program.functions) {
    CHECK(page.find("\n" + function.name + " ", operations) != std::string::npos);
  }
}

TEST_CASE("the page lists omitted outputs") {
  Subject subject = cart_pole();
  subject.scene.omitted_outputs = {{OmissionReason::too_many_entries, {"linearization"}}};
  const std::string page = markdown_page_text(
      emission_input(subject.model, subject.scene, subject.program, {subject.program}));
  CHECK(mentions(page,
                 "\n\nLeft out, with more than 4096 entries: linearization. To emit one, name it "
                 "in a scene or with --outputs.\n\n"));
}
