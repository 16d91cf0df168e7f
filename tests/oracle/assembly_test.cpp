// Assembly by Newton's method: known poses, and failures without a pose.
#include <cln/real.h>

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

namespace elgen::test {

namespace {

using cln::cl_R;
using cln::cl_RA;
using Values = std::vector<cl_R>;

/// A point of mass 2 in x and y. Each entry e of `equations` is a position constraint e = 0.
Model constrained_point(const std::vector<std::string>& equations) {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").parameter("l", "1").T("x_d^2 + y_d^2");
  for (const std::string& equation : equations) {
    Constraint constraint;
    constraint.name = equation;
    constraint.value = b.expression(equation);
    b.model.constraints.push_back(constraint);
  }
  return b.model;
}

State state_at(const Model& model, const Values& q, const Values& v) {
  State state = nominal_state(model, {});
  state.q = q;
  state.v = v;
  return state;
}

void check_agree(const Values& found, const Values& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(agree(found[i], expected[i], 55, 1));
}

const char* const rod = "x^2 + y^2 - l^2";

}  // namespace

TEST_CASE("a state that meets the constraints is unchanged") {
  const Model model = constrained_point({rod});
  const State state = state_at(model, {cl_RA(3) / 5, cl_RA(-4) / 5}, {4, 3});
  const auto assembled = oracle_assembled_state(model, state);
  REQUIRE(assembled);
  CHECK(assembled->q == state.q);
  CHECK(assembled->v == state.v);
}

TEST_CASE("a point with equal masses is projected along the rod's normal") {
  const Model model = constrained_point({rod});
  const auto assembled = oracle_assembled_state(model, state_at(model, {3, 4}, {1, 2}));
  REQUIRE(assembled);
  check_agree(assembled->q, {cl_RA(3) / 5, cl_RA(4) / 5});
  check_agree(assembled->v, {cl_RA(-8) / 25, cl_RA(6) / 25});
}

TEST_CASE("fixed coordinates and rates stay, the others follow or there is no pose") {
  const Model model = constrained_point({rod});
  const State state = state_at(model, {cl_RA(3) / 5, -1}, {4, 1});
  const auto at = oracle_assembly(model, state, {{true, false}, {false, true}});
  REQUIRE(at);
  CHECK(at->has_rates);
  check_agree(at->state.q, {cl_RA(3) / 5, cl_RA(-4) / 5});
  check_agree(at->state.v, {cl_RA(4) / 3, 1});
  const auto torn = oracle_assembly(model, state, {{true, true}, {}});
  REQUIRE(torn);
  CHECK_FALSE(torn->has_pose);
  CHECK(torn->state.q == state.q);
}

TEST_CASE("the first step equals the output `projected`") {
  const Model model = constrained_point({"x^2 + y - l"});
  const State state = state_at(model, {0, 3}, {1, 1});
  const auto assembled = oracle_assembled_state(model, state);
  REQUIRE(assembled);
  check_agree(value_of(model, OutputKind::projected, state).value(), {0, 1, 1, 0});
  check_agree(assembled->q, {0, 1});
  check_agree(assembled->v, {1, 0});
}

TEST_CASE("a step that increases the residual or leaves the domain is shortened") {
  // A full Newton step for atan from x = 3 diverges; a full step for log makes x negative.
  const Model bent = constrained_point({"atan(x)"});
  const auto origin = oracle_assembled_state(bent, state_at(bent, {3, 5}, {0, 0}));
  REQUIRE(origin);
  check_agree(origin->q, {0, 5});
  const Model logarithm = constrained_point({"log(x) - 1"});
  const auto base = oracle_assembled_state(logarithm, state_at(logarithm, {9, 0}, {0, 0}));
  REQUIRE(base);
  check_agree(base->q, {cln::exp1(cln::float_format(90)), 0});
}

TEST_CASE("consistent redundant equations are met, contradictory equations are not") {
  const Model twice = constrained_point({rod, "3*l^2 - 3*x^2 - 3*y^2"});
  const auto assembled = oracle_assembled_state(twice, state_at(twice, {3, 4}, {0, 0}));
  REQUIRE(assembled);
  check_agree(assembled->q, {cl_RA(3) / 5, cl_RA(4) / 5});
  const Model never = constrained_point({"x - l", "x - 3*l"});
  const auto ended = oracle_assembly(never, state_at(never, {1, 0}, {0, 0}));
  REQUIRE(ended);
  CHECK_FALSE(ended->has_pose);
  CHECK_FALSE(oracle_assembled_state(never, state_at(never, {1, 0}, {0, 0})));
}

TEST_CASE("a pose may have no consistent rates") {
  const Model torn = constrained_point({"x - l*t", "x - 2*l*t"});
  const auto ended = oracle_assembly(torn, state_at(torn, {0, 0}, {0, 0}));
  REQUIRE(ended);
  CHECK(ended->has_pose);
  CHECK_FALSE(ended->has_rates);
}

TEST_CASE("a constraint gradient of 0 at the start gives no direction") {
  const Model model = constrained_point({rod});
  CHECK_FALSE(oracle_assembled_state(model, state_at(model, {0, 0}, {0, 0})));
}

TEST_CASE("a constraint without a value at the start fails") {
  const Model model = constrained_point({"sqrt(x) - l"});
  CHECK_FALSE(oracle_assembly(model, state_at(model, {-1, 0}, {0, 0})));
}

TEST_CASE("velocity constraints change only the constrained combination of rates") {
  ModelBuilder b;
  b.coordinate("x").coordinate("y").T("x_d^2 + y_d^2");
  Constraint skate;
  skate.value = b.expression("x_d - y_d");
  skate.is_position = false;
  b.model.constraints.push_back(skate);
  const auto assembled = oracle_assembled_state(b.model, state_at(b.model, {7, 8}, {1, 3}));
  REQUIRE(assembled);
  CHECK(assembled->q == Values{7, 8});
  check_agree(assembled->v, {2, 2});
}

TEST_CASE("quaternions keep length 1") {
  ModelBuilder b;
  b.rotation("e").T("e1_d^2 + 3/2*e2_d^2 + 5/2*e3_d^2");
  Constraint tilt;
  tilt.value = b.expression("e_x - e_w/2");
  b.model.constraints.push_back(tilt);
  const auto assembled = oracle_assembled_state(b.model, nominal_state(b.model, {}));
  REQUIRE(assembled);
  const Values& e = assembled->q;
  check_agree({e[1], e[0] * e[0] + e[1] * e[1]}, {e[0] / 2, 1});
  check_agree({e[2], e[3]}, {0, 0});
}

TEST_CASE("without constraints any state is assembled") {
  const Model model = constrained_point({});
  const auto assembled = oracle_assembled_state(model, state_at(model, {3, 4}, {1, 2}));
  REQUIRE(assembled);
  CHECK(assembled->q == Values{3, 4});
  CHECK(assembled->v == Values{1, 2});
}

}  // namespace elgen::test
