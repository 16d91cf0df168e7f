// Generalized forces by both routes against the textbook route.
#include "derive/outputs/forces.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

template <class Expected>
void check_entries(const Derived& system, const Vector& derived, const Expected& expected) {
  REQUIRE(derived.size() == system.size());
  for (std::size_t i = 0; i < derived.size(); ++i) {
    INFO("entry " << i);
    CHECK(system.agree(derived[i], expected(i)));
  }
}

}  // namespace

TEST_CASE("inverse dynamics, bias, momentum and dL/dq of every system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    check_entries(s, inverse_dynamics(s.derivation),
                  [&](std::size_t i) { return s.textbook.inverse_dynamics(i); });
    check_entries(s, bias(s.derivation, InputForces::absent),
                  [&](std::size_t i) { return s.textbook.bias(i); });
    check_entries(s, momentum(s.derivation), [&](std::size_t i) { return s.textbook.momentum(i); });
    check_entries(s, position_gradient(s.derivation),
                  [&](std::size_t i) { return s.textbook.position_gradient(i); });
  }
}

TEST_CASE("velocity force, drift and gravity of every quadratic system") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    if (!s.source.quadratic) continue;
    check_entries(s, velocity_force(s.derivation),
                  [&](std::size_t i) { return s.textbook.velocity_force(i); });
    check_entries(s, gravity(s.derivation), [&](std::size_t i) { return s.textbook.gravity(i); });
    check_entries(s, drift(s.derivation), [&](std::size_t i) { return s.textbook.drift(i); });
  }
}

TEST_CASE("forces with and without inputs") {
  Derived s(everything_text());
  check_entries(s, applied_force(s.derivation, InputForces::absent),
                [&](std::size_t i) { return s.textbook.without_inputs(s.textbook.force(i)); });
  check_entries(s, bias(s.derivation, InputForces::acting), [&](std::size_t i) {
    const GiNaC::ex force = s.textbook.force(i);
    return s.textbook.bias(i) + s.textbook.without_inputs(force) - force;
  });
}

TEST_CASE("dissipation is the gradient of D by the rates") {
  Derived s(everything_text());
  const Vector force = dissipation(s.derivation);
  const GiNaC::ex D = s.textbook.out(s.source.dissipation.front());
  CHECK(s.agree(force[0], Textbook::by(D, s.source.symbols.v[0])));
  CHECK(force[1].is_zero());
}

TEST_CASE("where time does not occur nothing drifts") {
  Derived s(chain_text());
  for (const GiNaC::ex& entry : drift(s.derivation)) CHECK(entry.is_zero());
}

TEST_CASE("applied forces with the inputs acting are all of the right side") {
  Derived s(everything_text());
  check_entries(s, applied_force(s.derivation, InputForces::acting),
                [&](std::size_t i) { return s.textbook.force(i); });
}
