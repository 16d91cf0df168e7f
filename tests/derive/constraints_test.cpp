// Equations with constraints, derived and solved by elimination, are compared on random systems
// with the oracle, which solves the whole system with pivoting. Derivatives of accelerations are
// compared with derivatives of written-out accelerations.
#include <catch2/catch.hpp>
#include <random>

#include "derive/outputs/outputs.hpp"
#include "derived.hpp"
#include "framed.hpp"
#include "model/requests.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using GiNaC::ex;

/// Texts of small random systems with constraints.
class ConstrainedText {
 public:
  explicit ConstrainedText(unsigned seed)
      : random_(seed), coordinates_(2 + draw(2)), equations_(1 + draw(coordinates_ - 1)) {}

  [[nodiscard]] std::string text() {
    std::string entries;
    std::string kinetic;
    for (std::size_t i = 0; i < coordinates_; ++i) {
      entries += "[[coordinate]]\nname = \"" + q(i) + "\"\n";
      kinetic += " + 1/2*J*dot(" + q(i) + ")^2";
    }
    entries += "[parameters]\nm = \"3/2\"\nJ = \"4/5\"\nw = 3\n";
    entries += "[energy]\nT = \"0" + kinetic + "\"\nV = \"" + expression() + "\"\n";
    for (const std::string point : {"P", "Q"}) {
      const std::string x = expression();
      const std::string y = expression();
      entries += "[[point]]\nname = \"" + point + "\"\nmass = \"m\"\nat = [\"" + x + "\", \"" + y +
                 "\"]\n";
    }
    entries += "[[input]]\nname = \"u\"\non = \"" + q(coordinates_ - 1) + "\"\n";
    for (std::size_t i = 0; i < equations_; ++i) entries += constraint(i);
    return model_text("constrained", entries);
  }

 private:
  [[nodiscard]] std::size_t draw(std::size_t count) { return random_() % count; }
  [[nodiscard]] static std::string q(std::size_t i) { return "q" + std::to_string(i + 1); }
  [[nodiscard]] std::string any() { return q(draw(coordinates_)); }
  [[nodiscard]] std::string number() { return std::to_string(1 + draw(7)) + "/5"; }

  /// A random expression. Its numbers are drawn in a fixed order, independent of the compiler.
  [[nodiscard]] std::string expression() {
    const std::string a = number();
    const std::string b = number();
    const std::string x = any();
    const std::string y = any();
    switch (draw(4)) {
      case 0:
        return a + "*" + x + " + " + b + "*" + x + "*" + y;
      case 1:
        return a + "*sin(" + x + " - " + b + "*" + y + ")";
      case 2:
        return a + "*" + x + "*cos(" + y + ")";
      default:
        return a + "*" + x + "^2 - " + b + "*" + y;
    }
  }

  /// A constraint on positions or velocities. The term 3 q(i) or 3 dot(q(i)) makes it independent
  /// of the other constraints.
  [[nodiscard]] std::string constraint(std::size_t i) {
    const std::string left = expression();
    const std::string right = expression();
    const std::string other = any();
    const std::string moving = draw(2) == 0 ? " + sin(t)" : "";
    std::string text = "[[constraint]]\nname = \"c" + std::to_string(i) + "\"\n";
    if (draw(3) > 0) {
      text += "equation = \"3*" + q(i) + " + " + left + " = " + right + moving + "\"\n";
    } else {
      text += "kind = \"velocity\"\nequation = \"3*dot(" + q(i) + ") = (" + left + ")*dot(" +
              other + ") + " + right + moving + "\"\n";
    }
    return draw(2) == 0 ? text : text + "stabilise = { omega = \"w\", zeta = 0.7 }\n";
  }

  std::mt19937 random_;
  std::size_t coordinates_;
  std::size_t equations_;
};

/// Compares the output `name` with the oracle, in all fields except `diagonal`.
void check_against_oracle(const CheckedModel& checked, const std::string& name) {
  const OutputRequest request = *find_request(checked.model, name);
  const Lagrangian lagrangian = *specialise(*formulate(checked.model), checked);
  const Result<EquationsOfMotion> equations = derive(lagrangian, {request}, {});
  REQUIRE(equations);
  const State state = some_state(checked);
  const OracleValues expected = oracle_values(checked.model, request, state);
  REQUIRE(expected);
  const NumbersAt at(equations->symbols, equations->definitions, state);
  Reals derived;
  for (const FieldEquations& field : equations->outputs.front().fields) {
    if (field.name == "diagonal") continue;
    const Reals entries = at(field.entries);
    derived.insert(derived.end(), entries.begin(), entries.end());
  }
  INFO(name);
  CHECK(derived.size() == expected->size());
  CHECK(nearly_equal(derived, *expected, 35));
}

