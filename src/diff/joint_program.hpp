// JointProgram: functions of two versions over the leaves of both versions, which are matched by
// name. Entries are matched by meaning: an entry of M by its two coordinates, at any position.
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

/// Numbers that replace parameters of each version.
struct JointValues {
  ParameterValues before = {};
  ParameterValues after = {};
};

/// Entries of one output in both versions. One function computes all of them and shares common
/// subexpressions.
struct JointFunction {
  Function function = {};
  std::vector<std::uint32_t> before = {};
  std::vector<std::uint32_t> after = {};
};

class JointProgram {
 public:
  /// `renames` turns names of `before` into names of `after`.
  JointProgram(const Program& before, const Program& after, const Renames& renames);

  /// Joins two functions of the programs; entries are in the order of their fields.
  [[nodiscard]] JointFunction join(const Function& before, const Function& after,
                                   const JointValues& values = {});

  /// The leaves of both versions, with the constants of the functions joined so far.
  [[nodiscard]] const Program& program() const { return joint_; }

 private:
  /// The index of each leaf of a version among the leaves of both versions.
  using LeafPlaces = LeafValues<std::uint32_t>;
  LeafPlaces add(const LeafNames& names);

  const Program& before_;
  const Program& after_;
  Program joint_ = {};
  LeafPlaces old_places_ = {};
  LeafPlaces new_places_ = {};
};

/// A pair of entries, numbered over all fields. An added or removed entry has one number only.
struct MatchedEntry {
  std::optional<std::size_t> before = {};
  std::optional<std::size_t> after = {};
  std::string place = {};  ///< "mass_matrix[1,2]": in the newer version if it exists there
  std::string unit = {};
};

/// The entries of two functions of the same name, in the order of `after`; removed entries last.
/// Entries of an empty function have no match.
[[nodiscard]] std::vector<MatchedEntry> matched_entries(const Model& old_model,
                                                        const Function& before,
                                                        const Model& new_model,
                                                        const Function& after,
                                                        const Renames& renames);

}  // namespace elgen
