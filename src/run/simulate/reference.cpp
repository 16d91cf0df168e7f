// run_reference: integrates the equations of motion twice, to different tolerances, by
// Boost.odeint's Fehlberg method with steps adapted to its error estimate. The uncertainty of the
// reference follows from the distance of both final states. Hairer, Norsett, Wanner, Solving
// Ordinary Differential Equations I, 2nd ed., sec. II.10.
#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "elgen/simulate.hpp"
#include "program/evaluate/subject.hpp"
#include "run/simulate/ranks.hpp"
#include "run/simulate/start.hpp"
#include "run/steps/rounded_program.hpp"

namespace elgen {
namespace {

namespace odeint = boost::numeric::odeint;

/// Evaluates d(q, v)/dt; a state is q, then v.
class ReferenceSystem {
 public:
  using Scalar = long double;
  using Values = std::vector<Scalar>;

  /// `system` evaluates the laws of inputs, in double.
  ReferenceSystem(SimulatedSystem& system, const CheckedModel& checked, const Program& program)
      : system_(system),
        program_(program),
        rounded_(program),
        ranks_(system, "measure a run that ends earlier, or starts elsewhere"),
        arguments_(arguments_at<Scalar>(nominal_state(checked.model, checked.scene))) {}

  [[nodiscard]] Values start() {
    Values state = stated_start<Scalar>(system_.model());
    project_state(state, 0);
    return state;
  }

  void find_rates(const Values& state, Values& rates, Scalar t) {
    set_state(state);
    arguments_.t = t;
    if (!system_.model().inputs.empty()) {
      const Numbers seen(state.begin(), state.end());
      const Numbers& u =
          system_.update_inputs(seen.data(), system_.v_of(seen), static_cast<double>(t));
      arguments_.u.assign(u.begin(), u.end());
    }
    const Function* const turning = find_function(program_, OutputKind::coordinate_rates);
    const Values of_q = turning == nullptr ? arguments_.v : rounded_.evaluate(*turning, arguments_);
    const Function& dynamics = *find_function(program_, OutputKind::forward_dynamics);
    const Values of_v = rounded_.evaluate(dynamics, arguments_);
    const auto middle = std::copy(of_q.begin(), of_q.end(), rates.begin());
    std::copy_n(of_v.data() + first_entry_of(dynamics, "acceleration"), system_.velocity_count(),
                middle);
  }

  /// E624 if M or A loses its rank.
  [[nodiscard]] Diagnostics check_ranks(const Values& state, Scalar t) {
    return ranks_.check_ranks({state.begin(), state.end()}, static_cast<double>(t));
  }

  /// Normalises quaternions, and projects onto the constraints if the model has any.
  void project_state(Values& state, Scalar t) {
    const bool is_projected = !system_.model().constraints.empty();
    const Function* const restored =
        find_function(program_, is_projected ? OutputKind::projected : OutputKind::normalized);
    if (restored == nullptr) return;
    set_state(state);
    arguments_.t = t;
    std::ranges::copy(rounded_.evaluate(*restored, arguments_), state.begin());
  }

 private:
  void set_state(const Values& state) {
    const auto middle = state.begin() + static_cast<std::ptrdiff_t>(system_.position_count());
    arguments_.q.assign(state.begin(), middle);
    arguments_.v.assign(middle, state.end());
  }

  SimulatedSystem& system_;
  const Program& program_;
  RoundedProgram<Scalar> rounded_;
  RankWatch ranks_;
  Arguments<Scalar> arguments_;
};

struct ReferenceResult {
  std::vector<double> last = {};
  std::vector<double> largest = {};
};

bool record_state(const ReferenceSystem::Values& state, ReferenceResult& end) {
  end.last.assign(state.begin(), state.end());
  end.largest.resize(end.last.size());
  for (std::size_t i = 0; i < end.last.size(); ++i) {
    end.largest[i] = std::max(end.largest[i], std::abs(end.last[i]));
  }
  return std::ranges::all_of(end.last, [](double x) { return std::isfinite(x); });
}

/// The final state of a run, and the largest magnitude of each number along the run. E624 if the
/// run does not reach its end in `most_steps`, rejected steps included, or if M or A loses its
/// rank.
Result<ReferenceResult> integrate(long double tolerance, long double time, std::size_t most_steps,
                                  ReferenceSystem system) {
  using Scalar = ReferenceSystem::Scalar;
  using Values = ReferenceSystem::Values;
  auto steps = odeint::make_controlled(tolerance, tolerance,
                                       odeint::runge_kutta_fehlberg78<Values, Scalar>());
  const auto rates = [&system](const Values& x, Values& dxdt, Scalar at) {
    system.find_rates(x, dxdt, at);
  };
  const Scalar shortest = 4 * std::numeric_limits<Scalar>::epsilon() * time;
  Values state = system.start();
  ReferenceResult end;
  bool goes_on = record_state(state, end);
  Diagnostics lost = system.check_ranks(state, 0);
  Scalar t = 0;
  std::size_t count = 0;
  for (Scalar length = time / 100; goes_on && lost.empty() && t < time;) {
    const bool is_last = length >= time - t;
    Scalar h = is_last ? time - t : length;
    goes_on = (h >= shortest || is_last) && count++ < most_steps;
    if (!goes_on) break;
    const bool is_made = steps.try_step(rates, state, t, h) == odeint::success;
    length = is_made && is_last ? std::max(length, h) : h;
    if (!is_made) continue;
    if (is_last) t = time;
    system.project_state(state, t);
    goes_on = record_state(state, end);
    if (goes_on) lost = system.check_ranks(state, t);
  }
  if (!lost.empty()) return lost;
  if (goes_on) return end;
  return Diagnostic{
      Code::E624, {}, fmt::format("the reference ends after t = {:.6g}", static_cast<double>(t))};
}

}  // namespace

Result<ReferenceRun> run_reference(const CheckedModel& checked, const Program& program,
                                   double time) {
  const Result<CheckedModel> assembled = assemble_start(checked, 0);
  if (!assembled) return assembled.diagnostics;
  SimulatedSystem system(*assembled, program, nullptr);
  Diagnostics refused = check_singular_start(system, system.start_state(), 0);
  if (!refused.empty()) return refused;
  const auto run_twice = [&](long double tolerance,
                             std::size_t most_steps) -> Result<ReferenceRun> {
    const auto run = [&](long double of_step) {
      return integrate(of_step, time, most_steps, ReferenceSystem(system, *assembled, program));
    };
    const Result<ReferenceResult> rougher = run(10 * tolerance);
    if (!rougher) return rougher.diagnostics;
    const Result<ReferenceResult> finer = run(tolerance);
    if (!finer) return finer.diagnostics;
    return ReferenceRun{finer->last, rougher->last, finer->largest, static_cast<double>(tolerance)};
  };
  // Ten times the rounding errors of long double. At kinks, steps would become too short.
  constexpr long double finest_tolerance = 1e-18L;
  constexpr std::size_t most_finest_steps = 20'000;  // long runs take the larger tolerance
  // Ten times the rounding errors of double, which laws of inputs have.
  constexpr long double fine_tolerance = 1e-15L;
  if (checked.scene.laws.empty()) {
    Result<ReferenceRun> finest = run_twice(finest_tolerance, most_finest_steps);
    if (finest) return finest;
  }
  return run_twice(fine_tolerance, std::numeric_limits<std::size_t>::max());
}

}  // namespace elgen
