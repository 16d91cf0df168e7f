// Cached values are the oracle's.
#include "verify/oracle_cache.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

TEST_CASE("values are the oracle's, each output and user output by itself, asked once") {
  const System system = cart_pole_system();
  const Subject subject = system.subject();
  OracleCache cache(subject, random_state(system.model, 1));
  const OutputRequest mass = standard_request(OutputKind::mass_matrix);
  const OracleValues& first = cache.values(mass);
  CHECK(first == oracle_values(system.model, mass, cache.state()));
  CHECK(cache.values(standard_request(OutputKind::user_value))->size() == 2);
  CHECK(&cache.values(mass) == &first);
}

TEST_CASE("the energy is a magnitude, 0 where there is none") {
  const System system = cart_pole_system();
  const Subject subject = system.subject();
  State state = nominal_state(system.model, system.scene);
  state.q[1] = 3;  // below the pivot: V < 0
  CHECK(OracleCache(subject, state).energy() > 0);
  const System undefined = system_of(pendulum().V("sqrt(-1 - th^2)").model, "");
  const Subject other = undefined.subject();
  CHECK(OracleCache(other, nominal_state(undefined.model, {})).energy() == 0);
}
