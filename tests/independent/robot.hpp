// The description that the independent programs read: a tree of rigid links with revolute joints,
// from JSON. tests/reference/panda7.json explains the numbers.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "independent/oracle.hpp"

namespace elgen::test {

using Triple = std::array<double, 3>;

/// x_parent = Rx(quarter_turns * 90 degrees) Rz(q) x + translation.
struct Link {
  int parent;         ///< index of an earlier link, or -1 for the base
  int quarter_turns;  ///< -1, 0 or 1
  Triple translation;
  double mass;
  Triple com;
  std::array<double, 6> inertia;  ///< about com: xx yy zz xy xz yz
};

/// One state and its reference values from another source, to 12 digits.
struct ReferenceValues {
  State state;
  std::vector<double> torque;
  std::vector<double> first_row_of_mass_matrix;
  std::vector<double> gravity;
};

struct Robot {
  std::string name;
  bool floating;  ///< true if the first link is free; otherwise it turns about its z axis
  std::vector<Link> links = {};
  std::optional<ReferenceValues> reference = {};
};

inline constexpr double gravity_of_earth = 9.81;  ///< along -z of the base

/// Reads a robot; "parents" has the parent of each link, depth first, or is absent for a chain.
[[nodiscard]] Robot read_robot(const std::filesystem::path& path, bool floating = false);

/// True if the parent of every link is the link before it.
[[nodiscard]] bool is_chain(const Robot& robot);

}  // namespace elgen::test
