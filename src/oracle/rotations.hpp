// Rotations as unit quaternions with jets as components, and their rates.
#pragma once

#include <array>

#include "elgen/model.hpp"
#include "oracle/evaluation.hpp"

namespace elgen::oracle {

using Quaternion = std::array<Jet, quaternion_size>;  ///< w, x, y, z
using Spin = std::array<Jet, axis_count>;             ///< in the axes of the body

/// 1/2 e (0, w): the rate of e at angular velocity w in body axes.
[[nodiscard]] Quaternion quaternion_derivative(const Quaternion& e, const Spin& w);

[[nodiscard]] Quaternion quaternion_of(const Rotation& rotation, const std::vector<Jet>& q);
[[nodiscard]] Spin spin_of(const Rotation& rotation, const std::vector<Jet>& v);

/// dq/dt = N(q) v
[[nodiscard]] std::vector<Jet> coordinate_rates(const Model& model, const std::vector<Jet>& q,
                                                const std::vector<Jet>& v);

/// w x y on the velocities of rotations, 0 elsewhere.
template <class Number>
[[nodiscard]] std::vector<Number> cross_on_rotations(const Model& model,
                                                     const std::vector<Number>& w,
                                                     const std::vector<Number>& y) {
  std::vector<Number> result(w.size(), Number(0));
  for (const Rotation& rotation : model.rotations) {
    const std::uint32_t first = rotation.first_velocity;
    for (std::uint32_t k = 0; k < axis_count; ++k) {
      const std::uint32_t i = first + (k + 1) % axis_count;
      const std::uint32_t j = first + (k + 2) % axis_count;
      result[first + k] = w[i] * y[j] - w[j] * y[i];
    }
  }
  return result;
}

/// q with every quaternion divided by its length.
[[nodiscard]] std::vector<cln::cl_R> normalize_quaternions(const Model& model,
                                                           std::vector<cln::cl_R> q);

}  // namespace elgen::oracle
