// Converts a robot to KDL's description.
#pragma once

#include <kdl/tree.hpp>

namespace elgen::test {

struct Robot;

[[nodiscard]] KDL::Tree kdl_tree(const Robot& robot);

/// The chain from the base to the last link; the robot has no branches.
[[nodiscard]] KDL::Chain kdl_chain(const Robot& robot);

[[nodiscard]] KDL::Vector kdl_gravity();

}  // namespace elgen::test
