// elgen verify with [[expect]]: equations as students write them, and numbers at a state.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "cli/stated_testing.hpp"

namespace elgen::test {
namespace {

Outcome verify_with(const std::string& model, const std::string& keys,
                    const std::string& options = "-q") {
  return run_with(model, keys, "verify --quick " + options);
}

struct StudentEquations {
  std::string model;
  std::string keys;
  std::vector<std::string> words;  ///< expected words in the report; empty: the equations are right
};

const std::string cart_row =
    "\"(M + m)*dot(dot(x)) + m*l*cos(theta)*dot(dot(theta)) - m*l*sin(theta)*dot(theta)^2 = u\"";

/// Ten answers of students, four of them wrong.
const std::vector<StudentEquations> students{
    {"simple_pendulum", "equations = \"m*l^2*dot(dot(theta)) + m*g*l*sin(theta) = 0\"\n", {}},
    {"simple_pendulum", "equations = \"-g*sin(theta)/l = dot(dot(theta))\"\n", {}},
    {"simple_pendulum", "equations = \"dot(m*l^2*dot(theta)) = -m*g*l*sin(theta)\"\n", {}},
    {"simple_pendulum",
     "equations = \"l*dot(dot(theta)) = g*sin(theta)\"\n",
     {"row theta of the equations of motion", "the term g*sin(theta) has the opposite sign"}},
    {"cart_pole", "equations = [" + cart_row + ", " + pole_row + "]\n", {}},
    {"cart_pole",
     "equations = [\"dot(dot(x)) = (u + m*sin(theta)*(l*dot(theta)^2 - g*cos(theta)))"
     "/(M + m*sin(theta)^2)\", \"dot(dot(theta)) = ((M + m)*g*sin(theta) - cos(theta)*(u + "
     "m*l*dot(theta)^2*sin(theta)))/(l*(M + m*sin(theta)^2))\"]\n",
     {}},
    {"cart_pole",
     "equations = [\"(M + m)*dot(dot(x)) + m*l*cos(theta)*dot(dot(theta)) = u\", " + pole_row +
         "]\n",
     {"row x of the equations of motion", "sin(theta) is missing"}},
    {"cart_pole",
     "equations = [" + cart_row +
         ", \"l*dot(dot(theta)) + cos(theta)*dot(dot(x)) = g*cos(theta)\"]\n",
     {"row theta", "g*cos(theta) replaces -g*sin(theta)"}},
    {"rotating_hoop",
     "equations = \"R*dot(dot(theta)) = (R*Omega^2*cos(theta) - g)*sin(theta)\"\n",
     {}},
    {"rotating_hoop",
     "equations = \"dot(dot(theta)) + g/R*sin(theta) - 1/2*Omega^2*sin(theta)*cos(theta) = 0\"\n",
     {"row theta", "Omega^2", "has 1/2 of its factor"}},
};

}  // namespace

TEST_CASE("verify: equations of students are right in any form, or wrong with an explanation") {
  for (const StudentEquations& student : students) {
    const Outcome judged = verify_with(student.model, student.keys);
    INFO(student.keys << judged.output << judged.errors);
    CHECK(judged.status == (student.words.empty() ? 0 : 1));
    CHECK(mentions(judged.errors, "[E510]") == !student.words.empty());
    for (const std::string& words : student.words) CHECK(mentions(judged.errors, words));
  }
}

TEST_CASE("verify: an equation solved for an acceleration is compared with the accelerations") {
  const Outcome judged =
      verify_with("cart_pole",
                  "equations = [\"dot(dot(x)) = (u + m*sin(theta)*(l*dot(theta)^2 + g*cos(theta)))"
                  "/(M + m*sin(theta)^2)\", " +
                      pole_row + "]\n");
  INFO(judged.errors);
  CHECK(judged.status == 1);
  CHECK(mentions(judged.errors, "compared with the accelerations of the motion: the term "));
  CHECK(mentions(judged.errors, "has the opposite sign"));
}

/// Two pulleys and three masses. The second equation is an acceleration with the term 4*M*m2 in the
/// denominator; a test replaces this term by 2*M*m2.
const std::string three_masses = R"toml(format = 1
[model]
name = "three_masses"
[[coordinate]]
name = "l1"
unit = "m"
[[coordinate]]
name = "l2"
unit = "m"
[parameters]
m1 = { value = 3, unit = "kg" }
m2 = { value = 1, unit = "kg" }
M = { value = 2, unit = "kg" }
g = { value = 9.81, unit = "m/s^2" }
[energy]
T = "1/2*m1*dot(l1)^2 + 1/2*m2*(dot(l2) - dot(l1))^2 + 1/2*M*(dot(l1) + dot(l2))^2"
V = "-m1*g*l1 - m2*g*(l2 - l1) + M*g*(l1 + l2)"
[[expect]]
equations = ["(m1 - m2 - M)*g = (m1 + m2 + M)*dot(dot(l1)) + (M - m2)*dot(dot(l2))",
             "dot(dot(l2)) = )toml";

Outcome verify_masses(const std::string& acceleration) {
  const Workspace workspace;
  workspace.write("model.toml", three_masses + acceleration + "\"]\n");
  return workspace.run("elgen verify --quick -q model.toml");
}

TEST_CASE("verify: numerators and denominators of stated accelerations are compared separately") {
  CHECK(verify_masses("2*m1*(m2 - M)*g/(m1*M + m1*m2 + 4*M*m2)").status == 0);
  const Outcome below = verify_masses("2*m1*(m2 - M)*g/(m1*M + m1*m2 + 2*M*m2)");
  INFO(below.errors);
  CHECK(below.status == 1);
  CHECK(mentions(below.errors,
                 "compared with the accelerations of the motion: in the denominator "
                 "the term 4*"));
  CHECK(mentions(below.errors, "has 1/2 of its factor"));
  const Outcome above = verify_masses("2*m1*(m2 + M)*g/(m1*M + m1*m2 + 4*M*m2)");
  INFO(above.errors);
  CHECK(mentions(above.errors, "has the opposite sign"));
  CHECK_FALSE(mentions(above.errors, "denominator"));
  // Numerator and denominator both differ: no term is named.
  const Outcome both = verify_masses("m1*(3*m2 - M)*g/(m1*M + m1*m2 + 2*M*m2)");
  INFO(both.errors);
  CHECK(both.status == 1);
  CHECK_FALSE(mentions(both.errors, "the term"));
}

TEST_CASE("verify: a square of an equation determines no acceleration") {
  const auto judged = [](const std::string& equation) {
    return verify_with("simple_pendulum", "equations = \"" + equation + "\"\n");
  };
  const Outcome square = judged("dot(dot(theta))^2 = (g/l*sin(theta))^2");
  INFO(square.errors);
  CHECK(square.status == 2);
  CHECK(mentions(square.errors, "[E540]: a = ("));
  CHECK(mentions(square.errors, ") meets all equations, too, so the accelerations are not"));
  const Outcome kinked = judged("abs(dot(dot(theta))) = abs(g/l*sin(theta))");
  INFO(kinked.errors);
  CHECK(kinked.status == 2);
  CHECK(mentions(kinked.errors, "[E540]: "));
  CHECK(judged("exp(l*dot(dot(theta))/g) = exp(-sin(theta))").status == 0);
  const std::string row = "(l*dot(dot(theta)) + cos(theta)*dot(dot(x)))";
  for (const std::string& equation :
       {row + "^2 = (g*sin(theta))^2", row + "^4 = (g*sin(theta))^4"}) {
    INFO(equation);
    CHECK(
        verify_with("cart_pole", "equations = [" + cart_row + ", \"" + equation + "\"]\n").status ==
        2);
  }
  const std::string cubed = "\"" + row + "^3 = (g*sin(theta))^3\"";
  CHECK(verify_with("cart_pole", "equations = [" + cart_row + ", " + cubed + "]\n").status == 0);
  const Outcome other_sign = judged("dot(dot(theta)) = g/l*sin(theta)");
  INFO(other_sign.errors);
  CHECK(other_sign.status == 1);
  CHECK(mentions(other_sign.errors, "has the opposite sign"));
  CHECK_FALSE(mentions(other_sign.errors, "E540"));
}

TEST_CASE("verify: an equation that holds only for the values of the file is reported") {
  const std::string told = "it holds for the parameter values of the file";
  const auto ball = [](const std::string& share) {
    return verify_with("rolling_ball", "equations = [\"dot(dot(x)) = " + share +
                                           "*g*sin(alpha)\", \"dot(dot(y)) = 0\", "
                                           "\"dot(wz(ball)) = 0\"]\n");
  };
  const Outcome homogeneous = ball("5/7");
  INFO(homogeneous.errors);
  CHECK(homogeneous.status == 1);
  CHECK(mentions(homogeneous.errors, told));
  CHECK_FALSE(mentions(ball("3/7").errors, told));
  CHECK(ball("m*r^2/(m*r^2 + J)").status == 0);
}

TEST_CASE("verify: the term that keeps a sum from being conserved is named") {
  const std::string kinetic = "1/2*m*R^2*dot(theta)^2 ";
  const std::string rest = "1/2*m*R^2*sin(theta)^2*Omega^2 - m*g*R*(cos(theta) - 1)";
  const auto judged = [](const std::string& sum) {
    return verify_with("rotating_hoop", "conserved = [\"" + sum + "\"]\n");
  };
  CHECK(judged(kinetic + "- " + rest).status == 0);
  const Outcome sign = judged(kinetic + "+ " + rest);
  INFO(sign.errors);
  CHECK(sign.status == 1);
  CHECK(mentions(sign.errors, "compared with a conserved quantity: the term "));
  CHECK(mentions(sign.errors, "has the opposite sign"));
  CHECK_FALSE(mentions(judged(kinetic + "+ m*R^2*theta^2*Omega^2").errors, "conserved quantity"));
}

TEST_CASE("verify: equations with a closed form are proved") {
  const Outcome proved =
      verify_with("simple_pendulum", "equations = \"l*dot(dot(theta)) = -g*sin(theta)\"\n", "");
  INFO(proved.output);
  CHECK(mentions(proved.output, "[[expect]] equations"));
  CHECK(mentions(proved.output, "some proved"));
  const Outcome sampled =
      verify_with("simple_pendulum", "equations = \"dot(l*dot(theta)) = -g*sin(theta)\"\n", "");
  INFO(sampled.output);
  CHECK(sampled.status == 0);
  CHECK_FALSE(mentions(sampled.output, "some proved"));
}

TEST_CASE("verify: equations that do not determine the accelerations are refused") {
  const Outcome judged =
      verify_with("cart_pole", "equations = [" + pole_row + ", " + pole_row + "]\n");
  INFO(judged.errors);
  CHECK(judged.status == 2);
  CHECK(mentions(judged.errors, "[E540]: d(left - right)/da has rank 1 of 2, so"));
}

TEST_CASE(
    "verify: equations of a constrained model hold on the constraints and are counted with them") {
  const std::string tangent = "x*dot(dot(y)) - y*dot(dot(x)) = ";
  CHECK(verify_with("pendulum_xy", "equations = \"" + tangent + "-g*x\"\n").status == 0);
  const Outcome wrong = verify_with("pendulum_xy", "equations = \"" + tangent + "g*x\"\n");
  INFO(wrong.errors);
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors, "[E510]: left - right is "));
}

