// An arm with all joints locked except one gives the numbers of the whole arm at the locked pose,
// in a fraction of the operations.
#include <catch2/catch.hpp>
#include <random>

#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;

constexpr std::size_t joints = 7;
constexpr std::size_t free_joint = 3;  ///< q4

Products locked_products(const std::string& locks) {
  const std::string outputs =
      "[outputs]\nmass_matrix = true\nbias = true\ninverse_dynamics = true\n";
  return derived(inputs_of(model_file("panda7"), outputs + locks), {.goals = {Goal::choose}});
}

std::string locks_text() {
  std::string text = "[lock]\n";
  for (std::size_t i = 0; i < joints; ++i) {
    if (i == free_joint) continue;
    text += "q" + std::to_string(i + 1) + " = { value = \"" + std::to_string(2 * i + 1) +
            "/10\", reaction = true }\n";
  }
  return text;
}

/// A state of the whole arm: locked joints rest at their pose, the free joint moves as in `state`.
Arguments<Real> whole(Arguments<Real> state) {
  const auto among_zeros = [](const std::vector<Real>& free) {
    std::vector<Real> all(joints);
    all[free_joint] = free.front();
    return all;
  };
  state.q = among_zeros(state.q);
  for (std::size_t i = 0; i < joints; ++i) {
    if (i != free_joint) state.q[i] = Real(cln::cl_RA(2 * static_cast<long>(i) + 1) / 10);
  }
  state.v = among_zeros(state.v);
  state.a = among_zeros(state.a);
  state.u = among_zeros(state.u);
  return state;
}

bool agree(const Real& x, const Real& y) {
  static const Real allowed(cln::expt(cln::cl_R(10), cln::cl_I(-50)));
  return abs(x - y).value() <= (allowed * (Real(1) + abs(y))).value();
}

}  // namespace

TEST_CASE("six of seven locked joints leave the equations of the free joint", "[lock]") {
  const Products arm = locked_products("");
  const Products one = locked_products(locks_text());
  const auto value = [](const Products& of, OutputKind kind, const Arguments<Real>& state) {
    return evaluate(*of.program, *find_function(*of.program, kind), state);
  };
  std::mt19937 generator(7);
  const auto number = [&generator] {
    return Real(cln::cl_RA(static_cast<long>(generator() % 6001) - 3000) / 1000);
  };
  for (int sample = 0; sample < 8; ++sample) {
    Arguments<Real> state;
    for (const Parameter& p : one.checked->model.parameters) state.parameters.emplace_back(p.value);
    state.q = {number()};
    state.v = {number()};
    state.a = {number()};
    state.u = {number()};  // motors of locked joints are no inputs
    const Arguments<Real> all = whole(state);
    const auto tau = value(arm, OutputKind::inverse_dynamics, all);
    CHECK(agree(value(one, OutputKind::inverse_dynamics, state)[0], tau[free_joint]));
    CHECK(agree(value(one, OutputKind::bias, state)[0],
                value(arm, OutputKind::bias, all)[free_joint]));
    CHECK(agree(value(one, OutputKind::mass_matrix, state)[0],
                value(arm, OutputKind::mass_matrix, all)[free_joint * joints + free_joint]));
    const auto held = value(one, OutputKind::reaction, state);
    REQUIRE(held.size() == joints - 1);
    for (std::size_t row = 0; row < held.size(); ++row) {
      const std::size_t joint = row < free_joint ? row : row + 1;
      CHECK(agree(held[row], tau[joint]));
    }
  }
}

TEST_CASE("a motor's inertia moves with the locked joint", "[lock]") {
  const Workspace workspace;
  workspace.write("arm.toml", R"toml(format = 1
[model]
name = "arm"
[[coordinate]]
name = "q1"
unit = "rad"
armature = "J1"
[[coordinate]]
name = "q2"
unit = "rad"
armature = "J2"
[[coordinate]]
name = "x"
unit = "m"
[parameters]
m = { value = 2, unit = "kg" }
J1 = { value = 0.3, unit = "kg*m^2" }
J2 = { value = 0.2, unit = "kg*m^2" }
[[point]]
name = "slider"
at = ["x*cos(q1 + q2)", "x*sin(q1 + q2)"]
mass = "m"
)toml");
  workspace.write("held.scene.toml", R"toml(format = 1
model = "arm.toml"
name = "held"
[outputs]
kinetic_energy = true
inverse_dynamics = true
[lock]
q1 = { value = "sin(t)", reaction = true }
q2 = { value = "t^2", reaction = true }
)toml");
  const Outcome shown = workspace.run("elgen show held.scene.toml");
  INFO(shown.output + shown.errors);
  CHECK(shown.status == 0);
  CHECK(mentions(shown.output, "1/2*J1*cos(t)^2"));
  CHECK(mentions(shown.output, "2*J2*t^2"));
  // The reactions contain the rows of the full model: J1 q1'' = -J1 sin(t) and J2 q2'' = 2 J2.
  CHECK(mentions(shown.output, "J1*sin(t)"));
  CHECK(mentions(shown.output, "2*J2"));
  CHECK(workspace.run("elgen generate -q held.scene.toml -o out").status == 0);
  CHECK(workspace.run("elgen verify --build written --samples 16 held.scene.toml").status == 0);
}

TEST_CASE("an arm with a locked elbow costs as much as the hand-written formula", "[lock]") {
  const auto counts = [](const std::string& lock, OutputKind kind) {
    const Products products =
        derived(inputs_of(model_file("two_link_arm"),
                          "[outputs]\ngravity = true\ninverse_dynamics = true\n[lock]\n" + lock),
                {.scene = {.fixed = {make_source("--fix", "all")}}, .goals = {Goal::choose}});
    return count_operations(*find_function(*products.program, kind));
  };
  // tau = M a + A cos(q1) - B sin(q1) with the numbers M, A and B
  const std::string elbow = "q2 = { value = \"0.7\" }\n";
  CHECK(counts(elbow, OutputKind::inverse_dynamics) ==
        OperationCounts{.add = 2, .mul = 3, .sincos = 1});
  CHECK(counts(elbow, OutputKind::gravity) == OperationCounts{.add = 1, .mul = 2, .sincos = 1});
  CHECK(counts("q2 = { value = \"sqrt(2)\" }\n", OutputKind::inverse_dynamics) ==
        OperationCounts{.add = 2, .mul = 3, .sincos = 1});
}

TEST_CASE("locked joints cost nothing", "[lock]") {
  const Products arm = locked_products("");
  const Products one = locked_products(locks_text());
  const auto share = [&](OutputKind kind) {
    const auto cost_in = [kind](const Products& products) {
      return static_cast<double>(cost(count_operations(*find_function(*products.program, kind))));
    };
    return cost_in(one) / cost_in(arm);
  };
  INFO("of the whole arm: M " << share(OutputKind::mass_matrix) << ", tau "
                              << share(OutputKind::inverse_dynamics));
  // With 1 moving joint, M has 1 entry instead of 49, and tau has 1 row instead of 7.
  CHECK(share(OutputKind::mass_matrix) < 0.35);
  CHECK(share(OutputKind::inverse_dynamics) < 0.5);
}

}  // namespace elgen::test
