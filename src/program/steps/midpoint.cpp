// The implicit midpoint rule on q and p = M v + b, by successive substitution, starting with w = v.
// At m = (q + h/2 w, w, t + h/2):
//
//     M(m) w = p + h/2 dp/dt(m) - b(m)        dp/dt = dL/dq + F,   F = B u + Q - dD/dv
//
// With the last w: q += h w, p += h dp/dt(m).
//
// If no force acts on a cyclic coordinate, its momentum is exact after any number of substitutions.
// Each substitution multiplies the error of w by about h/2 |M^-1 (dp/dq - d2L/dv dq)|. Newton's
// method would need half as many substitutions, but each would also need a Coriolis matrix and the
// elimination of an unsymmetric matrix. M is evaluated at each point to keep the bound on rounding
// errors small: w -= M^-1 r(w) would multiply the bound by 1 + cond M each time; here it shrinks
// with the error.
//
// Hairer, Lubich, Wanner, Geometric Numerical Integration, 2nd ed., sec. VIII.6.
#include <algorithm>

#include "program/evaluate/subject.hpp"
#include "program/steps/methods.hpp"

namespace elgen {
namespace {

class Midpoint {
 public:
  explicit Midpoint(const StepContext& step) : step_(step), compose_(step.compose) {}

  /// p passes through the parts of the step; v is computed after the last part. The last w of a
  /// part is the first w of the next part.
  NextState operator()() {
    Places p = part(OutputKind::momentum, step_.start);
    CallPoint end = step_.start;
    CallPoint longest;
    Places expected;
    for (std::size_t i = 0; i < step_.parts.size(); ++i) {
      const cln::cl_RA& length = step_.parts[i];
      const CallPoint at = solve_midpoint(end, p, length);
      const Places rate = rate_of_momentum(at);
      if (i == step_.parts.size() / 2) {
        expected = compose_.add_scaled(p, step_.part(length / 2), rate);
        longest = at;
      }
      time_ = time_ + length;
      end.q = compose_.add_scaled(end.q, step_.part(length), at.v);
      end.v = at.v;
      end.t = step_.time_at(time_);
      end.number = at.number + 1;
      compose_.name(end.q, Opcode::coordinate, end.number);
      p = compose_.add_scaled(p, step_.part(length), rate);
    }
    return {end.q, velocities(end, p),
            compose_.add(Opcode::subtract, part(OutputKind::momentum, longest), expected)};
  }

 private:
  /// One of the outputs that `dynamics` computes together.
  Places part(OutputKind kind, const CallPoint& at) {
    const Function& all = *find_function(step_.calls, OutputKind::dynamics);
    const auto field = std::ranges::find(all.fields, output_row(kind).name, &Field::name);
    return compose_.call(step_.calls, all, *field, at);
  }

  /// dL/dq + B u + Q - dD/dv
  Places rate_of_momentum(const CallPoint& at) {
    Places sum = compose_.add(Opcode::add, part(OutputKind::position_gradient, at),
                              part(OutputKind::applied_force, at));
    sum = compose_.add(Opcode::subtract, sum, part(OutputKind::dissipation, at));
    const std::size_t inputs = step_.model.inputs.size();
    if (inputs == 0) return sum;
    const Places u = compose_.leaves(Opcode::input, inputs);
    const Places b = part(OutputKind::input_matrix, at);
    for (std::size_t i = 0; i < b.size(); ++i) {
      std::uint32_t& entry = sum[i / inputs];
      entry = compose_.add(Opcode::add, entry, compose_.add(Opcode::multiply, b[i], u[i % inputs]));
    }
    return sum;
  }

  /// M^-1 (p - b) at a point; its v is ignored.
  Places velocities(CallPoint at, const Places& p) {
    const MassFactorisation mass(compose_, elimination_order(step_.model),
                                 part(OutputKind::mass_matrix, at));
    at.v.assign(p.size(), compose_.number(0));
    return mass.solve(compose_.add(Opcode::subtract, p, part(OutputKind::momentum, at)));
  }

  /// The midpoint of the part of the step that begins at `begin` with p, with the last w.
  CallPoint solve_midpoint(const CallPoint& begin, const Places& p, const cln::cl_RA& length) {
    const std::uint32_t half = step_.part(length / 2);
    CallPoint at = begin;
    for (std::uint32_t i = 0;; ++i) {
      at.q = compose_.add_scaled(begin.q, half, at.v);
      at.t = step_.time_at(time_ + length / 2);
      ++at.number;
      step_.name(at);
      if (i == step_.iterations) return at;
      at.v = velocities(at, compose_.add_scaled(p, half, rate_of_momentum(at)));
    }
  }

  const StepContext& step_;
  Composition& compose_;
  cln::cl_RA time_ = 0;  ///< start of the part, in units of h
};

}  // namespace

NextState compose_midpoint(const StepContext& step) { return Midpoint(step)(); }

}  // namespace elgen
