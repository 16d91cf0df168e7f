// The force that holds a coordinate, by hand.
#include "oracle/reaction.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// T = 1/2 m (dr^2 + r^2 dp^2), V = k r, u on r.
const std::string rotating_pipe = model_text("polar", R"toml(
[[coordinate]]
name = "r"
[[coordinate]]
name = "p"
[parameters]
m = 2
k = 3
[energy]
T = "1/2*m*(dot(r)^2 + r^2*dot(p)^2)"
V = "k*r"
[[input]]
name = "u"
on = "r"
)toml");

}  // namespace

TEST_CASE("the wall of a rotating pipe: m r'' - m r p'^2 + k - u") {
  const CheckedModel held =
      checked_scene(rotating_pipe, "[lock]\nr = { value = \"t^3\", reaction = true }\n");
  State state = nominal_state(held.model, held.scene);
  state.v = {5};
  state.a = {7};
  state.u = {11};
  state.t = 2;
  const State whole = oracle::unlocked_state(held.model, state);
  CHECK(whole.q == std::vector<cln::cl_R>{8, 0});
  CHECK(whole.v == std::vector<cln::cl_R>{12, 5});
  CHECK(whole.a == std::vector<cln::cl_R>{12, 7});
  // m r'' = 24, m r p'^2 = 400
  CHECK(oracle::reaction(held.model, state) == std::vector<cln::cl_R>{24 - 400 + 3 - 11});
}

TEST_CASE("a lock without reaction has no row") {
  const CheckedModel held = checked_scene(rotating_pipe, "[lock]\nr = { value = 1 }\n");
  CHECK(oracle::reaction(held.model, nominal_state(held.model, held.scene)).empty());
}

TEST_CASE("a locked coordinate carries energy as it moves, its armature too") {
  const CheckedModel held = checked_scene(model_text("arm", R"toml(
[[coordinate]]
name = "a"
armature = "J"
[[coordinate]]
name = "b"
[parameters]
J = 3
[energy]
T = "1/2*dot(a)^2 + dot(a)*dot(b)*b + dot(b)^2*a"
V = "a*b"
)toml"),
                                          "[lock]\na = { value = \"3*t^2\" }\n");
  State state = nominal_state(held.model, held.scene);
  state.q = {5};
  state.v = {11};
  state.t = 2;
  const auto value = [&](OutputKind kind) {
    OutputRequest request;
    request.kind = kind;
    return oracle_values(held.model, request, state).value().front();
  };
  // a = 12, da/dt = 12
  CHECK(value(OutputKind::potential_energy) == 60);
  CHECK(value(OutputKind::mass_matrix) == 24);
  CHECK(value(OutputKind::kinetic_energy) == 72 + 12 * 11 * 5 + 121 * 12 + 3 * 72);
}
