// KDL and MuJoCo for timing: everything they allocate stands before the first call.
#pragma once

#include <functional>
#include <vector>

#include "independent/robot.hpp"

namespace bench {

using Evaluate = std::function<void(const double* q, const double* v, const double* a)>;

struct OtherProgram {
  const char* name;
  Evaluate mass_matrix, bias, inverse_dynamics;
};

/// The arm by each program that is installed.
[[nodiscard]] std::vector<OtherProgram> other_programs(const elgen::test::Robot& robot);

}  // namespace bench
