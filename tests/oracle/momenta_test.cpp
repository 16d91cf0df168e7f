// Tests momenta: p = M v + b with b != 0, Euler's equations, and singular mass matrices.
#include <catch2/catch.hpp>

#include "oracle/samples.hpp"
#include "oracle/solved_dynamics.hpp"

namespace elgen::test {

using Values = std::vector<cln::cl_R>;

TEST_CASE("velocities of momenta solve p = M v + b with b subtracted") {
  const ModelBuilder b = charged_particle();
  State state = random_state(b.model, 4);
  const OracleValues p = value_of(b.model, OutputKind::momentum, state);
  REQUIRE(p);
  const Values v = oracle::velocities_of_momenta(b.model, state, *p);
  REQUIRE(v.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(agree(v[i], state.v[i], 85, 1));
  CHECK_FALSE(agree((*p)[0], 2 * state.v[0], 3, 1));
  state.momenta = *p;
  const OracleValues energy = value_of(b.model, OutputKind::energy_function, state);
  const OracleValues h = value_of(b.model, OutputKind::hamiltonian, state);
  REQUIRE((energy && h));
  CHECK(agree(h->front(), energy->front(), 85, 1));
}

TEST_CASE("momenta of a free top follow Euler's equations") {
  ModelBuilder b;
  b.rotation("e").T("(2*e1_d^2 + 3*e2_d^2 + 5*e3_d^2)/2");
  State state = nominal_state(b.model, {});
  state.momenta = {2, 6, 15};  // w = (1, 2, 3)
  const OracleValues rates = value_of(b.model, OutputKind::hamilton_equations, state);
  REQUIRE(rates);
  const Values expected{0, exact("1/2"), 1, exact("3/2"), -12, 9, -2};
  CHECK(*rates == expected);
}

TEST_CASE("if M is singular, momenta give no velocities") {
  ModelBuilder b;
  b.coordinate("x").T("x*x_d^2");
  State state = nominal_state(b.model, {});
  state.momenta = {1};
  CHECK_FALSE(value_of(b.model, OutputKind::velocities_of_momenta, state));
  state.q = {1};
  const OracleValues v = value_of(b.model, OutputKind::velocities_of_momenta, state);
  REQUIRE(v);
  CHECK(*v == Values{exact("1/2")});
}

}  // namespace elgen::test
