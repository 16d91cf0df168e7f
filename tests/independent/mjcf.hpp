// A robot in MuJoCo's modelling language.
#pragma once

#include <string>

namespace elgen::test {

struct Robot;

/// Only bodies, joints and inertias: nothing is seen and nothing touches.
[[nodiscard]] std::string mjcf(const Robot& robot);

}  // namespace elgen::test
