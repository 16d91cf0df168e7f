// [[expect]]: correct closed forms pass, wrong ones are reported with a state where they differ.
#include "verify/structure/expectations.hpp"

#include <catch2/catch.hpp>

#include "elgen/equations_of_motion.hpp"
#include "elgen/lagrangian.hpp"
#include "elgen/lower.hpp"
#include "support/models.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The model of `builder` with one expectation, and with a span for each entry.
System expecting(ModelBuilder builder, const std::string& output, std::uint32_t columns,
                 const std::vector<std::string>& entries) {
  Expectation expectation;
  expectation.output = output;
  expectation.columns = columns;
  expectation.rows = static_cast<std::uint32_t>(entries.size()) / columns;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    expectation.entries.push_back(builder.expression(entries[i]));
    expectation.spans.push_back({nullptr, 10 * i, 10 * i + 1});
  }
  builder.model.expectations.push_back(expectation);
  return system_of(builder.model, "");
}

ExpectationReport report_of(const System& system) {
  return check_expectations(system.subject(), nullptr, 1);
}

void check_holds(const System& system) {
  const ExpectationReport report = report_of(system);
  CHECK(report.diagnostics.empty());
  CHECK_FALSE(report.rows.empty());
  for (const CertificateRow& row : report.rows) {
    INFO(row.subject << ": " << row.worst_value);
    CHECK(row.verdict == Verdict::holds);
    CHECK(row.samples == 64);
    CHECK(mentions(row.tolerance, "sampled, no proof"));
  }
}

const std::string on_a_rod = R"toml(["l*sin(theta)", "-l*cos(theta)"])toml";
const std::string on_an_arc = R"toml(["l*(1 - cos(theta))/theta", "-l*sin(theta)/theta"])toml";
const std::string on_an_arc_by_names = R"toml(["l*theta*cosc(theta)", "-l*sinc(theta)"])toml";

/// A derived pendulum with one expectation.
struct DerivedPendulum {
  explicit DerivedPendulum(const std::string& expect, const std::string& bob = on_a_rod)
      : checked(checked_model(model_text("pendulum", R"toml([[coordinate]]
name = "theta"
[parameters]
m = 2
l = 3
g = 9.81
[[point]]
name = "bob"
mass = "m"
at = )toml" + bob + R"toml(
[gravity]
vector = ["0", "-g"]
[[expect]]
)toml" + expect))) {
    const auto lagrangian = formulate(checked.model);
    const auto equations = derive(*lagrangian, checked.scene.outputs, {});
    program = *lower(*equations, checked.scene.outputs, {});
    forms = present(program);
  }

  [[nodiscard]] Evidence evidence(bool has_forms = true) {
    const SystemUnderTest subject{checked.model, checked.scene, program};
    return check_expectations(subject, has_forms ? &forms : nullptr, 1).rows.front().evidence;
  }

  /// The hint for the first wrong entry, "" if there is none.
  [[nodiscard]] std::string hint() {
    const SystemUnderTest subject{checked.model, checked.scene, program};
    const Diagnostics found = check_expectations(subject, &forms, 1).diagnostics;
    return found.empty() ? "" : found.front().hint;
  }

  CheckedModel checked;
  Program program = {};
  ClosedForms forms = {};
};

}  // namespace

TEST_CASE("correct closed forms pass, zeros too") {
  check_holds(
      expecting(cart_pole(), "mass_matrix", 2, {"M + m", "m*l*cos(th)", "m*l*cos(th)", "m*l^2"}));
  check_holds(expecting(cart_pole(), "velocity_force", 1, {"-m*l*sin(th)*th_d^2", "0"}));
  check_holds(expecting(cart_pole(), "input_matrix", 1, {"1", "0"}));
  check_holds(expecting(pendulum(), "velocity_force", 1, {"0"}));
  check_holds(expecting(pendulum(), "forward_dynamics", 1, {"-g/l*sin(th)"}));
}

