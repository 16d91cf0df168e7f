// The quantities that every independent program computes: M, bias and inverse dynamics at a state.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace elgen::test {

/// A free base comes first: x y z and the quaternion w x y z in q; in v and a the velocity of its
/// origin in the axes of the world and the angular velocity in its own.
struct State {
  std::vector<double> q, v, a;
};

struct Dynamics {
  std::vector<double> mass_matrix;  ///< row-major
  std::vector<double> bias;         ///< inverse dynamics for a = 0
  std::vector<double> torque;       ///< inverse dynamics
};

using Oracle = std::function<Dynamics(const State&)>;

/// Orocos KDL, by its solvers for chains or for trees, of a description in JSON. No free base.
[[nodiscard]] Oracle kdl_oracle(const std::filesystem::path& description, bool floating);

/// MuJoCo, of a description in JSON, or in URDF by its own reader.
[[nodiscard]] Oracle mujoco_oracle(const std::filesystem::path& description, bool floating);

}  // namespace elgen::test
