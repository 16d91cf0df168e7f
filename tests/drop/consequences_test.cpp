// What every output loses by a term of M, of V0 and of forces.
#include "drop/consequences.hpp"

#include <catch2/catch.hpp>

#include "drop/term_text.hpp"
#include "support/models.hpp"

using namespace elgen;

namespace {

const LeafNames names{{{"e", "k"}, {"x", "y"}, {"x", "y"}, {"x", "y"}, {}, "t"}, true};

/// Of a system of two coordinates.
class Loss {
 public:
  Value parameter(std::uint32_t i) { return arithmetic_.leaf(Opcode::parameter, i); }
  Value coordinate(std::uint32_t i) { return arithmetic_.leaf(Opcode::coordinate, i); }
  Value time() { return arithmetic_.leaf(Opcode::time, 0); }
  Value product(const Value& x, const Value& y) { return arithmetic_.multiply(x, y); }

  DroppedParts parts = {};

  std::vector<std::string> of(OutputKind output) {
    std::vector<std::string> texts;
    Consequences consequences(arithmetic_, algebra_, 2, parts);
    for (const Value& entry : consequences.of(output)) {
      texts.push_back(term_text(algebra_, names, entry.value()));
    }
    return texts;
  }

 private:
  Algebra algebra_ = {};
  Arithmetic arithmetic_{algebra_};
};

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("a term of M_11") {
  Loss loss;
  const Value term = loss.product(loss.parameter(0), loss.coordinate(1));
  loss.parts[OutputKind::mass_matrix] = {term, Fraction{}, Fraction{}, Fraction{}};
  CHECK(loss.of(OutputKind::mass_matrix) == Texts{"e*y", "0", "0", "0"});
  CHECK(loss.of(OutputKind::coriolis_matrix) ==
        Texts{"0.5*e*dot(y)", "0.5*e*dot(x)", "-0.5*e*dot(x)", "0"});
  CHECK(loss.of(OutputKind::velocity_force) == Texts{"e*dot(x)*dot(y)", "-0.5*e*dot(x)^2"});
  CHECK(loss.of(OutputKind::momentum) == Texts{"e*y*dot(x)", "0"});
  CHECK(loss.of(OutputKind::position_gradient) == Texts{"0", "0.5*e*dot(x)^2"});
  CHECK(loss.of(OutputKind::kinetic_energy) == Texts{"0.5*e*y*dot(x)^2"});
  CHECK(loss.of(OutputKind::drift) == Texts{"0", "0"});
  CHECK(loss.of(OutputKind::gravity) == Texts{"0", "0"});
}

TEST_CASE("explicit time moves into the drift") {
  Loss loss;
  const Value term = loss.product(loss.parameter(0), loss.time());
  loss.parts[OutputKind::mass_matrix] = {Fraction{}, term, term, Fraction{}};
  CHECK(loss.of(OutputKind::drift) == Texts{"e*dot(y)", "e*dot(x)"});
}

TEST_CASE("a term of V0, and of forces") {
  Loss loss;
  const Value square = loss.product(loss.coordinate(0), loss.coordinate(0));
  loss.parts[OutputKind::potential_energy] = {loss.product(loss.parameter(1), square)};
  loss.parts[OutputKind::dissipation] = {loss.parameter(0), Fraction{}};
  loss.parts[OutputKind::applied_force] = {Fraction{}, loss.parameter(0)};
  CHECK(loss.of(OutputKind::gravity) == Texts{"2*k*x", "0"});
  CHECK(loss.of(OutputKind::position_gradient) == Texts{"-2*k*x", "0"});
  CHECK(loss.of(OutputKind::total_energy) == Texts{"k*x^2"});
  CHECK(loss.of(OutputKind::bias) == Texts{"e + 2*k*x", "-e"});
  CHECK(loss.of(OutputKind::inverse_dynamics) == Texts{"e + 2*k*x", "-e"});
  CHECK(loss.of(OutputKind::forward_dynamics).empty());
}
