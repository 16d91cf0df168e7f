// Foreign: compares functions that elgen did not write with the oracle.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elgen/certificate.hpp"
#include "elgen/diagnostic.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A function of the foreign code, and the output that it claims to compute.
struct ForeignClaim {
  std::string output = {};
  /// The only field that it computes; "": the number of its results decides.
  std::string field = {};
  std::string name = {};
};

struct ForeignOptions {
  std::string code = {};  ///< as ForeignFunction::code
  std::vector<ForeignClaim> claims = {};
  double tolerance = 1e-9;  ///< relative to the largest entry of the field
  std::size_t states = 60;
  std::uint64_t seed = 1;
  std::uint64_t seconds = 60;  ///< wall-clock limit for one function, in s
};

/// Returns one row for each claim. Values are compared with 60 digits at states in the declared
/// ranges: at rest, with inputs alone, moving, both, and with other parameters. With constraints
/// the states are moved onto them; states for which Newton's method fails count as skipped. The
/// number of results selects the fields: the first, all without pivots and remainders, all, or
/// another single field. For a wrong function the row reports the situations with wrong values, the
/// convention under which all values would be right, and the ignored parameters. A diagnostic E717
/// repeats this. The scene must contain the outputs. E601: a name is not one output or field. E603:
/// `dynamics`, which only repeats other outputs. E716: the function cannot be called. Cost: the
/// oracle at each state; for wrong results, once more for each of up to 300 conventions.
[[nodiscard]] Result<Verification> compare_foreign_code(const CheckedModel& checked,
                                                        const ForeignOptions& options);

}  // namespace elgen