constexpr const char* rod_text = R"toml(
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
m = 2
l = 3
g = 5
[[point]]
name = "bob"
at = ["x", "y"]
mass = "m"
[gravity]
vector = ["0", "-g"]
[[input]]
name = "u"
on = "x"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = l^2"
stabilise = { omega = 7, zeta = "3/5" }
)toml";

/// Accelerations and multipliers of a constrained motion, with definitions written out.
struct WrittenMotion {
  explicit WrittenMotion(const std::string& text) : system(text) {
    const ForwardDynamics motion = forward_dynamics(system.derivation);
    for (const ex& a : motion.acceleration) acceleration.push_back(write_out(a));
    for (const ex& lambda : motion.multipliers) multipliers.push_back(write_out(lambda));
  }

  [[nodiscard]] ex write_out(const ex& value) const {
    return written_out(system.derivation.definitions, value);
  }

  Derived system;
  RealVector acceleration = {};
  RealVector multipliers = {};
};

}  // namespace

TEST_CASE("elimination agrees with pivoting on random systems") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const std::string text = ConstrainedText(seed).text();
    INFO(text);
    const CheckedModel checked = checked_model(text);
    for (const char* name : {"constraint_residual", "constraint_jacobian", "constraint_bias",
                             "forward_dynamics", "projected", "constrained_inverse_dynamics"}) {
      check_against_oracle(checked, name);
    }
    if (seed % 3 == 0) check_against_oracle(checked, "linearization");
  }
}

TEST_CASE("a mass on a rod moves as derived by hand") {
  const WrittenMotion motion(model_text("rod", rod_text));
  const Symbols& s = motion.system.source.symbols;
  const ex& x = s.q[0];
  const ex& y = s.q[1];
  const ex& m = s.parameters[0];
  const ex square = x * x + y * y;
  const ex f = square - s.parameters[1] * s.parameters[1];
  const ex rate = 2 * (x * s.v[0] + y * s.v[1]);
  // A M^-1 A^T lambda = -(dA/dt) v - 2 zeta omega df/dt - omega^2 f - A M^-1 F with A = (2 x, 2 y)
  // and F = (u, -m g)
  const ex bias = 2 * (s.v[0] * s.v[0] + s.v[1] * s.v[1]) + GiNaC::numeric(42, 5) * rate + 49 * f;
  const ex free = 2 * x * s.u[0] / m - 2 * y * s.parameters[2];
  const ex lambda = -m * (bias + free) / (4 * square);
  CHECK(motion.system.agree(motion.multipliers[0], lambda));
  CHECK(motion.system.agree(motion.acceleration[0], (s.u[0] + 2 * x * lambda) / m));
  CHECK(motion.system.agree(motion.acceleration[1], 2 * y * lambda / m - s.parameters[2]));
}

TEST_CASE("derivatives agree with derivatives of the written-out accelerations and multipliers") {
  WrittenMotion motion(model_text("rod", rod_text));
  const Symbols& s = motion.system.source.symbols;
  const ForwardDerivatives derived = forward_dynamics_derivatives(motion.system.derivation);
  for (std::size_t i = 0; i < 2; ++i) {
    const ex& a = motion.acceleration[i];
    for (std::size_t j = 0; j < 2; ++j) {
      INFO("acceleration " << i << " by " << j);
      CHECK(
          motion.system.agree(derived.by_position[2 * i + j], Textbook::derivative_by(a, s.q[j])));
      CHECK(
          motion.system.agree(derived.by_velocity[2 * i + j], Textbook::derivative_by(a, s.v[j])));
    }
    CHECK(motion.system.agree(derived.by_input[i], Textbook::derivative_by(a, s.u[0])));
  }
  // Without d(A^T lambda)/dq = 2 lambda, da_x/dx would lack the term `forgotten`.
  const ex across = s.q[1] * s.q[1] / (s.q[0] * s.q[0] + s.q[1] * s.q[1]);
  const ex forgotten = 2 * motion.multipliers[0] * across / s.parameters[0];
  CHECK_FALSE(motion.system.agree(derived.by_position[0] - forgotten,
                                  Textbook::derivative_by(motion.acceleration[0], s.q[0])));
}
