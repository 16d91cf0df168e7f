// Every structural row passes for a correct program, and fails for a changed one.
#include "verify/structure/structure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "elgen/equations_of_motion.hpp"
#include "elgen/lower.hpp"
#include "sample/states.hpp"
#include "support/models.hpp"
#include "verify/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

std::vector<CertificateRow> rows_of(const System& system) {
  std::vector<State> states;
  for (const auto& sample : sample_states<double>(system.subject(), {8, 1, false})) {
    if (sample.region == Region::nominal) {
      states.push_back(exact_state(system.subject(), sample.values));
    }
  }
  return check_structure(system.subject(), states);
}

Verdict verdict_of(const System& system, const std::string& check) {
  for (const CertificateRow& row : rows_of(system)) {
    if (row.check == check) return row.verdict;
  }
  FAIL("no row " << check);
  return Verdict::skipped;
}

struct Mutation {
  std::string check;
  std::string function;
  std::string from;
  std::string to;
};

const std::vector<Mutation> mutations{
    {"mass matrix symmetric", "mass_matrix", "= 10 11 11 12", "= 10 11 9 12"},
    {"mass matrix positive definite", "mass_matrix", "10 = add 0 1", "10 = subtract 1 0"},
    {"rate of M less 2 C skew", "coriolis_matrix", "= 17 18 17 17", "= 17 16 17 17"},
    {"power balance", "forward_dynamics", "25 = subtract 24 23", "25 = add 24 23"},
    {"inverse of forward dynamics", "inverse_dynamics", "29 = add 28 23", "29 = subtract 28 23"},
    {"momentum gradient", "momentum", "29 = add 27 28", "29 = subtract 27 28"},
    {"energy gradient", "energy_function", "34 = multiply 33 32", "34 = multiply 33 30"},
    {"momentum from energies", "kinetic_energy", "34 = multiply 33 32", "34 = add 33 32"},
    {"gravity from potential", "gravity", "= 16 15", "= 16 14"},
    {"velocity force from C", "velocity_force", "= 19 17", "= 18 17"},
    {"bias from parts", "bias", "23 = add 19 20", "23 = subtract 19 20"},
    {"inverse dynamics from parts", "inverse_dynamics", "33 = add 32 22", "33 = add 32 21"},
    {"Jacobian by dual numbers", "tip_jacobian", "= 13 15 14 17", "= 13 15 14 16"},
    {"output bias by dual numbers", "tip_bias", "= 17 19", "= 17 18"},
};

}  // namespace

TEST_CASE("all identities hold for a correct program") {
  const auto rows = rows_of(cart_pole_system());
  CHECK(rows.size() == mutations.size());
  for (const CertificateRow& row : rows) {
    INFO(row.check << ": " << row.worst_value);
    CHECK(row.verdict == Verdict::holds);
    CHECK(row.samples == 4);
  }
}

TEST_CASE("outputs that the program lacks come from the oracle") {
  System system = cart_pole_system();
  std::erase_if(system.program.functions, [](const Function& f) {
    return f.kind == OutputKind::dissipation || f.kind == OutputKind::input_matrix;
  });
  const auto rows = rows_of(system);
  CHECK(rows.size() == mutations.size());
  for (const CertificateRow& row : rows) CHECK(row.verdict == Verdict::holds);
}

TEST_CASE("each structural row fails for a changed program") {
  for (const Mutation& mutation : mutations) {
    INFO(mutation.check);
    const System system = with_mistake(mutation.function, mutation.from, mutation.to);
    CHECK(verdict_of(system, mutation.check) == Verdict::fails);
  }
}

namespace {

/// A moving base, an arm with oblique axes, the frame `tip` on the arm, and a freely rotating ball.
const std::string& framed_text() {
  static const std::string text = model_text("framed", R"toml(
[[coordinate]]
name = "a"
[[coordinate]]
name = "b"
[[coordinate]]
name = "r"
kind = "rotation"
[[prescribed]]
name = "s"
value = "k*t^2"
[parameters]
k = 0.5
l = 2
m = 3
i1 = 1
i2 = 2
i3 = 2.5
[[frame]]
name = "base"
parent = "world"
translate = ["0", "s", "0"]
rotate = [[["1", "1", "0"], "s"]]
[[frame]]
name = "arm"
parent = "base"
rpy = ["0.3", "-0.2", "0.1"]
[[frame]]
name = "tip"
parent = "arm"
translate = ["l*cos(a)", "l*sin(a)", "b"]
rotate = [["x", "a"], ["z", "b"]]
[[frame]]
name = "ball"
parent = "tip"
translate = ["l", "0", "0"]
rotation = "r"
[[body]]
name = "load"
frame = "ball"
mass = "m"
com = ["0", "l", "0"]
inertia = ["i1", "i2", "i3"]
[[output]]
name = "tip_pose"
frame = "tip"
jacobian = true
[[output]]
name = "own"
frame = "ball"
axes = "ball"
jacobian = true
[[output]]
name = "ball_pose"
frame = "ball"
jacobian = true
)toml");
  return text;
}

System framed_system(const std::string& outputs) {
  SceneOptions options;
  options.outputs = {make_source("--outputs", outputs)};
  const CheckedModel checked = checked_model(framed_text(), options);
  const Result<UnreducedLagrangian> lagrangian = formulate(checked.model);
  const auto equations = derive(*lagrangian, checked.scene.outputs, {});
  return {checked.model, checked.scene, *lower(*equations, checked.scene.outputs, {})};
}

/// `whole` with only two functions: `function`, and the pose from which `function` is derived.
System alone(const System& whole, const Function& function) {
  System system = whole;
  system.program.functions = {*find_function(whole.program, OutputKind::user_value, function.user),
                              function};
  return system;
}

/// Adds 1/1000 to the value at `entry`.
void shift(Program& program, Function& function, std::uint32_t& entry) {
  const auto shift = static_cast<std::uint32_t>(function.instructions.size());
  const std::uint32_t constant =
      intern_constant(rational_constant(cln::cl_RA(1) / 1000), program.constants);
  function.instructions.push_back({.opcode = Opcode::constant, .a = constant});
  function.instructions.push_back({.opcode = Opcode::add, .a = entry, .b = shift});
  function.names.resize(function.instructions.size());
  entry = shift + 1;
}

}  // namespace