TEST_CASE("a wrong entry is reported, with both values and their difference") {
  const auto report = report_of(
      expecting(cart_pole(), "mass_matrix", 2, {"M + m", "m*l*cos(th)", "m*l*sin(th)", "m*l^2"}));
  REQUIRE(report.diagnostics.size() == 1);
  const Diagnostic& diagnostic = report.diagnostics.front();
  CHECK(diagnostic.code == Code::E510);
  CHECK(diagnostic.span.begin == 20);
  CHECK(diagnostic.message.find("mass_matrix[2,1] is ") == 0);
  CHECK(mentions(diagnostic.message, " as derived, "));
  CHECK(mentions(diagnostic.message, "q = ("));
  CHECK(report.rows[2].verdict == Verdict::fails);
  CHECK(report.rows[3].verdict == Verdict::holds);
}

TEST_CASE("a difference in the fortieth digit is found") {
  const auto report = report_of(expecting(pendulum(), "mass_matrix", 1, {"m*l^2*(1 + 1e-40)"}));
  CHECK(report.diagnostics.size() == 1);
}

TEST_CASE("parameters are varied, so a form that is correct only for their values fails") {
  // m = 2, l = 3/4
  CHECK(report_of(expecting(pendulum(), "mass_matrix", 1, {"9/8"})).diagnostics.size() == 1);
}

TEST_CASE("the energy is conserved, the angle is not") {
  check_holds(expecting(pendulum(), "conserved", 1, {"m*l^2*th_d^2/2 - m*g*l*cos(th)"}));
  check_holds(expecting(cart_pole(), "conserved", 1, {"(M + m)*x_d + m*l*cos(th)*th_d"}));
  const auto report = report_of(expecting(pendulum(), "conserved", 1, {"th"}));
  REQUIRE(report.diagnostics.size() == 1);
  CHECK(report.diagnostics.front().code == Code::E510);
  CHECK(report.diagnostics.front().message.find("its rate is ") == 0);
}

TEST_CASE("a rate is taken along a free motion, also if an output is called conserved") {
  System system = expecting(pendulum(), "conserved", 1, {"m*l^2*th_d^2/2 - m*g*l*cos(th)"});
  system.model.outputs.push_back(
      {.name = "conserved", .values = {system.model.expectations[0].entries[0]}});
  check_holds(system);
}

TEST_CASE("declared damping makes conservation fail") {
  ModelBuilder builder = pendulum();
  builder.D("th_d^2/2");
  const auto report =
      report_of(expecting(builder, "conserved", 1, {"m*l^2*th_d^2/2 - m*g*l*cos(th)"}));
  CHECK(report.diagnostics.size() == 1);
}

TEST_CASE("E and momenta are the values along the motion") {
  check_holds(expecting(pendulum(), "conserved", 1, {"E"}));
  check_holds(expecting(cart_pole(), "conserved", 1, {"x_p", "E", "E^2 - g*x_p"}));
  CHECK(report_of(expecting(pendulum(), "conserved", 1, {"th_p"})).diagnostics.size() == 1);
  ModelBuilder damped = pendulum();
  damped.D("th_d^2/2");
  CHECK(report_of(expecting(damped, "conserved", 1, {"E"})).diagnostics.size() == 1);
}

TEST_CASE("in a rotating field E - w p of the angle is conserved, and neither E nor p alone") {
  ModelBuilder builder;
  builder.coordinate("r").coordinate("phi", "rad").parameter("m", "2").parameter("k", "5");
  builder.parameter("w", "0.7").T("m*(r_d^2 + r^2*phi_d^2)/2").V("k*(r*cos(phi - w*t))^2/2");
  check_holds(expecting(builder, "conserved", 1, {"E - w*phi_p"}));
  CHECK(report_of(expecting(builder, "conserved", 1, {"E", "phi_p"})).diagnostics.size() == 2);
}

TEST_CASE("a form that is undefined everywhere fails") {
  const auto report = report_of(expecting(pendulum(), "mass_matrix", 1, {"sqrt(-1 - th^2)"}));
  CHECK(report.rows.front().verdict == Verdict::fails);
  CHECK(report.rows.front().skipped == std::vector<SkippedStates>{{SkipReason::undefined, 64}});
  REQUIRE(report.diagnostics.size() == 1);
  CHECK(report.diagnostics.front().code == Code::E510);
  CHECK(report.diagnostics.front().message ==
        "this form of mass_matrix and the derived one have no value in common at 64 points");
  const auto rate = report_of(expecting(pendulum(), "conserved", 1, {"sqrt(-1 - th^2)"}));
  CHECK(rate.rows.front().verdict == Verdict::fails);
  CHECK(rate.diagnostics.size() == 1);
}

