// Derivatives of accelerations composed of several programs, compared with direct derivation.
#include <catch2/catch.hpp>
#include <functional>

#include "derive/outputs/outputs.hpp"
#include "elgen/compose.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/lower.hpp"
#include "framed.hpp"
#include "program/evaluate/subject.hpp"
#include "support/limbs.hpp"
#include "support/links.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Program program_of(const Framed& system, const std::string& output) {
  const std::vector<OutputRequest> requests{system.request(output)};
  return compose_outputs(*lower(*derive(system.lagrangian, requests, {}), requests, {}));
}

/// Compares the composed `output` with the entries that `longer` derives directly.
void check_composed(const std::string& text, const std::string& output,
                    const std::function<RealVector(Derivation&)>& longer) {
  const Framed system(text);
  const Program program = program_of(system, output);
  const Function& function = program.functions.front();
  CHECK(find_invariant_violation(program).empty());
  CHECK(function.repeated.count >= 16);
  Derivation derivation(system.lagrangian);
  const RealVector entries = longer(derivation);
  for (const int sample : {1, 2}) {
    const State state = some_state(system.checked, sample);
    const OracleValues found =
        to_oracle_values(evaluate(program, function, arguments_at<Real>(state)));
    REQUIRE(found);
    CHECK(nearly_equal(*found,
                       NumbersAt(derivation.symbols, derivation.definitions, state)(entries)));
  }
}

RealVector joined(const std::vector<RealVector>& fields) {
  RealVector all;
  for (const RealVector& field : fields) all.insert(all.end(), field.begin(), field.end());
  return all;
}

/// Masses on springs in a row; M is diagonal.
std::string springs_text(int n) {
  std::string coordinates;
  std::string kinetic;
  std::string potential;
  for (int i = 1; i <= n; ++i) {
    const std::string x = "x" + std::to_string(i);
    const std::string before = i == 1 ? "0" : "x" + std::to_string(i - 1);
    coordinates += "[[coordinate]]\nname = \"" + x + "\"\n";
    kinetic += (i == 1 ? "" : " + ") + ("m*dot(" + x + ")^2/2");
    potential += (i == 1 ? "" : " + ") + ("k*(" + x + " - " + before + ")^2/2");
  }
  return model_text("springs", coordinates + "[parameters]\nm = 2\nk = 3\n[energy]\nT = \"" +
                                   kinetic + "\"\nV = \"" + potential + "\"\n");
}

}  // namespace

TEST_CASE("composed derivatives agree with direct derivation", "[frames]") {
  check_composed(limbs_text(5), "forward_dynamics_derivatives", [](Derivation& derivation) {
    const ForwardDerivatives all = forward_dynamics_derivatives(derivation);
    return joined({all.by_position, all.by_velocity, all.by_input});
  });
}

TEST_CASE("with rotations a linearization is composed except for the rates of coordinates",
          "[frames]") {
  check_composed(limbs_text(4, true), "linearization", [](Derivation& derivation) {
    const Linearization all = linearization(derivation);
    return joined({all.a, all.b});
  });
}

TEST_CASE("with few velocities or zero matrices the program has no repetition", "[frames]") {
  Derivation few(Framed(limbs_text(4)).lagrangian);
  CHECK(few.size() == 9);
  CHECK_FALSE(forward_dynamics_terms(few));
  Derivation chain(Framed(links_text(10)).lagrangian);
  CHECK(forward_dynamics_terms(chain));
  CHECK(program_of(Framed(limbs_text(4)), "linearization").functions[0].repeated.count == 0);
  const Program springs = program_of(Framed(springs_text(12)), "forward_dynamics_derivatives");
  CHECK(springs.functions[0].repeated.count == 0);
}
