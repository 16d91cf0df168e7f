// KDL and MuJoCo for timing. All memory is allocated before the first call.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace bench {

using Evaluate = std::function<void(const double* q, const double* v, const double* a)>;

struct OtherProgram {
  const char* name;
  Evaluate mass_matrix, bias, inverse_dynamics;
};

/// M, bias and inverse dynamics of the robot in the file `description` by each installed program.
/// Only MuJoCo reads URDF.
[[nodiscard]] std::vector<OtherProgram> other_programs(const std::filesystem::path& description);

}  // namespace bench
