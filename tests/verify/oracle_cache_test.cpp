// Cached values are the oracle's. Also tests the rule by which numbers of program and oracle agree.
#include "verify/bounds/oracle_cache.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Real power(int exponent) { return Real(power_of_ten(exponent)); }

}  // namespace

TEST_CASE("values are the oracle's, and each output is computed once") {
  const System system = cart_pole_system();
  const SystemUnderTest subject = system.subject();
  OracleCache cache(subject, random_state(system.model, 1));
  const OutputRequest mass{.kind = OutputKind::mass_matrix};
  const OracleValues& first = cache.values(mass);
  CHECK(first == oracle_values(system.model, mass, cache.state()));
  CHECK(cache.values({.kind = OutputKind::user_value})->size() == 2);
  CHECK(&cache.values(mass) == &first);
}

TEST_CASE("the energy is an absolute value, and 0 if there is none") {
  const System system = cart_pole_system();
  const SystemUnderTest subject = system.subject();
  State state = nominal_state(system.model, system.scene);
  state.q[1] = 3;  // below the pivot V < 0
  CHECK(OracleCache(subject, state).energy_magnitude() > 0);
  const System undefined = system_of(pendulum().V("sqrt(-1 - th^2)").model, "");
  const SystemUnderTest other = undefined.subject();
  CHECK(OracleCache(other, nominal_state(undefined.model, {})).energy_magnitude() == 0);
}

TEST_CASE("the energy of balanced weights is not 0") {
  ModelBuilder seesaw;
  seesaw.coordinate("th").parameter("m", "30").parameter("l", "2").parameter("g", "10");
  seesaw.point("right", {"l*cos(th)", "l*sin(th)"}, "m");
  seesaw.point("left", {"-l*cos(th)", "-l*sin(th)"}, "m").gravity({"0", "-g"});
  const System system = system_of(seesaw.model, "parameters m l g\ncoordinates th\n");
  const SystemUnderTest subject = system.subject();
  State state = nominal_state(subject.model, subject.scene);
  state.q = {cln::cl_R(1)};
  state.v = {cln::cl_R(0)};
  CHECK(OracleCache(subject, state).energy_magnitude() > 1000);  // 2 m g l sin(1)
}

TEST_CASE(
    "numbers agree to 50 digits of their error and value, or 52 of the larger terms that they come "
    "from") {
  const Real none;
  CHECK(agrees({Real(1), Real(1)}, Real(1) + power(-50), none));
  CHECK_FALSE(agrees({Real(1), Real(1)}, Real(1) + power(-49), none));
  CHECK(agrees({Real(1), Real::undefined()}, Real(1) + power(-51), none));
  CHECK(agrees({none, none}, power(-52), Real(1)));
  CHECK_FALSE(agrees({none, none}, power(-51), Real(1)));
}

TEST_CASE("an undefined value agrees with nothing, and is reported as undefined") {
  CHECK_FALSE(agrees({Real::undefined(), Real(1)}, Real(1), Real(1)));
  CHECK_FALSE(agrees({Real(1), Real(1)}, Real::undefined(), Real(1)));
  CHECK(short_text(Real::undefined()) == "undefined");
  CHECK(short_text(Real(3)) == "3");
}

TEST_CASE(
    "exact zeros agree within the rounding of energy and forces, whatever the outputs' names") {
  // The program has only the drift, with another name. No output gives the size of the forces.
  ModelBuilder builder = cart_pole().parameter("c", "0.3");
  System system = system_of(builder.model,
                            "parameters M m l g c\ncoordinates x th\ninputs u\n"
                            "function rest = drift\n  0 = constant 0\n  result 2 1 = 0 0\n");
  const SystemUnderTest subject = system.subject();
  State state = random_state(system.model, 1);
  state.v[1] = power_of_ten(20);  // C v is 1e40
  state.q[1] = 1;
  OracleCache oracle(subject, state);
  CHECK(oracle.rounding_scale() > power_of_ten(38));
  CHECK(agrees_with_oracle({Real(), Real()}, power_of_ten(-14), oracle));
  CHECK_FALSE(agrees_with_oracle({Real(), Real()}, power_of_ten(-8), oracle));
}

TEST_CASE("contractions of entries are those of the oracle") {
  const System system = cart_pole_system();
  const SystemUnderTest subject = system.subject();
  OracleCache cache(subject, random_state(system.model, 3));
  const OutputRequest dynamics{.kind = OutputKind::forward_dynamics};
  CHECK(oracle_needs_entries(dynamics));
  for (const std::size_t field : {std::size_t{0}, std::size_t{1}}) {
    const Contraction by{{2, -3}, {}, field};
    const auto found = cache.contraction(dynamics, by);
    REQUIRE(found);
    const std::vector<cln::cl_R>& all = *cache.values(dynamics);
    CHECK(*found == 2 * all[2 * field] - 3 * all[2 * field + 1]);
    CHECK(found == oracle_contraction(system.model, dynamics, cache.state(), by));
  }
  const OutputRequest mass{.kind = OutputKind::mass_matrix};
  CHECK_FALSE(oracle_needs_entries(mass));
  CHECK(cache.contraction(mass, {{1, 0}, {0, 1}}) == (*cache.values(mass))[1]);
}

TEST_CASE("M comes from inverse dynamics, if it agrees with the energies") {
  const System system = masses_in_a_row(5);
  const State state = random_state(system.model, 1);
  const auto mass_by = [&](const Program& unrequested) {
    const SystemUnderTest subject{system.model, system.scene, system.program, &unrequested};
    OracleCache cache(subject, state);
    CHECK(cache.diagonal_of_mass() == std::vector<cln::cl_R>(5, 3));
    return cache.mass_of_program();
  };
  const OracleValues mass = mass_by(forces_of_masses(5));
  REQUIRE(mass);
  for (std::size_t k = 0; k < 25; ++k) CHECK((*mass)[k] == (k % 6 == 0 ? 3 : 0));
  CHECK_FALSE(mass_by({}));
  const System few = masses_in_a_row(4);
  const Program forces = forces_of_masses(4);
  const SystemUnderTest solved{few.model, few.scene, few.program, &forces};
  CHECK_FALSE(OracleCache(solved, random_state(few.model, 1)).mass_of_program());
}

TEST_CASE("wrong inverse dynamics gives no M") {
  const System system = masses_in_a_row(5);
  const Program wrong = forces_of_masses(5, true);
  const SystemUnderTest subject{system.model, system.scene, system.program, &wrong};
  OracleCache cache(subject, random_state(system.model, 1));
  CHECK_FALSE(cache.mass_of_program());
}
