// Foreign: functions that elgen did not write, judged by the oracle.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A function of the code, and the output that it should be.
struct ForeignClaim {
  std::string output = {};
  std::string field = {};  ///< the field that it should be alone; empty: as many as it answers
  std::string name = {};
};

struct ForeignOptions {
  std::string code = {};  ///< as of a ForeignFunction
  std::vector<ForeignClaim> claims = {};
  double tolerance = 1e-9;  ///< of the largest entry
  std::size_t states = 60;
  std::uint64_t seed = 1;
  std::uint64_t seconds = 60;  ///< by the clock, for one function
};

/// A row for each claim: values are compared with 60 digits at states in the declared ranges, at
/// rest, with inputs alone, moving, both, and with other parameters; with constraints at states
/// that are moved onto them, and states that no step of Newton puts there are counted as skipped.
/// The count of numbers says which fields an answer has: the first, all without pivots and
/// remainders, all, or another one alone. Where they differ the row finds when, under which
/// convention they would be right at all states, and which parameters the code ignores; a
/// diagnostic E717 says so, too. The scene has the outputs. E601 of a name that is not one output
/// or field, E603 of `dynamics`, which has no field of its own; E716 if nothing can be called.
/// Cost: the oracle at each state, and once for each of up to 300 conventions if answers differ.
[[nodiscard]] Result<Verification> judge_foreign(const CheckedModel& checked,
                                                 const ForeignOptions& options);

}  // namespace elgen
