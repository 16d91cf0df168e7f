// Each step of a written derivation against the textbook route.
#include "elgen/steps.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const FieldEquations& field(const Steps& steps, const std::string& output,
                            const std::string& name) {
  for (const OutputEquations& step : steps.equations.outputs) {
    for (const FieldEquations& field : step.fields) {
      if (step.request.name == output && field.name == name) return field;
    }
  }
  throw std::runtime_error("no step " + output + "." + name);
}

}  // namespace

TEST_CASE("the steps of every system are the textbook's") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    const Result<Steps> steps = derive_steps(s.source);
    REQUIRE(steps);
    const auto agree = [&](const std::string& output, const std::string& step,
                           const GiNaC::ex& expected) {
      INFO(output << "." << step);
      const GiNaC::ex entry = field(*steps, output, step).entries.at(0);
      const GiNaC::ex derived = written_out(steps->equations.definitions, entry);
      CHECK(s.agree(derived, expected));
    };
    for (std::size_t i = 0; i < s.size(); ++i) {
      const std::string& q = s.source.leaves.q[i];
      const GiNaC::ex momentum = s.textbook.momentum(i);
      const GiNaC::ex force = s.textbook.force(i);
      agree(q, "momentum", momentum);
      agree(q, "momentum_rate", s.textbook.rate(momentum));
      agree(q, "force", force);
      agree(q, "left", s.textbook.inverse_dynamics(i) + s.textbook.without_inputs(force));
    }
    agree("invariants", "E", s.textbook.energy());
  }
}

TEST_CASE("positions and velocities come with what they belong to") {
  Derived s(cart_pole_text());
  const Result<Steps> steps = derive_steps(s.source);
  REQUIRE(steps);
  REQUIRE(steps->masses.size() == 2);
  CHECK(steps->masses[1].kind == EntityKind::point);
  CHECK(steps->masses[1].index == 1);
  CHECK(steps->equations.outputs.at(0).fields.size() == 2);
  CHECK(steps->equations.outputs.at(1).fields.at(1).rows == 3);
}
