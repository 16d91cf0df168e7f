// Foreign: compares foreign functions, which elgen did not write, with the oracle.
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
  /// The only field that the function computes; "": the fields follow from the number of results.
  std::string field = {};
  std::string name = {};
};

struct ForeignOptions {
  std::string code = {};  ///< as ForeignFunction::code
  std::vector<ForeignClaim> claims = {};
  double tolerance = 1e-9;  ///< allowed error of an entry / largest |entry| of the field
  std::size_t states = 60;
  std::uint64_t seed = 1;
  std::uint64_t seconds = 60;  ///< wall-clock limit for one function, in s
};

/// Returns one row for each claim. The values of the code are compared with the oracle's values at
/// states in the declared ranges: at rest; at rest with inputs and accelerations; moving; moving
/// with inputs and accelerations; and with other parameters.
/// If the model has constraints, Newton's method first moves each state onto the constraints; a
/// state at which the method fails is skipped. The number of results selects the fields. The first
/// choice that fits is used: the first field; all fields without pivots and remainders; all fields;
/// another single field.
///
/// For a wrong function, the row and a diagnostic E717 report the kinds of states with wrong
/// values, the convention (such as the sign of a coordinate) under which all values would be right,
/// and the ignored parameters. The scene must contain the outputs. E601: the scene lacks the
/// output, or the output lacks the field. E603: a claim names `dynamics`, which only repeats other
/// outputs. E716: the function cannot be called. Cost: the oracle at each state; for wrong results,
/// once more for each of up to 300 conventions.
[[nodiscard]] Result<Verification> compare_foreign_code(const CheckedModel& checked,
                                                        const ForeignOptions& options);

}  // namespace elgen
