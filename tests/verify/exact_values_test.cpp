// Values, slopes and curvatures of a program at one state. The residual of a balance is relative to
// the size of the terms, and undefined if a term is undefined.
#include "program/evaluate/exact_values.hpp"

#include <catch2/catch.hpp>

#include "support/real.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

double number(const Real& x) { return to_double(x.value()); }

ExactValues at(const System& system) {
  State state = nominal_state(system.model, system.scene);
  state.q = {cln::cl_R(2), cln::cl_R(0)};
  state.v = {cln::cl_R(3), cln::cl_R(4)};
  return {system.subject(), state};
}

}  // namespace

TEST_CASE("values are the program's") {
  const System system = cart_pole_system();
  ExactValues values = at(system);
  CHECK(number(values.entries(OutputKind::mass_matrix)[0]) == 1.1);
  CHECK(number(values.entries(OutputKind::user_value)[1]) == 0.5);
  CHECK(number(values.rounding_floor()) > 1e-20);
}

TEST_CASE("outputs that the program lacks come from the oracle, undefined if it has no value") {
  const System system = cart_pole_system();
  ExactValues values = at(system);
  CHECK(number(values.entries(OutputKind::applied_force)[0]) == 0);
  const System singular = system_of(pendulum().parameter("z", "0").T("1/z").model, "");
  ExactValues none(singular.subject(), nominal_state(singular.model, singular.scene));
  CHECK_FALSE(none.entries(OutputKind::kinetic_energy)[0].is_defined());
}

TEST_CASE("undefined values have the shape of their output") {
  ModelBuilder builder = cart_pole();
  builder.parameter("z", "0").T("1/z").force_on(0, "1/z");
  const System system = system_of(builder.model, "");
  ExactValues none(system.subject(), nominal_state(system.model, system.scene));
  CHECK(none.entries(OutputKind::applied_force).size() == 2);
  CHECK(none.entries(OutputKind::kinetic_energy).size() == 1);
  CHECK(none.entries(OutputKind::mass_matrix).size() == 4);
}

TEST_CASE("slopes and curvatures are taken along the direction") {
  const System system = cart_pole_system();
  const ExactValues values = at(system);
  Arguments<Real> direction = values.zero_direction();
  direction.q[1] = Real(2);
  // tip = (x + l sin th, l cos th) at th = 0: slopes (2 l, 0), curvatures (0, -4 l)
  const auto slopes = values.directional_derivatives(OutputKind::user_value, direction);
  CHECK(number(slopes[0]) == 1);
  CHECK(number(slopes[1]) == 0);
  const auto curvatures = values.second_derivatives(OutputKind::user_value, direction);
  CHECK(number(curvatures[0]) == 0);
  CHECK(number(curvatures[1]) == -2);
}

TEST_CASE("functions can be evaluated at other states") {
  const System system = cart_pole_system();
  const ExactValues values = at(system);
  Arguments<Real> moved = values.arguments();
  moved.v = {Real(5), Real(0)};
  CHECK(number(values.entries_at(OutputKind::dissipation, moved)[0]) == 1.5);
}

TEST_CASE("the figure is the largest sum divided by the size of the largest term") {
  ResidualSums balance(2);
  balance.add(0, real("3"));
  balance.add(0, real("-2"));
  balance.add(1, real("10"));
  balance.add(1, real("-10"));
  CHECK(balance.relative_residual(Real()).value() == Approx(1.0 / 20));
  CHECK(balance.relative_residual(real("30")).value() == Approx(1.0 / 50));
}

TEST_CASE("terms that are all zero balance") {
  ResidualSums balance(1);
  balance.add(0, Real());
  CHECK(balance.relative_residual(Real()) == 0.0);
}

TEST_CASE("a difference as small as the rounding of a larger term is none") {
  ResidualSums balance(1);
  balance.add(0, real("1e-64"));
  CHECK(balance.relative_residual(Real()).value() == Approx(1));
  CHECK(balance.relative_residual(real("1e-20")).value() < 1e-40);
}

TEST_CASE("an undefined term has no figure") {
  ResidualSums balance(2);
  balance.add(0, real("1"));
  balance.add(1, Real::undefined());
  CHECK_FALSE(balance.relative_residual(real("1")));
}
