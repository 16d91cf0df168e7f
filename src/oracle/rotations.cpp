// Rates and norms of quaternions, by products of quaternions.
#include "oracle/rotations.hpp"

#include "elgen/oracle.hpp"
#include "oracle/real_functions.hpp"

namespace elgen::oracle {

using cln::cl_R;

Quaternion quaternion_derivative(const Quaternion& e, const Spin& w) {
  const Jet half = Jet(cln::cl_RA(1) / 2);
  return {-(half * (e[1] * w[0] + e[2] * w[1] + e[3] * w[2])),
          half * (e[0] * w[0] + e[2] * w[2] - e[3] * w[1]),
          half * (e[0] * w[1] + e[3] * w[0] - e[1] * w[2]),
          half * (e[0] * w[2] + e[1] * w[1] - e[2] * w[0])};
}

Quaternion quaternion_of(const Rotation& rotation, const std::vector<Jet>& q) {
  const std::uint32_t first = rotation.first_coordinate;
  return {q[first], q[first + 1], q[first + 2], q[first + 3]};
}

Spin spin_of(const Rotation& rotation, const std::vector<Jet>& v) {
  const std::uint32_t first = rotation.first_velocity;
  return {v[first], v[first + 1], v[first + 2]};
}

std::vector<Jet> coordinate_rates(const Model& model, const std::vector<Jet>& q,
                                  const std::vector<Jet>& v) {
  std::vector<Jet> rates;
  for (const Coordinate& coordinate : model.coordinates) rates.push_back(v[coordinate.velocity]);
  for (const Rotation& rotation : model.rotations) {
    const Quaternion rate = quaternion_derivative(quaternion_of(rotation, q), spin_of(rotation, v));
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      rates[rotation.first_coordinate + i] = rate[i];
    }
  }
  return rates;
}

std::vector<cl_R> normalize_quaternions(const Model& model, std::vector<cl_R> q) {
  for (const Rotation& rotation : model.rotations) {
    const std::uint32_t first = rotation.first_coordinate;
    cl_R square = 0;
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      square = square + q[first + i] * q[first + i];
    }
    if (cln::zerop(square)) throw OutsideDomain("a quaternion of length 0");
    const cl_R length = real_power(square, cln::cl_RA(1) / 2);
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      q[first + i] = quotient(q[first + i], length);
    }
  }
  return q;
}

}  // namespace elgen::oracle

namespace elgen {

/// Sets e = (1 - p.p, 2 p) / (1 + p.p), with p the last three components of the given e.
void set_rational_quaternions(const Model& model, State& state) {
  for (const Rotation& rotation : model.rotations) {
    cln::cl_R* e = &state.q[rotation.first_coordinate];
    const cln::cl_R square = e[1] * e[1] + e[2] * e[2] + e[3] * e[3];
    e[0] = (1 - square) / (1 + square);
    for (std::size_t i = 1; i < quaternion_size; ++i) e[i] = 2 * e[i] / (1 + square);
  }
}

}  // namespace elgen
