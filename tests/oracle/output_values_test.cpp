#include "oracle/output_values.hpp"

#include <catch2/catch.hpp>

#include "oracle/samples.hpp"

using namespace elgen;
using namespace elgen::oracle;
using namespace elgen::test;
using Values = std::vector<cln::cl_R>;

namespace {

ModelBuilder polar() {
  ModelBuilder b;
  b.coordinate("r").coordinate("ph").input("u", 0).parameter("m", "2");
  b.T("m*(r_d^2 + r^2*ph_d^2)/2").V("m*r").D("r_d^2").force_on(1, "r*u - 3");
  b.output({"r^2*ph", "t*r"});
  return b;
}

/// r = 2, ph = 3, dr/dt = 5, dph/dt = 7, accelerations 11 and 13, u = 17, t = 19
State polar_state(const ModelBuilder& b) {
  State state = nominal_state(b.model, {});
  state.q = {2, 3};
  state.v = {5, 7};
  state.a = {11, 13};
  state.u = {17};
  state.t = 19;
  return state;
}

Values value(OutputKind kind) {
  const ModelBuilder b = polar();
  OutputRequest request;
  request.kind = kind;
  return output_values(b.model, request, polar_state(b));
}

}  // namespace

TEST_CASE("every output of a particle in polar coordinates, by hand") {
  CHECK(value(OutputKind::mass_matrix) == Values{2, 0, 0, 8});
  CHECK(value(OutputKind::coriolis_matrix) == Values{0, -28, 28, 20});
  CHECK(value(OutputKind::velocity_force) == Values{-196, 280});
  CHECK(value(OutputKind::gravity) == Values{2, 0});
  CHECK(value(OutputKind::potential_energy) == Values{4});
  CHECK(value(OutputKind::drift) == Values{0, 0});
  CHECK(value(OutputKind::dissipation) == Values{10, 0});
  CHECK(value(OutputKind::applied_force) == Values{0, -3});
  CHECK(value(OutputKind::bias) == Values{-196 + 2 + 10, 280 + 3});
  CHECK(value(OutputKind::momentum) == Values{10, 56});
  CHECK(value(OutputKind::position_gradient) == Values{194, 0});
  CHECK(value(OutputKind::kinetic_energy) == Values{221});
  CHECK(value(OutputKind::total_energy) == Values{225});
  CHECK(value(OutputKind::energy_function) == Values{225});
  CHECK(value(OutputKind::input_matrix) == Values{1, 2});
  CHECK(value(OutputKind::inverse_dynamics) == Values{22 - 184, 104 + 283});
  CHECK(value(OutputKind::forward_dynamics) == Values{exact("201/2"), exact("-249/8"), 1, 1});
}

TEST_CASE("a user output: value, Jacobian, bias with d2y/dt2 = J a + bias") {
  CHECK(value(OutputKind::user_value) == Values{12, 38});
  CHECK(value(OutputKind::user_jacobian) == Values{12, 4, 19, 0});
  // d2/dt2 (r^2 ph) = 2 dr^2 ph + 4 r dr dph at a = 0; d2/dt2 (t r) = 2 dr
  CHECK(value(OutputKind::user_bias) == Values{150 + 280, 10});
}

TEST_CASE("the struct of all outputs has no entries of its own") {
  CHECK(value(OutputKind::dynamics).empty());
}
