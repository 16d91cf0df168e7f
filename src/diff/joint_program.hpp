// JointProgram: functions of two versions over the leaves of both, which meet by their names, and
// the entries that mean the same in both: of M those of the same two coordinates, wherever they
// stand.
//
//     before  0 = parameter m  1 = velocity x  2 = multiply 0 1       result = 2
//     after   0 = parameter k  1 = parameter m  2 = velocity x  3 = multiply 1 2   result = 3
//     joint   0 = parameter m  1 = velocity x  2 = multiply 0 1       before = 2   after = 2
#pragma once

#include <optional>
#include <vector>

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

/// An entry, numbered over all fields, of either version.
struct MatchedEntry {
  std::optional<std::size_t> before = {};
  std::optional<std::size_t> after = {};
  std::string place = {};  ///< "mass_matrix[1,2]": of the newer version where it is there
  std::string unit = {};
};

/// The entries of two functions of one name, in the order of `after`; removed ones last. Nothing
/// matches an empty function.
[[nodiscard]] std::vector<MatchedEntry> matched_entries(const Model& old_model,
                                                        const Function& before,
                                                        const Model& new_model,
                                                        const Function& after,
                                                        const Renames& renames);

}  // namespace elgen
