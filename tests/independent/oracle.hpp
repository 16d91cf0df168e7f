// The quantities that every independent program computes at a state: M, bias and inverse dynamics.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace elgen::test {

/// A free base comes first: in q its position x y z and quaternion w x y z; in v the velocity of
/// its origin in world axes, then its angular velocity in body axes; in a the derivative of v.
struct State {
  std::vector<double> q, v, a;
};

struct Dynamics {
  std::vector<double> mass_matrix;  ///< row-major
  std::vector<double> bias;         ///< inverse dynamics for a = 0
  std::vector<double> torque;       ///< inverse dynamics
};

using Oracle = std::function<Dynamics(const State&)>;

/// Orocos KDL with its solvers for chains or for trees. Reads a description in JSON; no free base.
[[nodiscard]] Oracle kdl_oracle(const std::filesystem::path& description, bool floating);

/// MuJoCo. Reads a description in JSON, or in URDF with MuJoCo's own reader.
[[nodiscard]] Oracle mujoco_oracle(const std::filesystem::path& description, bool floating);

}  // namespace elgen::test
