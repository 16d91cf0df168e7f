// JointProgram: functions of two versions over the leaves of both, which meet by their names.
//
//     before  0 = parameter m  1 = velocity x  2 = multiply 0 1       result = 2
//     after   0 = parameter k  1 = parameter m  2 = velocity x  3 = multiply 1 2   result = 3
//     joint   0 = parameter m  1 = velocity x  2 = multiply 0 1       before = 2   after = 2
#pragma once

#include <optional>

#include "elgen/diff.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Numbers that stand for parameters of each version.
struct JointValues {
  ParameterValues before = {};
  ParameterValues after = {};
};

/// Entries of one output in both versions; one function computes them all, nothing twice.
struct JointFunction {
  Function function = {};
  std::vector<std::uint32_t> before = {};
  std::vector<std::uint32_t> after = {};
};

class JointProgram {
 public:
  /// Names of `before` are turned into those of `after` first.
  JointProgram(const Program& before, const Program& after, const Renames& renames);

  /// Entries of two functions of the programs, in the order of their fields.
  [[nodiscard]] JointFunction joined(const Function& before, const Function& after,
                                     const JointValues& values = {});

  /// The leaves of both, with the constants of what was joined so far.
  [[nodiscard]] const Program& program() const { return joint_; }

 private:
  /// Where a leaf of a version is among those of both.
  using LeafPlaces = LeafValues<std::uint32_t>;
  LeafPlaces add(const LeafNames& names);

  const Program& before_;
  const Program& after_;
  Program joint_ = {};
  LeafPlaces old_places_ = {};
  LeafPlaces new_places_ = {};
};

}  // namespace elgen
