// The implicit midpoint rule on q and p = M v + b, by successive substitution, starting with w = v.
// At m = (q + h/2 w, w, t + h/2):
//
//     M(m) w = p + h/2 dp/dt(m) - b(m)        dp/dt = dL/dq + F,   F = B u + Q - dD/dv
//
// With the last w: q += h w, p += h dp/dt(m).
//
// If no force acts on a cyclic coordinate, its momentum is exact after any number of substitutions.
// Each substitution multiplies the error of w by about h/2 |M^-1 (dp/dq - d2L/dv dq)|. Newton's
// method would need half as many iterations, but each iteration would also need a Coriolis matrix
// and the elimination of an unsymmetric matrix. M is evaluated at each point to keep the bound on
// rounding errors small. Iterations w -= M^-1 r(w), r the residual of the equation, would multiply
// the bound by 1 + cond M each time; here the bound shrinks with the error of w.
//
// Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., sec. VIII.6.
#include <algorithm>

#include "program/evaluate/subject.hpp"
#include "program/steps/methods.hpp"

namespace elgen {
namespace {

class Midpoint {
 public:
  explicit Midpoint(const StepContext& step) : step_(step), compose_(step.composition) {}

  /// Carries p through the parts of the step, and computes v after the last part. The last w of a
  /// part is the first w of the next part.
  NextState operator()() {
    InstructionIndices p = call_dynamics_output(OutputKind::momentum, step_.start);
    CallPoint end = step_.start;
    CallPoint longest;
    InstructionIndices expected;
    for (std::size_t i = 0; i < step_.parts.size(); ++i) {
      const cln::cl_RA& length = step_.parts[i];
      const CallPoint at = solve_midpoint(end, p, length);
      const InstructionIndices rate = rate_of_momentum(at);
      if (i == step_.parts.size() / 2) {
        expected = compose_.add_scaled(p, step_.step_multiple(length / 2), rate);
        longest = at;
      }
      time_ = time_ + length;
      end.q = compose_.add_scaled(end.q, step_.step_multiple(length), at.v);
      end.v = at.v;
      end.t = step_.time_at_fraction(time_);
      end.number = at.number + 1;
      compose_.set_name(end.q, Opcode::coordinate, end.number);
      p = compose_.add_scaled(p, step_.step_multiple(length), rate);
    }
    return {end.q, solve_velocities(end, p),
            compose_.add(Opcode::subtract, call_dynamics_output(OutputKind::momentum, longest),
                         expected)};
  }

 private:
  /// One of the outputs that `dynamics` computes together.
  InstructionIndices call_dynamics_output(OutputKind kind, const CallPoint& at) {
    const Function& all = *find_function(step_.callees, OutputKind::dynamics);
    const auto field = std::ranges::find(all.fields, output_row(kind).name, &Field::name);
    return compose_.inline_call(step_.callees, all, *field, at);
  }

  /// dL/dq + B u + Q - dD/dv
  InstructionIndices rate_of_momentum(const CallPoint& at) {
    InstructionIndices sum =
        compose_.add(Opcode::add, call_dynamics_output(OutputKind::position_gradient, at),
                     call_dynamics_output(OutputKind::applied_force, at));
    sum = compose_.add(Opcode::subtract, sum, call_dynamics_output(OutputKind::dissipation, at));
    const std::size_t inputs = step_.model.inputs.size();
    if (inputs == 0) return sum;
    const InstructionIndices u = compose_.add_leaves(Opcode::input, inputs);
    const InstructionIndices b = call_dynamics_output(OutputKind::input_matrix, at);
    for (std::size_t i = 0; i < b.size(); ++i) {
      std::uint32_t& entry = sum[i / inputs];
      entry = compose_.add(Opcode::add, entry, compose_.add(Opcode::multiply, b[i], u[i % inputs]));
    }
    return sum;
  }

  /// M^-1 (p - b) at the position and time of `at`; at.v is ignored.
  InstructionIndices solve_velocities(CallPoint at, const InstructionIndices& p) {
    const MassFactorisation mass(compose_, elimination_order(step_.model),
                                 call_dynamics_output(OutputKind::mass_matrix, at));
    at.v.assign(p.size(), compose_.add_number(0));
    return mass.solve(
        compose_.add(Opcode::subtract, p, call_dynamics_output(OutputKind::momentum, at)));
  }

  /// The midpoint m of the part of the step that begins at `begin` with p; m.v is the last w.
  CallPoint solve_midpoint(const CallPoint& begin, const InstructionIndices& p,
                           const cln::cl_RA& length) {
    const std::uint32_t half = step_.step_multiple(length / 2);
    CallPoint at = begin;
    for (std::uint32_t i = 0;; ++i) {
      at.q = compose_.add_scaled(begin.q, half, at.v);
      at.t = step_.time_at_fraction(time_ + length / 2);
      ++at.number;
      step_.name_entries(at);
      if (i == step_.iterations) return at;
      at.v = solve_velocities(at, compose_.add_scaled(p, half, rate_of_momentum(at)));
    }
  }

  const StepContext& step_;
  Composition& compose_;
  cln::cl_RA time_ = 0;  ///< start of the part, in units of h
};

}  // namespace

NextState compose_midpoint(const StepContext& step) { return Midpoint(step)(); }

}  // namespace elgen
