// Models with constraints: correct programs pass every row, changed signs in the terms of
// constraints are found, and conserved quantities are sampled at states that satisfy the
// constraints.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "choose/finish.hpp"
#include "elgen/certificate.hpp"
#include "elgen/equations_of_motion.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "support/models.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/structure/expectations.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

constexpr const char* all_outputs =
    "mass_matrix,bias,input_matrix,inverse_dynamics,forward_dynamics,energy_function,momentum,"
    "linearization,forward_dynamics_derivatives,constraint_residual,constraint_jacobian,"
    "constraint_bias,projected,constrained_inverse_dynamics";

/// The model and its derived outputs; `diagonal_field` is removed, as programs do not store it.
System constrained(const std::string& model, const std::string& outputs = all_outputs) {
  SceneOptions options;
  options.outputs = {make_source("--outputs", outputs)};
  const CheckedModel checked = checked_model(model, options);
  const Result<UnreducedLagrangian> lagrangian = formulate(checked.model);
  const auto equations = derive(*lagrangian, checked.scene.outputs, {});
  System system{checked.model, checked.scene, *lower(*equations, checked.scene.outputs, {})};
  for (Function& function : system.program.functions) {
    function = without_diagonal(std::move(function));
  }
  return system;
}

/// A mass on a rod, in x and y, pushed along x.
std::string bob(const std::string& rest = {}) {
  return model_text("bob", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
m = 2
l = 0.8
g = 9.81
w = 3
[[point]]
name = "bob"
at = ["x", "y"]
mass = "m"
[gravity]
vector = ["0", "-g"]
[[input]]
name = "push"
on = "x"
[[constraint]]
name = "rod"
equation = "x^2 + y^2 = l^2"
stabilise = { omega = "w", zeta = 0.7 }
)toml" + rest);
}

/// A disc that rolls upright.
std::string rolling() {
  return model_text("rolling", R"toml([[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[[coordinate]]
name = "phi"
[[coordinate]]
name = "psi"
[parameters]
m = 2
R = 0.3
Ia = 0.09
J = 0.05
[energy]
T = "m*(dot(x)^2 + dot(y)^2)/2 + Ia*dot(phi)^2/2 + J*dot(psi)^2/2"
[[input]]
name = "tau"
on = "phi"
[[input]]
name = "steer"
on = "psi"
[[constraint]]
name = "roll"
kind = "velocity"
equation = ["dot(x) = R*cos(psi)*dot(phi)", "dot(y) = R*sin(psi)*dot(phi)"]
stabilise = { omega = 2, zeta = 1 }
)toml");
}

/// Crank, coupler and rocker between two pivots.
std::string linkage() {
  return model_text("linkage", R"toml([[coordinate]]
name = "a"
[[coordinate]]
name = "b"
[[coordinate]]
name = "c"
[parameters]
k = 1.5
m = 2
g = 9.81
[[body]]
name = "crank"
mass = "m"
com = ["cos(a)/2", "sin(a)/2"]
spin = "dot(a)"
inertia = "m/12"
[[body]]
name = "coupler"
mass = "m"
com = ["cos(a) + cos(b)", "sin(a) + sin(b)"]
spin = "dot(b)"
inertia = "m/3"
[[body]]
name = "rocker"
mass = "m"
com = ["k + cos(c)", "sin(c)"]
spin = "dot(c)"
inertia = "m/3"
[[point]]
name = "P"
at = ["cos(a) + 2*cos(b)", "sin(a) + 2*sin(b)"]
[[point]]
name = "Q"
at = ["k + 2*cos(c)", "2*sin(c)"]
[gravity]
vector = ["0", "-g"]
[[input]]
name = "motor"
on = "a"
[[constraint]]
name = "pin"
coincide = ["P", "Q"]
)toml");
}

/// The certificate with extreme states. If `quick`, one projection of a field replaces its entries.
Certificate certificate_of(const System& system, std::size_t samples, bool quick = true) {
  const VerifyOptions options{.samples = samples, .is_quick = quick};
  return verify(system.model, system.scene, system.program, {}, options).certificate;
}

const CertificateRow& checked_row(const Certificate& certificate, const std::string& check,
                                  const std::string& subject) {
  for (const CertificateRow& row : certificate.rows) {
    if (row.check == check && row.subject == subject) return row;
  }
  FAIL("no row " << check << " of " << subject);
  return certificate.rows.front();
}

/// Checks that no row fails, and that the most important rows have states.
void check_holds_under_constraints(const Certificate& certificate) {
  for (const CertificateRow& row : certificate.rows) {
    INFO(certificate.model << ", " << row.check << " of " << row.subject << ": " << row.worst_value
                           << " at " << row.worst_state);
    CHECK(row.verdict != Verdict::fails);
  }
  for (const char* field :
       {"forward_dynamics.acceleration", "forward_dynamics.relative_pivots", "linearization.A",
        "projected.coordinates", "projected.rates", "constrained_inverse_dynamics.inputs",
        "constrained_inverse_dynamics.unbalanced"}) {
    INFO(certificate.model << ", " << field);
    const auto subject = std::string(field) + " (double)";
    CHECK(checked_row(certificate, "program vs oracle", subject).samples > 0);
  }
  CHECK(checked_row(certificate, "constraints along the motion", "forward_dynamics").samples > 0);
}

