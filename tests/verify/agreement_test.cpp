// The rule by which numbers of program and oracle are the same.
#include "verify/bounds/agreement.hpp"

#include <catch2/catch.hpp>

#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Real power(int exponent) { return Real(power_of_ten(exponent)); }

}  // namespace

TEST_CASE("numbers agree to 50 digits of the bound, or 52 of the scale") {
  const Real none;
  CHECK(agrees({Real(1), Real(1)}, Real(1) + power(-50), none));
  CHECK_FALSE(agrees({Real(1), Real(1)}, Real(1) + power(-49), none));
  CHECK(agrees({none, none}, power(-52), Real(1)));
  CHECK_FALSE(agrees({none, none}, power(-51), Real(1)));
}

TEST_CASE("what is undefined agrees with nothing, and is said so") {
  CHECK_FALSE(agrees({Real::undefined(), Real(1)}, Real(1), Real(1)));
  CHECK_FALSE(agrees({Real(1), Real(1)}, Real::undefined(), Real(1)));
  CHECK(short_text(Real::undefined()) == "undefined");
  CHECK(short_text(Real(3)) == "3");
}

TEST_CASE(
    "zeros on paper drown in the rounding of energy and forces, whatever outputs are called") {
  // The drift alone, under another name: no other output says how large the forces are.
  ModelBuilder builder = cart_pole().parameter("c", "0.3");
  System system = system_of(builder.model,
                            "parameters M m l g c\ncoordinates x th\ninputs u\n"
                            "function rest = drift\n  0 = constant 0\n  result 2 1 = 0 0\n");
  const Subject subject = system.subject();
  State state = random_state(system.model, 1);
  state.v[1] = power_of_ten(20);  // C v is 1e40
  state.q[1] = 1;
  OracleCache oracle(subject, state);
  CHECK(oracle.force() > power_of_ten(38));
  CHECK(agrees_with_oracle({Real(), Real()}, power_of_ten(-14), Real(), oracle));
  CHECK_FALSE(agrees_with_oracle({Real(), Real()}, power_of_ten(-8), Real(), oracle));
}
