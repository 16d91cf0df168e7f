// The textbook derivation checks the time derivatives, the energies split by degree in the rates,
// and the derivation steps.
#include "derive/lagrangian/derivation.hpp"

#include <catch2/catch.hpp>

#include "derived.hpp"
#include "elgen/steps.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const FieldEquations& field(const DerivationSteps& steps, const std::string& output,
                            const std::string& name) {
  for (const OutputEquations& step : steps.equations.outputs) {
    for (const FieldEquations& field : step.fields) {
      if (step.request.name == output && field.name == name) return field;
    }
  }
  throw std::runtime_error("no step " + output + "." + name);
}

}  // namespace

TEST_CASE("the four directions differ in the variables that they move") {
  Derived s(read_model("everything"));
  const GiNaC::ex& x = s.source.masses.front().position[0];
  const GiNaC::ex whole = s.textbook.rate(s.textbook.write_out(x));
  GiNaC::ex still = whole;
  for (const GiNaC::ex& v : s.source.symbols.v) still = still.subs(v == 0);
  CHECK(s.agree(s.derivation.motion_rate(x), whole));
  CHECK(s.agree(s.derivation.rate_without_acceleration(x), whole));
  CHECK(s.agree(s.derivation.time_partial(x), still));
  CHECK(s.agree(s.derivation.rate_at_fixed_time(x), whole - still));
}

TEST_CASE(
    "graded energies sum to T and V without the point masses, and have their degree in the rates") {
  Derived s(read_model("everything"));
  const auto whole = [&](const Terms& terms) {
    GiNaC::ex sum = 0;
    for (const GiNaC::ex& term : terms) sum += term;
    return written_out(s.derivation.definitions, sum);
  };
  const GradedEnergies& graded = s.derivation.graded_energies();
  const Terms* const kinetic[] = {&graded.kinetic0, &graded.kinetic1, &graded.kinetic2};
  const Terms* const potential[] = {&graded.potential0, &graded.potential1};
  const auto check = [&](const auto& grades, const GiNaC::ex& expected) {
    GiNaC::exmap faster;
    for (const GiNaC::ex& v : s.source.symbols.v) faster[v] = 3 * v;
    GiNaC::ex total = 0;
    GiNaC::ex factor = 1;
    for (const Terms* grade : grades) {
      const GiNaC::ex part = whole(*grade);
      CHECK(s.agree(part.subs(faster, GiNaC::subs_options::no_pattern), factor * part));
      factor *= 3;
      total += part;
    }
    CHECK(s.agree(total, expected));
  };
  check(kinetic, whole(values_of(s.source.kinetic)));
  check(potential, whole(values_of(s.source.potential)));
  CHECK_FALSE(graded.kinetic1.empty());
}

TEST_CASE("the derivation steps of every system agree with the textbook") {
  for (const auto& [name, text] : systems()) {
    INFO(name);
    Derived s(text);
    const Result<DerivationSteps> steps = derive_textbook_steps(s.source);
    REQUIRE(steps);
    const auto total = [&](const std::string& output, const std::string& step) {
      GiNaC::ex sum = 0;  // the sum of the printed terms
      for (const GiNaC::ex& entry : field(*steps, output, step).entries) {
        sum += written_out(steps->equations.definitions, entry);
      }
      return sum;
    };
    const auto agree = [&](const std::string& output, const std::string& step,
                           const GiNaC::ex& expected) {
      INFO(output << "." << step);
      CHECK(s.agree(total(output, step), expected));
    };
    for (std::size_t i = 0; i < s.size(); ++i) {
      const std::string& q = s.source.leaves.q[i];
      const GiNaC::ex momentum = s.textbook.momentum(i);
      const GiNaC::ex force = s.textbook.force(i);
      agree(q, "momentum", momentum);
      agree(q, "momentum_rate", s.textbook.rate(momentum));
      agree(q, "force", force);
      const GiNaC::ex left =
          total(q, "momentum_rate") - total(q, "partial") + total(q, "dissipation");
      CHECK(s.agree(left, s.textbook.inverse_dynamics(i) + s.textbook.without_inputs(force)));
    }
    agree("invariants", "E", s.textbook.energy());
  }
}

TEST_CASE("positions and velocities in steps refer to their point or body") {
  Derived s(read_model("cart_pole"));
  const Result<DerivationSteps> steps = derive_textbook_steps(s.source);
  REQUIRE(steps);
  REQUIRE(steps->masses.size() == 2);
  CHECK(steps->masses[1].kind == EntityKind::point);
  CHECK(steps->masses[1].index == 1);
  CHECK(steps->equations.outputs.at(0).fields.size() == 2);
  CHECK(steps->equations.outputs.at(1).fields.at(1).rows == 3);
}
