// Textbook systems and random exact states for the tests of the oracle and of the inspection.
#pragma once

#include <random>

#include "elgen/oracle.hpp"
#include "oracle/model_builder.hpp"

namespace elgen::test {

inline OracleValues value_of(const Model& model, OutputKind kind, const State& state) {
  OutputRequest request;
  request.kind = kind;
  return oracle_values(model, request, state);
}

/// A state with parameters at their values, h = 1/9, and q, v, a, u, t and p random in [-2, 2].
inline State random_state(const Model& model, unsigned seed) {
  std::mt19937 random(seed);
  const auto fraction = [&] {
    return cln::cl_RA(static_cast<int>(random() % 4001) - 2000) / cln::cl_RA(1009);
  };
  State state = nominal_state(model, {});
  for (auto* entries : {&state.q, &state.v, &state.a, &state.u}) {
    for (auto& entry : *entries) entry = fraction();
  }
  state.t = fraction();
  state.h = cln::cl_RA(1) / 9;
  for (auto& p : state.momenta) p = fraction();
  return state;
}

/// |x - y| <= 10^-digits max(|x|, |y|, floor)
inline bool agree(const cln::cl_R& x, const cln::cl_R& y, int digits, const cln::cl_R& floor = 0) {
  const cln::cl_R scale = cln::max(cln::max(cln::abs(x), cln::abs(y)), floor);
  return cln::abs(x - y) <= scale * cln::expt(cln::cl_R(10), -digits);
}

inline ModelBuilder pendulum() {
  ModelBuilder b;
  b.coordinate("th", "rad").parameter("m", "2").parameter("l", "0.75").parameter("g", "9.81");
  b.point("bob", {"l*sin(th)", "-l*cos(th)"}, "m").gravity({"0", "-g"});
  return b;
}

/// Cart and pole; th is the angle of the pole from the upward vertical.
inline ModelBuilder cart_pole() {
  ModelBuilder b;
  b.coordinate("x", "m").coordinate("th", "rad").input("u", 0).parameter("M", "1");
  b.parameter("m", "0.1").parameter("l", "0.5").parameter("g", "9.81");
  b.point("cart", {"x", "0"}, "M").point("bob", {"x + l*sin(th)", "l*cos(th)"}, "m");
  b.gravity({"0", "-g"});
  return b;
}

inline ModelBuilder double_pendulum() {
  ModelBuilder b;
  b.coordinate("th1", "rad").coordinate("th2", "rad").parameter("m1", "1").parameter("m2", "0.5");
  b.parameter("l1", "0.8").parameter("l2", "0.6").parameter("g", "9.81");
  b.point("elbow", {"l1*sin(th1)", "-l1*cos(th1)"}, "m1");
  b.point("bob", {"x(elbow) + l2*sin(th2)", "y(elbow) - l2*cos(th2)"}, "m2").gravity({"0", "-g"});
  return b;
}

inline ModelBuilder spherical_pendulum() {
  ModelBuilder b;
  b.coordinate("th", "rad").coordinate("ph", "rad");
  b.parameter("m", "1.5").parameter("l", "0.7").parameter("g", "9.81");
  b.point("bob", {"l*sin(th)*cos(ph)", "l*sin(th)*sin(ph)", "-l*cos(th)"}, "m");
  b.gravity({"0", "0", "-g"});
  return b;
}

/// Charge c in a uniform magnetic field Bz along z: V = -c A.v with A = Bz/2 (-y, x, 0).
inline ModelBuilder charged_particle() {
  ModelBuilder b;
  b.coordinate("x", "m").coordinate("y", "m").coordinate("z", "m");
  b.parameter("m", "2").parameter("c", "0.3").parameter("Bz", "1.7");
  b.T("m*(x_d^2 + y_d^2 + z_d^2)/2").V("-c*Bz/2*(x*y_d - y*x_d)");
  return b;
}

/// A bead on a hoop. The hoop turns about the vertical by the prescribed angle phi(t).
inline ModelBuilder rotating_hoop(const std::string& angle) {
  ModelBuilder b;
  b.coordinate("th", "rad").parameter("m", "1.2").parameter("R", "0.4").parameter("g", "9.81");
  b.parameter("W", "3").prescribed("phi", angle).definition("r", "R*sin(th)");
  b.point("bead", {"r*cos(phi)", "r*sin(phi)", "-R*cos(th)"}, "m").gravity({"0", "0", "-g"});
  return b;
}

inline ModelBuilder relativistic_particle() {
  ModelBuilder b;
  b.coordinate("x", "m").parameter("m", "2").parameter("c", "10").parameter("k", "5");
  b.L("-m*c^2*sqrt(1 - x_d^2/c^2) - k*x^2/2");
  b.model.is_quadratic = false;
  return b;
}

/// n links with point masses; absolute angles from the downward vertical.
inline ModelBuilder chain(std::size_t n) {
  ModelBuilder b;
  b.parameter("g", "9.81").parameter("m", "0.2").parameter("l", "0.3").point("p0", {"0", "0"});
  for (std::size_t i = 1; i <= n; ++i) {
    const std::string k = std::to_string(i);
    const std::string before = "p" + std::to_string(i - 1);
    b.coordinate("q" + k, "rad")
        .point("p" + k,
               {"x(" + before + ") + l*sin(q" + k + ")", "y(" + before + ") - l*cos(q" + k + ")"},
               "m");
  }
  b.gravity({"0", "-g"});
  return b;
}

}  // namespace elgen::test
