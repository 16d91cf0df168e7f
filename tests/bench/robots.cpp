// M, bias and inverse dynamics of a robot by several programs in one run: emitted code with
// parameters and with numbers, the hand-written recursion (panda7), and KDL and MuJoCo if
// installed. MODEL and FIXED are the namespaces, HEADER and FIXED_HEADER the paths of the emitted
// headers, DESCRIPTION is the robot in JSON or URDF. Prints rows of a Markdown table.
#include HEADER
#include FIXED_HEADER

#include <cmath>
#include <cstdio>
#include <string>

#include "other_programs.hpp"
#include "timing.hpp"
#ifdef BY_HAND
#include "panda_by_hand.hpp"
#endif

namespace {

namespace emitted = ::MODEL;
namespace fixed = ::FIXED;

constexpr std::size_t joints = emitted::velocity_count;
using Forces = std::array<double, joints>;

struct JointState {
  std::array<double, emitted::coordinate_count> q;
  Forces v, a;
};

/// Normalises the quaternion of a floating base.
void normalise_base(JointState& state) {
  if (emitted::coordinate_count == joints) return;
  double sum = 0.0;
  for (std::size_t i = 3; i < 7; ++i) sum += state.q[i] * state.q[i];
  for (std::size_t i = 3; i < 7; ++i) state.q[i] /= std::sqrt(sum);
}

std::vector<JointState> some_states() {
  std::vector<JointState> states(16);
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto x = [k](std::size_t i) { return static_cast<double>(7 * k + i); };
    for (std::size_t i = 0; i < states[k].q.size(); ++i) states[k].q[i] = 3.0 * std::sin(x(i));
    for (std::size_t i = 0; i < joints; ++i) {
      states[k].v[i] = 2.0 * std::cos(3.0 * x(i));
      states[k].a[i] = 4.0 * std::sin(5.0 * x(i));
    }
    normalise_base(states[k]);
  }
  return states;
}

/// Times programs that compute one quantity. Prints times, and ratios to the first program's time.
class Contest {
 public:
  explicit Contest(const char* quantity) : quantity_(quantity) {}

  /// Adds a program; `evaluate` computes the quantity at a JointState.
  template <class Evaluate>
  void add(const char* program, Evaluate evaluate) {
    programs_.push_back(program);
    alternatives_.push_back([evaluate, states = some_states()](int calls) {
      bench::keep(states);
      for (int i = 0; i < calls; ++i) {
        bench::keep(evaluate(states[static_cast<std::size_t>(i) % states.size()]));
      }
    });
  }

  void add(const char* program, const bench::Evaluate& evaluate) {
    add(program, [evaluate](const JointState& at) {
      evaluate(at.q.data(), at.v.data(), at.a.data());
      return 0;
    });
  }

  void print(const std::string& robot) const {
    const std::vector<double> ns = bench::medians(alternatives_, 200, 301);
    for (std::size_t i = 0; i < ns.size(); ++i) {
      std::printf("| %s | %s | %s | %.0f | %.2f |\n", robot.c_str(), quantity_, programs_[i], ns[i],
                  ns[i] / ns[0]);
    }
  }

 private:
  const char* quantity_;
  std::vector<const char*> programs_ = {};
  std::vector<std::function<void(int)>> alternatives_ = {};
};

Contest mass_matrices() {
  Contest contest("mass_matrix");
  contest.add("emitted", [p = emitted::Parameters<double>{}](const JointState& at) {
    return emitted::mass_matrix(p, at.q);
  });
  contest.add("emitted, --fix all", [p = fixed::Parameters<double>{}](const JointState& at) {
    return fixed::mass_matrix(p, at.q);
  });
  return contest;
}

Contest biases() {
  Contest contest("bias");
  contest.add("emitted", [p = emitted::Parameters<double>{}](const JointState& at) {
    return emitted::bias(p, at.q, at.v);
  });
  contest.add("emitted, --fix all", [p = fixed::Parameters<double>{}](const JointState& at) {
    return fixed::bias(p, at.q, at.v);
  });
  return contest;
}

Contest inverse_dynamics() {
  Contest contest("inverse_dynamics");
  contest.add("emitted", [p = emitted::Parameters<double>{}](const JointState& at) {
    return emitted::inverse_dynamics(p, at.q, at.v, at.a);
  });
  contest.add("emitted, --fix all", [p = fixed::Parameters<double>{}](const JointState& at) {
    return fixed::inverse_dynamics(p, at.q, at.v, at.a);
  });
  return contest;
}

#ifdef BY_HAND
/// Throws runtime_error if a torque by hand differs from the emitted torque by 1e-11 N m or more.
void demand_agreement(const bench::Panda<double>& panda) {
  for (const JointState& at : some_states()) {
    const Forces own = emitted::inverse_dynamics(emitted::Parameters<double>{}, at.q, at.v, at.a);
    const Forces hand = bench::inverse_dynamics(panda, at.q, at.v, at.a);
    for (std::size_t i = 0; i < joints; ++i) {
      if (!(std::abs(own[i] - hand[i]) < 1e-11)) throw std::runtime_error("by hand it differs");
    }
  }
}

void add_by_hand(Contest& contest) {
  const bench::Panda<double> panda = bench::panda_of(elgen::test::read_robot(DESCRIPTION));
  demand_agreement(panda);
  contest.add("Newton-Euler by hand", [panda](const JointState& at) {
    return bench::inverse_dynamics(panda, at.q, at.v, at.a);
  });
}
#else
void add_by_hand(const Contest& /*contest*/) {}
#endif

}  // namespace

int main() {
  const std::filesystem::path description = DESCRIPTION;
  Contest mass = mass_matrices();
  Contest bias = biases();
  Contest torque = inverse_dynamics();
  add_by_hand(torque);
  for (const bench::OtherProgram& program : bench::other_programs(description)) {
    mass.add(program.name, program.mass_matrix);
    bias.add(program.name, program.bias);
    torque.add(program.name, program.inverse_dynamics);
  }
  for (const Contest* contest : {&mass, &bias, &torque}) {
    contest->print(description.stem().string());
  }
}