TEST_CASE("verify: numbers at a state may differ by a fraction of the largest entry") {
  const std::string at = "at = { theta = \"pi/2\", \"dot(theta)\" = 2, m = 1, l = 0.5 }\n";
  CHECK(verify_with("simple_pendulum", at + "gravity = [4.905]\nmass_matrix = [[0.25]]\n"
                                            "hamiltonian = 0.5\n")
            .status == 0);
  CHECK(verify_with("simple_pendulum", at + "within = 1e-2\ngravity = [4.9]\n").status == 0);
  const Outcome wrong = verify_with("simple_pendulum", at + "gravity = [4.9]\n");
  INFO(wrong.errors);
  CHECK(wrong.status == 1);
  CHECK(mentions(wrong.errors,
                 "[E510]: gravity is 4.9 in the file, 4.905 as derived, -0.005 too much: "
                 "0.00101937 of the largest entry, more than 1e-12, at q = (1.5708)"));
}

/// Verifies `keys` at `x` for a potential that equals 1 everywhere, written with terms in x^2.
Outcome verify_at(const std::string& x, const std::string& keys) {
  const Workspace workspace;
  workspace.write("model.toml", R"toml(format = 1
[model]
name = "cancels"
[[coordinate]]
name = "x"
[parameters]
k = 2
l = 1
[energy]
T = "dot(x)^2"
V = "1/2*k*(x^2 - (x - l)*(x + l))"
[[expect]]
at = { x = )toml" + x + " }\n" + keys);
  return workspace.run("elgen verify --quick model.toml");
}