TEST_CASE("states lie in the declared ranges where the model has values") {
  ModelBuilder builder = pendulum();
  builder.V("(th - 5)^(3/2)");
  CHECK(
      report_of(expecting(builder, "potential_energy", 1, {"(th - 5)^(3/2)"})).diagnostics.size() ==
      1);
  builder.model.coordinates[0].range = Interval{6, 9};
  check_holds(expecting(builder, "potential_energy", 1, {"(th - 5)*sqrt(th - 5) - m*g*l*cos(th)"}));
}

TEST_CASE("both sides of a kink are sampled, and a side without states is named") {
  ModelBuilder builder = cart_pole();
  builder.force_on(0, "-max(x - 300, 0)");
  CHECK(report_of(expecting(builder, "applied_force", 1, {"0", "0"})).diagnostics.size() == 1);
  builder.model.coordinates[0].range = Interval{-1, 1};
  const auto report = report_of(expecting(builder, "applied_force", 1, {"0", "0"}));
  CHECK(report.diagnostics.empty());
  CHECK(mentions(report.rows.front().tolerance, "; sampled on one side only: `"));
}

TEST_CASE("an equal form that is written differently is proved, a wrong one is not") {
  for (const auto& [expect, evidence] :
       {std::pair{"gravity = [\"m*g*l*sin(theta)\"]\n", Evidence::proof},
        std::pair{"gravity = [\"2*m*g*l*sin(theta/2)*cos(theta/2)\"]\n", Evidence::proof},
        std::pair{"mass_matrix = [[\"m*l^2*(sin(theta)^2 + cos(theta)^2)\"]]\n", Evidence::proof},
        std::pair{"forward_dynamics = [\"-g/l*sin(theta)\"]\n", Evidence::proof},
        std::pair{"conserved = [\"1/2*m*l^2*dot(theta)^2 - m*g*l*cos(theta)\"]\n", Evidence::proof},
        std::pair{"conserved = [\"E\"]\n", Evidence::proof},
        std::pair{"conserved = [\"2*m*energy_function - m\"]\n", Evidence::proof},
        std::pair{"conserved = [\"p(theta)^2/(2*m*l^2) - m*g*l*cos(theta)\"]\n", Evidence::proof},
        std::pair{"conserved = [\"p(theta)\"]\n", Evidence::states},
        std::pair{"gravity = [\"m*g*l*cos(theta)\"]\n", Evidence::states},
        std::pair{"conserved = [\"m*l^2*dot(theta)\"]\n", Evidence::states}}) {
    INFO(expect);
    CHECK(DerivedPendulum(expect).evidence() == evidence);
  }
}

TEST_CASE("Stumpff functions are proved equal to quotients, wrong quotients are not") {
  for (const std::string& bob : {on_an_arc, on_an_arc_by_names}) {
    for (const auto& [expect, evidence] :
         {std::pair{"mass_matrix = [[\"m*l^2*(2 + theta^2 - 2*cos(theta) - "
                    "2*theta*sin(theta))/theta^4\"]]\n",
                    Evidence::proof},
          std::pair{"gravity = [\"m*g*l*(sin(theta)/theta - cos(theta))/theta\"]\n",
                    Evidence::proof},
          std::pair{"gravity = [\"m*g*l*theta*(cosc(theta) - stumpff(theta, 3))\"]\n",
                    Evidence::proof},
          std::pair{"conserved = [\"E\"]\n", Evidence::proof},
          std::pair{"gravity = [\"m*g*l*(sin(theta)/theta + cos(theta))/theta\"]\n",
                    Evidence::states}}) {
      INFO(bob << expect);
      CHECK(DerivedPendulum(expect, bob).evidence() == evidence);
    }
  }
}

