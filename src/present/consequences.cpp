// One line per output, in the notation of the table of outputs.
#include "consequences.hpp"

#include "rates.hpp"

namespace elgen::presenting {

using cln::cl_RA;

const Values& Consequences::of(OutputKind output) & {
  const auto known = known_.find(output);
  return known != known_.end() ? known->second : known_[output] = found(output);
}

Values Consequences::found(OutputKind output) {
  using K = OutputKind;
  switch (output) {
    case K::mass_matrix:
      return or_zeros(dropped_.mass_matrix, size_ * size_);
    case K::coriolis_matrix:
      return coriolis();
    case K::velocity_force:
      return times(of(K::coriolis_matrix), Opcode::velocity);
    case K::gravity:
      return gravity();
    case K::potential_energy:
      return or_zeros(dropped_.potential_energy, 1);
    case K::drift:
      return drift();
    case K::dissipation:
      return or_zeros(dropped_.dissipation, size_);
    case K::applied_force:
      return or_zeros(dropped_.applied_force, size_);
    case K::bias:
      return bias();
    case K::momentum:
      return times(of(K::mass_matrix), Opcode::velocity);
    case K::kinetic_energy:
      return kinetic_energy();
    case K::total_energy:
    case K::energy_function:
      return sum(of(K::kinetic_energy), of(K::potential_energy));
    case K::input_matrix:
      return dropped_.input_matrix;
    case K::inverse_dynamics:
      return sum(times(of(K::mass_matrix), Opcode::acceleration), of(K::bias));
    default:
      return {};
  }
}

Value Consequences::mass(std::size_t i, std::size_t j) const {
  return dropped_.mass_matrix.empty() ? Value(Fraction{}) : dropped_.mass_matrix[i * size_ + j];
}

Value Consequences::slope(const Value& x, std::size_t coordinate) {
  if (!x || x->numerator.empty()) return x;
  return rate(arithmetic_, algebra_, *x, along_coordinate(coordinate, size_));
}

Values Consequences::or_zeros(const Values& part, std::size_t count) const {
  return part.empty() ? zeros(count) : part;
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
  const Value potential = of(OutputKind::potential_energy)[0];
  for (std::size_t i = 0; i < size_; ++i) result.push_back(slope(potential, i));
  return result;
}

/// Of drift only (dM/dt) v holds M.
Values Consequences::drift() {
  Values explicit_rate;
  for (const Value& entry : of(OutputKind::mass_matrix)) {
    explicit_rate.push_back(entry ? rate(arithmetic_, algebra_, *entry, along_time(size_))
                                  : std::nullopt);
  }
  return times(explicit_rate, Opcode::velocity);
}

/// C v + drift + g + dD/dv - Q
Values Consequences::bias() {
  Values result = of(OutputKind::velocity_force);
  for (const OutputKind part : {OutputKind::drift, OutputKind::gravity, OutputKind::dissipation}) {
    result = sum(std::move(result), of(part));
  }
  return sum(std::move(result), of(OutputKind::applied_force), -1);
}

/// 1/2 v.M v
Values Consequences::kinetic_energy() {
  Value total = Fraction{};
  const Values momentum = of(OutputKind::momentum);
  for (std::size_t i = 0; i < size_; ++i) {
    const Value v = arithmetic_.leaf(Opcode::velocity, static_cast<std::uint32_t>(i));
    total = arithmetic_.add(total, arithmetic_.multiply(momentum[i], v));
  }
  return {arithmetic_.multiply(total, fraction_of(cl_RA(1) / 2))};
}

}  // namespace elgen::presenting
