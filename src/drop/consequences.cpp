// One row per output that is made of parts, in the notation of the table of outputs.
#include "drop/consequences.hpp"

#include "present/rates.hpp"

namespace elgen {

using cln::cl_RA;

using K = OutputKind;

/// Parts of which nothing was dropped lose nothing.
Consequences::Consequences(Arithmetic& arithmetic, const Algebra& algebra, std::size_t size,
                           const DroppedParts& dropped)
    : arithmetic_(arithmetic), algebra_(algebra), size_(size), known_(dropped) {
  known_.try_emplace(K::mass_matrix, zeros(size * size));
  known_.try_emplace(K::potential_energy, zeros(1));
  for (const K forces : {K::dissipation, K::applied_force}) known_.try_emplace(forces, zeros(size));
}

const Values& Consequences::of(OutputKind output) & {
  const auto known = known_.find(output);
  return known != known_.end() ? known->second : known_[output] = found(output);
}

Values Consequences::found(OutputKind output) {
  using Self = Consequences&;
  static const std::map<K, Values (*)(Self)> rules{
      {K::coriolis_matrix, [](Self c) { return c.coriolis(); }},
      {K::velocity_force,
       [](Self c) { return c.times(c.of(K::coriolis_matrix), Opcode::velocity); }},
      {K::gravity, [](Self c) { return c.gravity(); }},
      {K::drift, [](Self c) { return c.drift(); }},
      {K::bias, [](Self c) { return c.bias(); }},
      {K::momentum, [](Self c) { return c.times(c.of(K::mass_matrix), Opcode::velocity); }},
      {K::position_gradient, [](Self c) { return c.position_gradient(); }},
      {K::kinetic_energy, [](Self c) { return c.kinetic_energy(); }},
      {K::total_energy, [](Self c) { return c.energy(); }},
      {K::energy_function, [](Self c) { return c.energy(); }},
      {K::inverse_dynamics, [](Self c) { return c.inverse_dynamics(); }},
  };
  const auto rule = rules.find(output);
  return rule == rules.end() ? Values() : rule->second(*this);
}

Value Consequences::slope(const Value& x, std::size_t coordinate) {
  if (!x || x->numerator.empty()) return x;
  return rate(arithmetic_, algebra_, *x, along_coordinate(coordinate, size_));
}

Values Consequences::sum(Values x, const Values& y, int sign) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = arithmetic_.add(x[i], sign < 0 ? arithmetic_.negate(y[i]) : y[i]);
  }
  return x;
}

/// matrix v, or matrix a.
Values Consequences::times(const Values& matrix, Opcode vector) {
  Values result = zeros(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      const Value factor = arithmetic_.leaf(vector, static_cast<std::uint32_t>(j));
      result[i] = arithmetic_.add(result[i], arithmetic_.multiply(matrix[i * size_ + j], factor));
    }
  }
  return result;
}

/// C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) v_k
Values Consequences::coriolis() {
  const Value half = fraction_of(cl_RA(1) / 2);
  Values result = zeros(size_ * size_);
  const auto mass = [&](std::size_t i, std::size_t j) { return of(K::mass_matrix)[i * size_ + j]; };
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) {
      for (std::size_t k = 0; k < size_; ++k) {
        const Value symmetric = arithmetic_.add(slope(mass(i, j), k), slope(mass(i, k), j));
        const Value symbol = arithmetic_.subtract(symmetric, slope(mass(j, k), i));
        const Value rate_k = arithmetic_.leaf(Opcode::velocity, static_cast<std::uint32_t>(k));
        const Value term = arithmetic_.multiply(half, arithmetic_.multiply(symbol, rate_k));
        result[i * size_ + j] = arithmetic_.add(result[i * size_ + j], term);
      }
    }
  }
  return result;
}

/// g = dV0/dq
Values Consequences::gravity() {
  Values result;
  const Value potential = of(K::potential_energy)[0];
  for (std::size_t i = 0; i < size_; ++i) result.push_back(slope(potential, i));
  return result;
}

/// d(T - V0)/dq
Values Consequences::position_gradient() {
  Values result;
  const Value kinetic = of(K::kinetic_energy)[0];
  for (std::size_t i = 0; i < size_; ++i) result.push_back(slope(kinetic, i));
  return sum(std::move(result), of(K::gravity), -1);
}

/// Of drift only (dM/dt) v holds M.
Values Consequences::drift() {
  Values explicit_rate;
  for (const Value& entry : of(K::mass_matrix)) {
    explicit_rate.push_back(entry ? rate(arithmetic_, algebra_, *entry, along_time(size_))
                                  : std::nullopt);
  }
  return times(explicit_rate, Opcode::velocity);
}

/// C v + drift + g + dD/dv - Q
Values Consequences::bias() {
  Values result = of(K::velocity_force);
  for (const OutputKind part : {K::drift, K::gravity, K::dissipation}) {
    result = sum(std::move(result), of(part));
  }
  return sum(std::move(result), of(K::applied_force), -1);
}

/// M a + bias
Values Consequences::inverse_dynamics() {
  return sum(times(of(K::mass_matrix), Opcode::acceleration), of(K::bias));
}

/// T + V0
Values Consequences::energy() { return sum(of(K::kinetic_energy), of(K::potential_energy)); }

/// 1/2 v.M v
Values Consequences::kinetic_energy() {
  Value total = Fraction{};
  const Values momentum = of(K::momentum);
  for (std::size_t i = 0; i < size_; ++i) {
    const Value v = arithmetic_.leaf(Opcode::velocity, static_cast<std::uint32_t>(i));
    total = arithmetic_.add(total, arithmetic_.multiply(momentum[i], v));
  }
  return {arithmetic_.multiply(total, fraction_of(cl_RA(1) / 2))};
}

}  // namespace elgen
