// Exact states of a model: inside its ranges, and determined by a seed.
#include <catch2/catch.hpp>

#include "oracle/samples.hpp"
#include "sample/states.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using cln::cl_R;

TEST_CASE("states are inside the declared ranges and determined by the seed") {
  ModelBuilder b = cart_pole();
  b.model.coordinates[0].range = Interval{3, 4};
  Sampler draw(5);
  Sampler again(5);
  for (std::size_t turn = 0; turn < 20; ++turn) {
    State state = nominal_state(b.model, {});
    State same = state;
    draw_motion(b.model, draw, turn, state);
    draw_motion(b.model, again, turn, same);
    CHECK(state.q == same.q);
    CHECK((state.q[0] > 3 && state.q[0] <= 4));
  }
}

TEST_CASE("without ranges angles are within one turn, others have three scales in turn") {
  ModelBuilder b = cart_pole();
  b.model.coordinates[1].unit_text = "rad";
  std::vector<cl_R> largest_length(3, cl_R(0));
  cl_R largest_angle = 0;
  Sampler draw(5);
  for (std::size_t turn = 0; turn < 60; ++turn) {
    State state = nominal_state(b.model, {});
    draw_motion(b.model, draw, turn, state);
    largest_length[turn % 3] = cln::max(largest_length[turn % 3], cln::abs(state.q[0]));
    largest_angle = cln::max(largest_angle, cln::abs(state.q[1]));
  }
  CHECK((largest_length[0] > exact("0.5") && largest_length[0] <= 1));
  CHECK((largest_length[1] > exact("0.0005") && largest_length[1] <= exact("0.001")));
  CHECK((largest_length[2] > 500 && largest_length[2] <= 1000));
  CHECK((largest_angle > 2 && largest_angle <= exact("3.15")));
}

TEST_CASE("parameters are nominal, then between half and twice their value or in their range") {
  ModelBuilder b;
  b.coordinate("x").parameter("m", "2").parameter("k", "0").parameter("c", "3").parameter("l", "1");
  b.model.parameter_arrays.resize(4);
  for (std::uint32_t i = 0; i < 4; ++i) b.model.parameters[i].array = i;
  b.model.parameter_arrays[3].range = Interval{exact("0.9"), 50};
  Scene scene;
  scene.specialisation.fixed[2] = {3};
  Sampler draw(1);
  CHECK(draw_state(b.model, scene, draw, 0).parameters == nominal_state(b.model, scene).parameters);
  for (std::size_t turn = 1; turn < 3; ++turn) {
    const State state = draw_state(b.model, scene, draw, turn);
    CHECK((state.parameters[0] >= 1 && state.parameters[0] <= 4));
    CHECK((state.parameters[1] > 0 && state.parameters[1] <= 1));
    CHECK(state.parameters[2] == 3);
    CHECK((state.parameters[3] >= exact("0.9") && state.parameters[3] <= (turn == 2 ? 2 : 50)));
  }
}

TEST_CASE("a state moves onto the constraints if Newton's method converges") {
  const CheckedModel rod = checked_model(model_text("bob", R"toml(
[[coordinate]]
name = "x"
start = { value = 1, rate = 0 }
[[coordinate]]
name = "y"
[parameters]
l = { value = 1 }
[energy]
T = "1/2*l*(dot(x)^2 + dot(y)^2)"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = l"
)toml"));
  State drawn = nominal_state(rod.model, rod.scene);
  drawn.q = {exact("0.3"), exact("-0.7")};
  drawn.v = {1, 2};
  const auto kept = move_onto_constraints(rod.model, drawn);
  REQUIRE(kept);
  // The oracle promises 60 digits.
  const cl_R rounding = exact("1e-60");
  const cl_R f = kept->q[0] * kept->q[0] + kept->q[1] * kept->q[1] - 1;
  CHECK(cln::abs(f) < rounding);
  CHECK(cln::abs(kept->q[0] * kept->v[0] + kept->q[1] * kept->v[1]) < rounding);
  drawn.parameters[0] = -1;
  CHECK_FALSE(move_onto_constraints(rod.model, drawn));
  CHECK(is_compared_on_constraints(rod.model, OutputKind::forward_dynamics));
  CHECK_FALSE(is_compared_on_constraints(rod.model, OutputKind::constraint_residual));
  const ModelBuilder free = cart_pole();
  const State state = nominal_state(free.model, {});
  CHECK(move_onto_constraints(free.model, state)->q == state.q);
  CHECK_FALSE(is_compared_on_constraints(free.model, OutputKind::forward_dynamics));
}
