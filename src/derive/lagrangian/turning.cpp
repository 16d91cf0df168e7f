// Turning: terms for models that have quaternions as coordinates and angular velocities as
// velocities.
#include "derive/lagrangian/turning.hpp"

#include "derive/lagrangian/vector_algebra.hpp"

namespace elgen {

using GiNaC::ex;

RealVector project_to_velocities(Derivation& derivation, const RealVector& by_coordinates) {
  const Symbols& symbols = derivation.symbols;
  if (symbols.rotations.empty()) return by_coordinates;
  RealVector result(symbols.v.size());
  for (std::size_t i = 0, j = 0, next = 0; i < symbols.q.size();) {
    const bool is_rotation =
        next < symbols.rotations.size() && symbols.rotations[next].first_coordinate == i;
    if (!is_rotation) {
      result[j++] = by_coordinates[i++];
      continue;
    }
    const auto n = rate_matrix(symbols, symbols.rotations[next++]);
    std::array<ex, quaternion_size> slopes;
    for (ex& slope : slopes) slope = define(derivation.definitions, by_coordinates[i++]);
    for (std::size_t k = 0; k < axis_count; ++k) {
      GiNaC::exvector terms;
      for (std::size_t c = 0; c < quaternion_size; ++c) terms.push_back(n[c][k] * slopes[c]);
      result[j++] = GiNaC::add(terms);
    }
  }
  return result;
}

Seeds displacement_seeds(const Symbols& symbols, std::size_t velocity) {
  Seeds seeds;
  for (const RotationPlace& rotation : symbols.rotations) {
    if (velocity < rotation.first_velocity || velocity >= rotation.first_velocity + axis_count) {
      continue;
    }
    const auto n = rate_matrix(symbols, rotation);
    for (std::size_t c = 0; c < quaternion_size; ++c) {
      seeds.emplace(symbols.q[rotation.first_coordinate + c],
                    n[c][velocity - rotation.first_velocity]);
    }
    return seeds;
  }
  for (std::size_t i = 0; i < symbols.q.size(); ++i) {
    if (symbols.q_rates[i].is_equal(symbols.v[velocity])) seeds.emplace(symbols.q[i], 1);
  }
  return seeds;
}

RealVector hamel_force(Derivation& derivation, const RealVector& momentum) {
  RealVector result(momentum.size());
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    const std::size_t first = rotation.first_velocity;
    for (const auto& [k, i, j] : cyclic_axes) {
      result[first + k] = derivation.symbols.v[first + i] * momentum[first + j] -
                          derivation.symbols.v[first + j] * momentum[first + i];
    }
  }
  return result;
}

void add_rotation_terms(Derivation& derivation, const RealVector& mass, RealVector& entries) {
  const std::size_t n = derivation.size();
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    const std::size_t first = rotation.first_velocity;
    // Column k of M [w]x is m_i w_j - m_j w_i, with (k, i, j) cyclic and m_i column i of M.
    for (const auto& [k, i, j] : cyclic_axes) {
      for (std::size_t row = 0; row < n; ++row) {
        const ex turned = mass[row * n + first + i] * derivation.symbols.v[first + j] -
                          mass[row * n + first + j] * derivation.symbols.v[first + i];
        entries[row * n + first + k] += turned / 2;
      }
    }
  }
}

RealVector coordinate_rates(const Derivation& derivation) { return derivation.symbols.q_rates; }

RealVector normalized(Derivation& derivation) {
  RealVector result = derivation.symbols.q;
  for (const RotationPlace& rotation : derivation.symbols.rotations) {
    const auto begin = result.begin() + rotation.first_coordinate;
    GiNaC::exvector squares;
    for (auto component = begin; component != begin + quaternion_size; ++component) {
      squares.push_back(*component * *component);
    }
    const ex length = define(derivation.definitions, GiNaC::sqrt(GiNaC::add(squares)));
    for (auto component = begin; component != begin + quaternion_size; ++component) {
      *component = *component / length;
    }
  }
  return result;
}

}  // namespace elgen
