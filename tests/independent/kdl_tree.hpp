// A robot as KDL describes it.
#pragma once

#include <kdl/tree.hpp>

namespace elgen::test {

struct Robot;

[[nodiscard]] KDL::Tree kdl_tree(const Robot& robot);

/// Base to the last link, of a robot without branches.
[[nodiscard]] KDL::Chain kdl_chain(const Robot& robot);

[[nodiscard]] KDL::Vector kdl_gravity();

}  // namespace elgen::test