TEST_CASE("quotients of exponentials are proved, wrong ones are not") {
  for (const auto& [expect, evidence] :
       {std::pair{"gravity = [\"m*g*l*sin(theta)*exp(theta)*exp(-theta)\"]\n", Evidence::proof},
        std::pair{"conserved = [\"E*tanh(theta)*(1 + exp(-2*theta))/(1 - exp(-2*theta))\"]\n",
                  Evidence::proof},
        std::pair{"gravity = [\"m*g*l*sin(theta)*exp(theta)*exp(-theta/2)\"]\n", Evidence::states},
        std::pair{"conserved = [\"E*tanh(theta)*(1 + exp(-2*theta))/(1 - exp(-3*theta))\"]\n",
                  Evidence::states}}) {
    INFO(expect);
    CHECK(DerivedPendulum(expect).evidence() == evidence);
  }
}

TEST_CASE("nothing is proved without closed forms, or if an entry depends on a sampled zero") {
  for (const char* expect : {"forward_dynamics = [\"-g/l*sin(theta)\"]\n", "conserved = [\"E\"]\n",
                             "conserved = [\"1/2*m*l^2*dot(theta)^2 - m*g*l*cos(theta)\"]\n"}) {
    INFO(expect);
    DerivedPendulum pendulum(expect);
    CHECK(pendulum.evidence() == Evidence::proof);
    CHECK(pendulum.evidence(false) == Evidence::states);
    for (Function& function : pendulum.program.functions) function.sampled_zeros = {0};
    CHECK(pendulum.evidence() == Evidence::states);
  }
}

TEST_CASE("for a wrong closed form the hint names the terms that differ") {
  for (const auto& [expect, words] :
       {std::pair{"gravity = [\"-m*g*l*sin(theta)\"]\n",
                  "the term m*g*l*sin(theta) has the opposite sign"},
        std::pair{"gravity = [\"m*g*l*sin(theta)/2\"]\n",
                  "the term m*g*l*sin(theta) has 1/2 of its factor"},
        std::pair{"gravity = [\"3*m*g*l*sin(theta)\"]\n",
                  "the term m*g*l*sin(theta) has 3 times its factor"},
        std::pair{"gravity = [\"m*g*l*cos(theta)\"]\n",
                  "m*g*l*cos(theta) replaces m*g*l*sin(theta)"},
        std::pair{"gravity = [\"m*g*l*sin(theta) + m*g*l^2\"]\n",
                  "the term m*g*l^2 is superfluous"},
        std::pair{"gravity = [\"0\"]\n", "the term m*g*l*sin(theta) is missing"},
        std::pair{"gravity = [\"m*g*l*sin(theta)\"]\n", ""},
        std::pair{
            "gravity = [\"2*g*l*sin(theta)\"]\n",
            "2*g*l*sin(theta) replaces m*g*l*sin(theta); it holds for the parameter values of "
            "the file"},
        std::pair{"conserved = [\"theta\"]\n", ""}}) {
    INFO(expect);
    CHECK(DerivedPendulum(expect).hint() == words);
  }
  const std::string hint =
      DerivedPendulum("gravity = [\"m*g*l*(sin(theta)/theta + cos(theta))/theta\"]\n", on_an_arc)
          .hint();
  CHECK_FALSE(hint.empty());
  CHECK_FALSE(mentions(hint, "stumpff"));
}

TEST_CASE("for a wrong equation the hint names the terms that differ from a multiple of its row") {
  const std::string row = "compared with row theta of the equations of motion";
  for (const auto& [equation, words] :
       {std::pair{"m*l^2*dot(dot(theta)) = m*g*l*sin(theta)",
                  row + ": the term m*g*l*sin(theta) has the opposite sign"},
        std::pair{"m*l^2*dot(dot(theta)) = 0", row + ": the term m*g*l*sin(theta) is missing"},
        std::pair{"m*dot(dot(theta)) + m*g*l*sin(theta) = 0",
                  std::string("m*g*l*sin(theta) replaces ")},
        std::pair{"-l*dot(dot(theta)) = g*sin(theta)", std::string()}}) {
    INFO(equation);
    const std::string expect = std::string("equations = [\"") + equation + "\"]\n";
    const std::string hint = DerivedPendulum(expect).hint();
    CHECK(mentions(hint, words));
    CHECK(hint.empty() == words.empty());
  }
}
