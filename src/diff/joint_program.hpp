// JointProgram: joins functions of two versions into one. Leaves of both versions are matched by
// name, entries by meaning: an entry of M by its two coordinates, at any position.
//
//     before  0 = parameter m  1 = velocity x  2 = multiply 0 1       result = 2
//     after   0 = parameter k  1 = parameter m  2 = velocity x  3 = multiply 1 2   result = 3
//     joint   0 = parameter m  1 = velocity x  2 = multiply 0 1       before = 2   after = 2
//             3 = parameter k
#pragma once

#include <optional>
#include <vector>

#include "elgen/diff.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// Numbers that replace parameters, by version.
struct JointParameterValues {
  ParameterValues before = {};
  ParameterValues after = {};
};

/// One function that computes the entries of one output in both versions, with common
/// subexpressions. `before` and `after`: for each entry, the index of its instruction.
struct JointFunction {
  Function function = {};
  std::vector<std::uint32_t> before = {};
  std::vector<std::uint32_t> after = {};
};

class JointProgram {
 public:
  /// `renames`: names of `before` -> names of `after`.
  JointProgram(const Program& before, const Program& after, const Renames& renames);

  /// Joins two functions, one of each program. Entries are in the order of their fields.
  [[nodiscard]] JointFunction join(const Function& before, const Function& after,
                                   const JointParameterValues& values = {});

  /// The leaves of both versions, and the constants of all functions joined so far.
  [[nodiscard]] const Program& program() const { return joint_; }

 private:
  /// For each leaf of a version, its index among the leaves of both versions.
  using LeafIndices = LeafValues<std::uint32_t>;
  LeafIndices add_leaves(const LeafNames& names);

  const Program& before_;
  const Program& after_;
  Program joint_ = {};
  LeafIndices old_places_ = {};
  LeafIndices new_places_ = {};
};

/// A pair of matching entries, by their indices over all fields. An added or removed entry has only
/// one index.
struct MatchedEntry {
  std::optional<std::size_t> before = {};
  std::optional<std::size_t> after = {};
  std::string place = {};  ///< "mass_matrix[1,2]", in the newer version if it has the entry
  std::string unit = {};
};

/// Matches the entries of two functions, in the order of `after`, then the removed entries. If one
/// function is empty, all entries of the other function are added or removed.
[[nodiscard]] std::vector<MatchedEntry> match_entries(const Model& old_model,
                                                      const Function& before,
                                                      const Model& new_model, const Function& after,
                                                      const Renames& renames);

}  // namespace elgen
