// witness: how much entries change, and a state at which it is seen.
#pragma once

#include "diff/joint_program.hpp"
#include "elgen/diff.hpp"
#include "evaluate/subject.hpp"

namespace elgen {

/// States of the newer version inside its ranges, over the leaves of both: parameters have their
/// values, those of value 0 are drawn, and what only the older version has is as it was there.
class WitnessStates {
 public:
  WitnessStates(const Version& before, const Version& after, const Program& joint);

  /// Fills share and witness of a change between two instructions of a function.
  void tell(const Function& function, std::uint32_t before, std::uint32_t after,
            EntryChange& change) const;

 private:
  const Program& joint_;
  std::vector<Arguments<double>> states_ = {};
  LeafValues<double> known_ = {};  ///< parameters at their values, which a witness does not list
};

}  // namespace elgen