TEST_CASE("verify: numbers at a state are computed with more digits if terms cancel") {
  CHECK(verify_at("1e100", "potential_energy = \"1\"\ngravity = [0]\n").status == 0);
  CHECK(verify_at("1e100", "potential_energy = \"0\"\n").status == 1);
  CHECK(verify_at("1", "potential_energy = \"1\"\n").status == 0);
  const Outcome untold = verify_at("\"1e400\"", "gravity = [0]\n");
  INFO(untold.output);
  CHECK(mentions(untold.output, "skipped"));
  CHECK(mentions(untold.output, "1 undecided by the oracle"));
}

TEST_CASE("verify: a function that vanishes at pi is exactly 0 there") {
  const auto upright = [](const std::string& gravity) {
    return verify_with("simple_pendulum",
                       "at = { theta = \"pi\" }\ngravity = [\"" + gravity + "\"]\n");
  };
  CHECK(upright("0").status == 0);
  CHECK(upright("1e-90").status == 1);
}

TEST_CASE("verify: a state may set inputs, momenta, parameters and components of rotations") {
  CHECK(verify_with("cart_pole",
                    "at = { u = 1, theta = 0, M = 2, m = 1, l = 1 }\n"
                    "forward_dynamics = [\"1/2\", -0.5]\n")
            .status == 0);
  CHECK(verify_with("simple_pendulum",
                    "at = { theta = \"pi/2\", \"p(theta)\" = 2, m = 1, l = 0.5 }\n"
                    "hamiltonian = 8\n")
            .status == 0);
  CHECK(verify_with("quadrotor",
                    "at = { attitude_w = 3, attitude_x = 4, \"thrust[1]\" = 1, \"thrust[2]\" = 1, "
                    "\"thrust[3]\" = 1, \"thrust[4]\" = 1, m = 1, c = 0 }\n"
                    "forward_dynamics = [0, -3.84, -10.93, 0, 0, 0]\n")
            .status == 0);
}

}  // namespace elgen::test
