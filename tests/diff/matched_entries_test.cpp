// Joint programs over the leaves of two versions, and entries matched by the names of their rows
// and columns.
#include <algorithm>
#include <catch2/catch.hpp>

#include "diff/joint_program.hpp"
#include "diff/versions.hpp"
#include "elgen/oracle.hpp"
#include "program/evaluate/subject.hpp"
#include "program/read_program.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string plane = model_text("plane", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[energy]
T = "dot(x)^2 + dot(x)*dot(y) + 2*dot(y)^2"
)toml");
/// The model `given` with x and y exchanged.
std::string exchanged(const std::string& given = plane) {
  std::string text = replaced(given, "name = \"x\"", "name = \"z\"");
  text = replaced(text, "name = \"y\"", "name = \"x\"");
  return replaced(text, "name = \"z\"", "name = \"y\"");
}

std::vector<MatchedEntry> matched(const LoweredVersion& old, const LoweredVersion& now,
                                  OutputKind kind, const Renames& renames = {}) {
  return match_entries(old.products.checked->model, *find_function(*old.products.lowered, kind),
                       now.products.checked->model, *find_function(*now.products.lowered, kind),
                       renames);
}

/// A model with `constraints`. If `is_reversed`, the entries of each kind are in reverse order.
std::string plate(const std::vector<std::string>& constraints, bool is_reversed) {
  const auto listed = [is_reversed](std::vector<std::string> entries) {
    if (is_reversed) std::ranges::reverse(entries);
    std::string text;
    for (const std::string& entry : entries) text += entry;
    return text;
  };
  const std::string coordinates =
      listed({"[[coordinate]]\nname = \"x\"\nstart = { value = 0.3, rate = 0.2 }\n",
              "[[coordinate]]\nname = \"y\"\nstart = { value = 0.7, rate = 0.5 }\n",
              "[[coordinate]]\nname = \"z\"\nstart = { value = 1.1, rate = 0.9 }\n"});
  const std::string inputs = listed({"[[input]]\nname = \"u\"\non = \"x\"\n",  //
                                     "[[input]]\nname = \"w\"\non = \"y\"\n"});
  const std::string points =
      listed({"[[point]]\nname = \"a\"\nat = [\"x\", \"z\"]\nmass = 2\n",
              "[[point]]\nname = \"b\"\nat = [\"y^2\", \"x*y\"]\nmass = 3\n"});
  return model_text("plate", coordinates + inputs + points + listed(constraints) +
                                 "[energy]\nV = \"x + 2*y*z\"\n[[output]]\nname = \"tip\"\n"
                                 "value = [\"x*z\", \"y\"]\njacobian = true\n");
}

/// Checks that every entry of the newer version equals its match.
void check_values_meet(const std::string& scene, const std::vector<std::string>& constraints) {
  const LoweredVersion old = lowered(plate(constraints, false), scene);
  const LoweredVersion now = lowered(plate(constraints, true), scene);
  const auto values_of = [](const LoweredVersion& version, const OutputRequest& output) {
    const CheckedModel& checked = *version.products.checked;
    return oracle_values(checked.model, output, start_state(checked.model, checked.scene)).value();
  };
  for (const OutputRequest& output : now.products.checked->scene.outputs) {
    INFO(output.name);
    const OutputRequest* const before = find_request(old.products.checked->scene, output.name);
    REQUIRE(before != nullptr);
    const auto olds = values_of(old, *before);
    const auto news = values_of(now, output);
    const std::vector<MatchedEntry> entries = matched(old, now, output.kind);
    CHECK(entries.size() == news.size());
    for (const MatchedEntry& entry : entries) {
      INFO(entry.place);
      REQUIRE((entry.before && entry.after));
      CHECK(cln::abs(olds[*entry.before] - news[*entry.after]) < cln::expt(cln::cl_RA(10), -40));
    }
  }
}

const Program older = read_program(
    "parameters m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
    "  2 = multiply 0 1\n  result 1 1 = 2\n");
const Program newer = read_program(
    "parameters k m\ncoordinates x\nfunction gravity\n  0 = parameter m\n  1 = coordinate x\n"
    "  2 = multiply 0 1\n  3 = parameter k\n  4 = add 2 3\n  result 1 1 = 4\n");

}  // namespace

TEST_CASE("rows and columns of M follow their coordinates") {
  const auto entries = matched(lowered(plane), lowered(exchanged()), OutputKind::mass_matrix);
  REQUIRE(entries.size() == 4);
  CHECK(entries[0].place == "mass_matrix[1,1]");
  CHECK(entries[0].before == 3U);
  CHECK(entries[1].before == 2U);
}

TEST_CASE("entries of a new coordinate have no match") {
  const std::string more = replaced(plane, "[energy]", "[[coordinate]]\nname = \"z\"\n[energy]");
  const std::string space = replaced(more, "2*dot(y)^2", "2*dot(y)^2 + dot(z)^2");
  const auto entries = matched(lowered(plane), lowered(space), OutputKind::gravity);
  REQUIRE(entries.size() == 3);
  CHECK(entries[1].before == 1U);
  CHECK_FALSE(entries[2].before);
  const auto back = matched(lowered(space), lowered(plane), OutputKind::gravity);
  REQUIRE(back.size() == 3);
  CHECK_FALSE(back[2].after);
  CHECK(back[2].place == "gravity[3]");
}

