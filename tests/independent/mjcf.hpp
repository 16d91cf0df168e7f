// Converts a robot to MJCF, MuJoCo's modelling language.
#pragma once

#include <string>

namespace elgen::test {

struct Robot;

/// `robot` as MJCF text, which contains only bodies, joints and inertias. There is no geometry, so
/// nothing is drawn and there are no contacts.
[[nodiscard]] std::string mjcf(const Robot& robot);

}  // namespace elgen::test