TEST_CASE("a frame's Jacobian and bias agree with its twist, entry by entry") {
  const System framed = framed_system(
      "tip_pose,tip_pose_jacobian,tip_pose_bias,own,own_jacobian,own_bias,ball_pose,"
      "ball_pose_jacobian,ball_pose_bias");
  for (const Function& function : framed.program.functions) {
    if (function.kind == OutputKind::user_value) continue;
    INFO(function.name);
    const System right = alone(framed, function);
    const std::vector<CertificateRow> rows = rows_of(right);
    REQUIRE(rows.size() == 1);
    INFO(rows.front().worst_value);
    CHECK(rows.front().verdict == Verdict::holds);
    for (std::size_t i = 0; i < function.fields.front().entries.size(); ++i) {
      INFO("entry " << i);
      System wrong = right;
      Function& changed = wrong.program.functions.back();
      shift(wrong.program, changed, changed.fields.front().entries[i]);
      CHECK(rows_of(wrong).front().verdict == Verdict::fails);
    }
  }
}

TEST_CASE("Hamilton's functions agree with the energies and the motion, entry by entry") {
  const System right =
      framed_system("momentum,hamiltonian,velocities_of_momenta,hamilton_equations");
  const std::vector<CertificateRow> rows = rows_of(right);
  REQUIRE(rows.size() == 3);
  for (const CertificateRow& row : rows) {
    INFO(row.check << ": " << row.worst_value);
    CHECK(row.verdict == Verdict::holds);
    const auto is_subject = [&](const Function& f) { return f.name == row.output; };
    System wrong = right;
    Function& changed = *std::ranges::find_if(wrong.program.functions, is_subject);
    const Function whole = changed;
    for (std::size_t field = 0; field < whole.fields.size(); ++field) {
      for (std::size_t i = 0; i < whole.fields[field].entries.size(); ++i) {
        INFO("field " << field << ", entry " << i);
        changed = whole;
        shift(wrong.program, changed, changed.fields[field].entries[i]);
        CHECK(verdict_of(wrong, row.check) == Verdict::fails);
      }
    }
  }
}

TEST_CASE("rows of outputs that the program lacks are absent") {
  System system = cart_pole_system();
  system.program.functions.resize(1);
  CHECK(rows_of(system).size() == 2);
}

TEST_CASE("a chart that is singular everywhere is skipped with a reason and does not fail") {
  const System system = system_of(pendulum().model,
                                  "parameters m l g\ncoordinates th\nfunction mass_matrix\n"
                                  "  0 = constant 0\n  result 1 1 = 0\n");
  const std::vector<CertificateRow> rows = rows_of(system);
  const auto row = std::find_if(rows.begin(), rows.end(), [](const CertificateRow& candidate) {
    return candidate.check == "mass matrix positive definite";
  });
  REQUIRE(row != rows.end());
  CHECK(row->verdict == Verdict::skipped);
  CHECK(row->skipped == std::vector<SkippedStates>{{SkipReason::singular, 4}});
}

TEST_CASE("the power balance includes explicit time") {
  ModelBuilder builder = rotating_hoop("W*t");
  builder.model.uses_time = true;
  const std::string head =
      "parameters m R g W\ncoordinates th\ntime\n"
      "function momentum\n  0 = parameter m\n  1 = parameter R\n  2 = velocity th\n"
      "  3 = multiply 1 1\n  4 = multiply 0 3\n  5 = multiply 4 2\n  result 1 1 = 5\n";
  const std::string common =
      "  0 = parameter m\n  1 = parameter R\n  2 = parameter g\n  3 = parameter W\n"
      "  4 = coordinate th\n  5 = velocity th\n  6 = sin 4\n  7 = cos 4\n  8 = multiply 1 1\n"
      "  9 = multiply 0 8\n  10 = multiply 3 6\n  11 = divide 2 1\n";
  // E = 1/2 m R^2 (v^2 - W^2 s^2) - m g R c;  a = W^2 s c - g/R s
  const std::string text =
      head + "function energy_function\n" + common +
      "  12 = multiply 5 5\n  13 = multiply 10 10\n  14 = subtract 12 13\n  15 = multiply 9 14\n"
      "  16 = constant 1/2\n  17 = multiply 16 15\n  18 = multiply 9 11\n  19 = multiply 18 7\n"
      "  20 = subtract 17 19\n  result 1 1 = 20\n"
      "function forward_dynamics\n" +
      common +
      "  12 = multiply 10 3\n  13 = multiply 12 7\n  14 = multiply 11 6\n  15 = subtract 13 14\n"
      "  16 = constant 1\n  result acceleration 1 1 = 15\n  result relative_pivots 1 1 = 16\n";
  CHECK(verdict_of(system_of(builder.model, text), "power balance") == Verdict::holds);
  const std::string wrong = replaced(text, "15 = subtract 13 14", "15 = add 13 14");
  CHECK(verdict_of(system_of(builder.model, wrong), "power balance") == Verdict::fails);
}
