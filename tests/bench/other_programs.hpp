// KDL and MuJoCo for timing: everything they allocate stands before the first call.
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

/// The robot by each program that is installed; in URDF, for MuJoCo alone.
[[nodiscard]] std::vector<OtherProgram> other_programs(const std::filesystem::path& description);

}  // namespace bench
