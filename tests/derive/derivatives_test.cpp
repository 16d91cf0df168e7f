// Derivatives of the dynamics against the oracle.
#include "derive/outputs/derivatives.hpp"

#include <catch2/catch.hpp>

#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

void check_derivatives(const std::vector<NamedText>& texts) {
  for (const auto& [name, text] : texts) {
    Framed system(text);
    for (const char* output :
         {"inverse_dynamics_derivatives", "forward_dynamics_derivatives", "linearization"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}

/// (f(x + h) - f(x - h))/2h of the derived inverse dynamics, along one entry of q or v.
Reals slopes(Framed& system, State state, Reals State::*of, std::size_t j) {
  const cln::cl_RA h = cln::expt(cln::cl_RA(10), -15);
  cln::cl_R& x = (state.*of)[j];
  x = x + h;
  const Reals above = system.derived("inverse_dynamics", state);
  x = x - 2 * h;
  Reals result = system.derived("inverse_dynamics", state);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = (above[i] - result[i]) / (2 * h);
  return result;
}

}  // namespace

TEST_CASE("derivatives of systems of frames", "[frames]") { check_derivatives(frame_systems()); }

TEST_CASE("derivatives of systems without frames") { check_derivatives(systems()); }

TEST_CASE("derivatives by columns are the slopes of the inverse dynamics", "[frames]") {
  for (const std::string& text : {two_turns_text(), turntable_text(), two_arms_text()}) {
    Framed system(text);
    INFO(system.checked.model.name);
    const State state = some_state(system.checked);
    const Reals derived = system.derived("inverse_dynamics_derivatives", state);
    const std::size_t n = system.size();
    for (std::size_t j = 0; j < n; ++j) {
      Reals by_position;
      Reals by_velocity;
      for (std::size_t i = 0; i < n; ++i) {
        by_position.push_back(derived[i * n + j]);
        by_velocity.push_back(derived[n * n + i * n + j]);
      }
      CHECK(nearly_equal(by_position, slopes(system, state, &State::q, j), 25));
      CHECK(nearly_equal(by_velocity, slopes(system, state, &State::v, j), 25));
    }
  }
}