TEST_CASE("renamed coordinates keep their position") {
  const auto entries = matched(lowered(plane), lowered(exchanged()), OutputKind::mass_matrix,
                               {{"x", "y"}, {"y", "x"}});
  CHECK(entries[0].before == 0U);
}

TEST_CASE("pivots are compared only if the order of coordinates is the same") {
  CHECK(matched(lowered(plane), lowered(plane), OutputKind::forward_dynamics).size() == 6);
  CHECK(matched(lowered(plane), lowered(exchanged()), OutputKind::forward_dynamics).size() == 4);
}

TEST_CASE("multipliers are compared even if pivots are not") {
  const std::string held = plane + "[[constraint]]\nname = \"line\"\nequation = \"x + 2*y = 1\"\n";
  const auto alike = matched(lowered(held), lowered(held), OutputKind::forward_dynamics);
  const auto others =
      matched(lowered(held), lowered(exchanged(held)), OutputKind::forward_dynamics);
  // Two accelerations, three pivots, a multiplier, and the three entries of the field `diagonal`.
  CHECK(alike.size() == 9);
  REQUIRE(others.size() == 6);
  CHECK(others[2].before == 5U);
  CHECK(others[2].after == 5U);
}

TEST_CASE("rows of A, residuals and multipliers follow their constraints") {
  const LoweredVersion old = lowered(held_plane(held_rod + held_slot));
  const LoweredVersion now = lowered(held_plane(held_slot + held_rod));
  const auto slopes = matched(old, now, OutputKind::constraint_jacobian);
  REQUIRE(slopes.size() == 6);
  CHECK(slopes[0].before == 3U);
  CHECK(slopes[5].before == 2U);
  const auto residuals = matched(old, now, OutputKind::constraint_residual);
  REQUIRE(residuals.size() == 4);
  CHECK(residuals[0].before == 1U);
  CHECK(residuals[3].before == 2U);
  const auto entries = matched(old, now, OutputKind::forward_dynamics);
  const auto tension =
      std::ranges::find(entries, "forward_dynamics.multipliers[2]", &MatchedEntry::place);
  REQUIRE(tension != entries.end());
  REQUIRE(tension->before);
  CHECK(*tension->before + 1 == *tension->after);
}

TEST_CASE("entries are matched by the names of rows and columns, in any order of declaration") {
  check_values_meet(
      "[outputs]\nmass_matrix = true\ninput_matrix = true\nmomentum = true\nregressor = true\n"
      "regressor_parameters = true\nconstraint_jacobian = true\nconstraint_residual = true\n"
      "linearization = true\ntip = true\ntip_jacobian = true\ntip_bias = true\n",
      {"[[constraint]]\nname = \"line\"\nequation = \"x + 2*y + z = 2.8\"\n",
       "[[constraint]]\nname = \"bend\"\nequation = \"x*y + z = 1.31\"\n"});
  check_values_meet(
      "[outputs]\nreaction = true\nmass_matrix = true\n[lock]\n"
      "x = { value = 0.3, reaction = true }\ny = { value = 0.7, reaction = true }\n",
      {});
}

TEST_CASE("entries of an output that only one version has are unmatched") {
  const LoweredVersion one = lowered(plane);
  const Model& model = one.products.checked->model;
  const Function& gravity = *find_function(*one.products.lowered, OutputKind::gravity);
  const auto entries = match_entries(model, {}, model, gravity, {});
  REQUIRE(entries.size() == 2);
  CHECK(entries[1].after == 1U);
  CHECK_FALSE(entries[1].before);
}

TEST_CASE("leaves are matched by name, and equal computations are one instruction") {
  JointProgram joint(older, newer, {});
  CHECK(joint.program().leaves.parameters == std::vector<std::string>{"k", "m"});
  const JointFunction both = joint.join(older.functions[0], newer.functions[0]);
  CHECK(both.function.instructions.size() == 5);
  CHECK(both.function.instructions[both.after[0]].a == both.before[0]);
}

TEST_CASE("leaves of only the older version come last") {
  const JointProgram joint(newer, older, {});
  CHECK(joint.program().leaves.parameters == std::vector<std::string>{"m", "k"});
}

TEST_CASE("a renamed leaf is one leaf") {
  Program other = older;
  other.leaves.parameters = {"mass"};
  JointProgram joint(older, other, {{"m", "mass"}});
  const JointFunction both = joint.join(older.functions[0], other.functions[0]);
  CHECK(both.before == both.after);
  JointProgram apart(older, other, {});
  const JointFunction two = apart.join(older.functions[0], other.functions[0]);
  CHECK(two.before != two.after);
}

TEST_CASE("parameters of the newer version may be replaced by values") {
  JointProgram joint(older, newer, {});
  const JointFunction both =
      joint.join(older.functions[0], newer.functions[0], {.after = {{"k", rational_constant(5)}}});
  const Function function = with_entries(both.function, {both.before[0], both.after[0]});
  Arguments<double> at;
  at.parameters = {100, 2};
  at.q = {3};
  CHECK(evaluate(joint.program(), function, at) == std::vector<double>{6, 11});
}
