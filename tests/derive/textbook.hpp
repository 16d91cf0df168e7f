// The textbook derivation: write out L, differentiate, expand. Slow, but simple enough to be
// trusted. Q is the generalised force at u = 0.
//
//     tau = rate(dL/dv) - dL/dq + dD/dv - Q,    rate(f) = sum v df/dq + sum a df/dv + df/dt
#pragma once

#include <vector>

#include "derive/formulate/written_out.hpp"
#include "elgen/equations_of_motion.hpp"

namespace elgen::test {

class Textbook {
 public:
  explicit Textbook(const Lagrangian& lagrangian) : source_(lagrangian), s_(lagrangian.symbols) {
    for (const PointMass& mass : source_.masses) add_mass(mass);
    kinetic_ += sum(source_.kinetic);
    potential_ += sum(source_.potential);
    lagrangian_ = kinetic_ - potential_ + sum(source_.lagrangian);
  }

  [[nodiscard]] GiNaC::ex write_out(const GiNaC::ex& value) const {
    return written_out(source_.definitions, value);
  }

  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& value) const {
    GiNaC::ex result = derivative_by(value, s_.t);
    for (std::size_t i = 0; i < s_.q.size(); ++i) {
      result += derivative_by(value, s_.q[i]) * s_.v[i] + derivative_by(value, s_.v[i]) * s_.a[i];
    }
    return result;
  }

  /// Generalised force of all declared forces and inputs on coordinate i.
  [[nodiscard]] GiNaC::ex force(std::size_t i) const {
    GiNaC::ex result = write_out(source_.forces[i]);
    for (const PointForce& applied : source_.point_forces) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result += write_out(applied.force[axis]) *
                  derivative_by(write_out(applied.position[axis]), s_.q[i]);
      }
    }
    return result;
  }

  [[nodiscard]] GiNaC::ex applied_force(std::size_t i) const { return without_inputs(force(i)); }

  [[nodiscard]] GiNaC::ex without_inputs(GiNaC::ex value) const {
    for (const GiNaC::ex& u : s_.u) value = value.subs(u == 0);
    return value;
  }

  [[nodiscard]] GiNaC::ex at_rest(GiNaC::ex value) const {
    for (const GiNaC::ex& v : s_.v) value = value.subs(v == 0);
    return value;
  }

  [[nodiscard]] GiNaC::ex coasting(GiNaC::ex value) const {
    for (const GiNaC::ex& a : s_.a) value = value.subs(a == 0);
    return value;
  }

  [[nodiscard]] GiNaC::ex momentum(std::size_t i) const {
    return derivative_by(lagrangian_, s_.v[i]);
  }

  [[nodiscard]] GiNaC::ex position_gradient(std::size_t i) const {
    return derivative_by(lagrangian_, s_.q[i]);
  }

  [[nodiscard]] GiNaC::ex inverse_dynamics(std::size_t i) const {
    return rate(momentum(i)) - position_gradient(i) +
           derivative_by(write_out(sum(source_.dissipation)), s_.v[i]) - applied_force(i);
  }

  [[nodiscard]] GiNaC::ex bias(std::size_t i) const { return coasting(inverse_dynamics(i)); }

  [[nodiscard]] GiNaC::ex mass(std::size_t i, std::size_t j) const {
    return derivative_by(momentum(i), s_.v[j]);
  }

  /// C_ij = sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) v_k/2
  [[nodiscard]] GiNaC::ex coriolis(std::size_t i, std::size_t j) const {
    GiNaC::ex result = 0;
    for (std::size_t k = 0; k < s_.q.size(); ++k) {
      result += (derivative_by(mass(i, j), s_.q[k]) + derivative_by(mass(i, k), s_.q[j]) -
                 derivative_by(mass(j, k), s_.q[i])) *
                s_.v[k] / 2;
    }
    return result;
  }

  [[nodiscard]] GiNaC::ex velocity_force(std::size_t i) const {
    GiNaC::ex result = 0;
    for (std::size_t j = 0; j < s_.q.size(); ++j) result += coriolis(i, j) * s_.v[j];
    return result;
  }

  [[nodiscard]] GiNaC::ex gravity(std::size_t i) const {
    return derivative_by(at_rest(potential0()), s_.q[i]);
  }

  [[nodiscard]] GiNaC::ex drift(std::size_t i) const {
    return bias(i) - velocity_force(i) - gravity(i) -
           derivative_by(write_out(sum(source_.dissipation)), s_.v[i]) + applied_force(i);
  }

  [[nodiscard]] GiNaC::ex energy() const {
    GiNaC::ex result = -lagrangian_;
    for (std::size_t i = 0; i < s_.v.size(); ++i) result += s_.v[i] * momentum(i);
    return result;
  }

  [[nodiscard]] GiNaC::ex kinetic() const { return kinetic_; }
  [[nodiscard]] GiNaC::ex total() const { return kinetic_ + potential_; }
  [[nodiscard]] GiNaC::ex potential0() const { return at_rest(potential_); }

  [[nodiscard]] static GiNaC::ex derivative_by(const GiNaC::ex& value, const GiNaC::ex& symbol) {
    return value.diff(GiNaC::ex_to<GiNaC::symbol>(symbol));
  }

 private:
  [[nodiscard]] GiNaC::ex sum(const EnergyTerms& terms) const {
    GiNaC::ex result = 0;
    for (const EnergyTerm& term : terms) result += write_out(term.value);
    return result;
  }

  void add_mass(const PointMass& mass) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const GiNaC::ex position = write_out(mass.position[axis]);
      kinetic_ += write_out(mass.mass) * GiNaC::pow(rate(position), 2) / 2;
      if (source_.gravity)
        potential_ -= write_out(mass.mass) * write_out((*source_.gravity)[axis]) * position;
    }
  }

  const Lagrangian& source_;
  const Symbols& s_;
  GiNaC::ex kinetic_ = 0;
  GiNaC::ex potential_ = 0;
  GiNaC::ex lagrangian_ = 0;
};

}  // namespace elgen::test
