// Outputs of systems of frames agree with the oracle, which works in the world, and obey general
// laws of mechanics.
#include <catch2/catch.hpp>

#include "derive/outputs/outputs.hpp"
#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// Central differences (f(x + h) - f(x - h))/(2 h): f is the derived inverse dynamics, x is the
/// entry `j` of q or v.
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

/// The model `text` with frames, points, bodies and forces in reverse order.
std::string reversed_entries(const std::string& text) {
  std::string front;
  std::string back;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t next = text.find("\n[", begin);
    const std::size_t end = next == std::string::npos ? text.size() : next + 1;
    const std::string entry = text.substr(begin, end - begin);
    const bool is_placed = entry.rfind("[[frame", 0) == 0 || entry.rfind("[[point", 0) == 0 ||
                           entry.rfind("[[body", 0) == 0 || entry.rfind("[[force", 0) == 0;
    (is_placed ? back : front).insert(is_placed ? 0 : front.size(), entry);
    begin = end;
  }
  return front + back;
}

}  // namespace

TEST_CASE("outputs of systems of frames agree with the oracle", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    for (const OutputRequest& output : system.checked.scene.outputs) {
      if (!has_equations(output_row(output.kind))) continue;
      INFO(name << " " << output.name);
      CHECK(system.agrees(output.name));
    }
  }
}

TEST_CASE("derivatives of systems without frames agree with the oracle") {
  for (const auto& [name, text] : systems()) {
    Framed system(text);
    for (const char* output :
         {"inverse_dynamics_derivatives", "forward_dynamics_derivatives", "linearization"}) {
      INFO(name << " " << output);
      CHECK(system.agrees(output));
    }
  }
}

TEST_CASE("derivatives by columns agree with differences of the inverse dynamics", "[frames]") {
  for (const std::string& text :
       {read_model("two_turns"), read_model("turntable"), read_model("two_arms")}) {
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

TEST_CASE("two arms are coupled only through their base", "[frames]") {
  Framed system(read_model("two_arms"));
  const std::size_t n = system.size();
  const RealVector mass = system.derived("mass_matrix");
  const RealVector coriolis = system.derived("coriolis_matrix");
  // Velocities x, a1, a2, b1, b2; the energy couples a1 and b2.
  for (const auto& [i, j] :
       std::vector<std::pair<std::size_t, std::size_t>>{{1, 3}, {2, 3}, {2, 4}}) {
    INFO(i << " " << j);
    CHECK(mass[i * n + j].is_zero());
    CHECK(mass[j * n + i].is_zero());
    CHECK(coriolis[i * n + j].is_zero());
    CHECK(coriolis[j * n + i].is_zero());
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK(mass[i * n + j].is_equal(mass[j * n + i]));
  }
}

TEST_CASE("dM/dt - 2 C is skew-symmetric", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    const Framed system(text);
    Derivation derivation(system.lagrangian);
    const std::size_t n = derivation.size();
    const RealVector mass = mass_matrix(derivation);
    const RealVector coriolis = coriolis_matrix(derivation);
    RealVector rates;
    RealVector sums;
    for (std::size_t i = 0; i < n * n; ++i) {
      rates.push_back(derivation.rate_at_fixed_time(mass[i]));
      sums.push_back(coriolis[i] + coriolis[i % n * n + i / n]);
    }
    const NumbersAt at(derivation.symbols, derivation.definitions, some_state(system.checked));
    CHECK(nearly_equal(at(sums), at(rates)));
  }
}

TEST_CASE("the order of declaration changes no value", "[frames]") {
  for (const auto& [name, text] : frame_systems()) {
    Framed system(text);
    Framed reversed(reversed_entries(text));
    const State state = some_state(system.checked);
    for (const char* output : {"mass_matrix", "coriolis_matrix", "bias", "inverse_dynamics"}) {
      INFO(name << " " << output);
      CHECK(nearly_equal(reversed.derived(output, state), system.derived(output, state)));
    }
  }
}
