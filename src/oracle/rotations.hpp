// Rotations on jets: unit quaternions and the directions in which velocities move them.
#pragma once

#include <array>

#include "elgen/model.hpp"
#include "oracle/evaluation.hpp"

namespace elgen::oracle {

using Quaternion = std::array<Jet, quaternion_size>;  ///< w, x, y, z
using Spin = std::array<Jet, axis_count>;             ///< in the axes of the body

/// 1/2 e (0, w): the rate of e where the body turns with w.
[[nodiscard]] Quaternion rate_of(const Quaternion& e, const Spin& w);

[[nodiscard]] Quaternion quaternion_of(const Rotation& rotation, const std::vector<Jet>& q);
[[nodiscard]] Spin spin_of(const Rotation& rotation, const std::vector<Jet>& v);

/// dq/dt = N(q) v
[[nodiscard]] std::vector<Jet> coordinate_rates(const Model& model, const std::vector<Jet>& q,
                                                const std::vector<Jet>& v);

/// w x y on the velocities of rotations, all else 0.
[[nodiscard]] std::vector<cln::cl_R> turned(const Model& model, const std::vector<cln::cl_R>& w,
                                            const std::vector<cln::cl_R>& y);
[[nodiscard]] std::vector<Jet> turned(const Model& model, const std::vector<Jet>& w,
                                      const std::vector<Jet>& y);

/// q with every quaternion divided by its length.
[[nodiscard]] std::vector<cln::cl_R> normalized(const Model& model, std::vector<cln::cl_R> q);

}  // namespace elgen::oracle