/// The system with the signs of a field changed.
System with_changed_signs(System system, OutputKind kind, const std::string& name) {
  for (Function& function : system.program.functions) {
    if (function.kind != kind) continue;
    for (Field& field : function.fields) {
      if (field.name != name) continue;
      for (std::uint32_t& entry : field.entries) {
        function.instructions.push_back({.opcode = Opcode::negate, .a = entry});
        entry = static_cast<std::uint32_t>(function.instructions.size() - 1);
      }
    }
    function.names.resize(function.instructions.size());
  }
  return system;
}

}  // namespace

TEST_CASE("correct programs with constraints pass, at ordinary and extreme states") {
  for (const std::string& model : {bob(), rolling(), linkage()}) {
    const System system = constrained(model);
    check_holds_under_constraints(certificate_of(system, 8));
    CHECK(self_check(system.model, system.scene, system.program).failure.empty());
  }
  check_holds_under_constraints(certificate_of(constrained(bob()), 4, false));
}

TEST_CASE("multipliers with the wrong sign are found by every row that contains them") {
  for (const std::string& model : {bob(), rolling(), linkage()}) {
    const System wrong =
        with_changed_signs(constrained(model), OutputKind::forward_dynamics, "multipliers");
    const Certificate certificate = certificate_of(wrong, 2);
    INFO(certificate.model);
    const auto verdict = [&](const std::string& check, const std::string& subject) {
      return checked_row(certificate, check, subject).verdict;
    };
    CHECK(verdict("power balance", "energy_function") == Verdict::fails);
    CHECK(verdict("inverse of forward dynamics", "forward_dynamics") == Verdict::fails);
    CHECK(verdict("constraints along the motion", "forward_dynamics") == Verdict::holds);
    CHECK(verdict("program vs oracle", "forward_dynamics.multipliers (double)") == Verdict::fails);
    const SelfCheck check = self_check(wrong.model, wrong.scene, wrong.program);
    CHECK(mentions(check.failure, "w.x of multipliers is "));
  }
}

TEST_CASE("a mistake in any part of a constraint's equations is found") {
  const System right = constrained(bob());
  for (const auto& [kind, field] :
       {std::pair(OutputKind::forward_dynamics, "acceleration"),
        std::pair(OutputKind::constraint_jacobian, ""), std::pair(OutputKind::constraint_bias, ""),
        std::pair(OutputKind::constraint_residual, "position"),
        std::pair(OutputKind::constraint_residual, "rate")}) {
    INFO(field);
    const Certificate certificate = certificate_of(with_changed_signs(right, kind, field), 2);
    const auto& row = checked_row(certificate, "constraints along the motion", "forward_dynamics");
    CHECK(row.verdict == Verdict::fails);
  }
}

TEST_CASE("every field of the constrained dynamics is compared by projections") {
  const System right = constrained(linkage());
  for (const auto& [kind, field] :
       {std::pair(OutputKind::forward_dynamics, "acceleration"),
        std::pair(OutputKind::forward_dynamics, "relative_pivots"),
        std::pair(OutputKind::linearization, "A"), std::pair(OutputKind::linearization, "B"),
        std::pair(OutputKind::forward_dynamics_derivatives, "by_position"),
        std::pair(OutputKind::forward_dynamics_derivatives, "by_velocity"),
        std::pair(OutputKind::forward_dynamics_derivatives, "by_input"),
        std::pair(OutputKind::projected, "coordinates"), std::pair(OutputKind::projected, "rates"),
        std::pair(OutputKind::constrained_inverse_dynamics, "inputs"),
        std::pair(OutputKind::constrained_inverse_dynamics, "multipliers")}) {
    INFO(field);
    const System wrong = with_changed_signs(right, kind, field);
    const SelfCheck check = self_check(wrong.model, wrong.scene, wrong.program);
    CHECK(mentions(check.failure, std::string(" of ") + field + " is "));
  }
}

TEST_CASE("formulas with terms of constraints state them") {
  const Certificate certificate = certificate_of(constrained(bob()), 2);
  CHECK(checked_row(certificate, "power balance", "energy_function").formula ==
        "dE/dt = v.(B u + Q - dD/dv + A^T lambda) - dL/dt");
  CHECK(checked_row(certificate, "inverse of forward dynamics", "forward_dynamics").formula ==
        "tau(q, v, a(q, v, u)) = B u + A^T lambda");
}

TEST_CASE("a field is found by its name if other fields of the output are absent") {
  const System system = constrained(rolling());
  const auto places = field_places(system.subject());
  const auto residual = std::ranges::find_if(places, [](const ComparedField& place) {
    return place.function->kind == OutputKind::constraint_residual;
  });
  REQUIRE(residual != places.end());
  CHECK(residual->field().name == "rate");
  CHECK(residual->field_index == 0);
  CHECK(residual->request_field_index == 1);
  CHECK(residual->first_oracle_entry == 0);
}

TEST_CASE("conserved quantities of constrained models are sampled on the constraints") {
  const auto row_of_conserved = [](const std::string& quantity) {
    const System system =
        constrained(bob("[[expect]]\nconserved = [\"" + quantity + "\"]\n"), "mass_matrix");
    return check_expectations(system.subject(), nullptr, 1).rows.at(0);
  };
  const CertificateRow energy = row_of_conserved("m*(dot(x)^2 + dot(y)^2)/2 + m*g*y");
  INFO(energy.worst_value);
  CHECK(energy.verdict == Verdict::holds);
  CHECK(energy.samples > 0);
  CHECK(row_of_conserved("x^2 + y^2").verdict == Verdict::holds);
  CHECK(row_of_conserved("x*dot(y) - y*dot(x)").verdict == Verdict::fails);
}
