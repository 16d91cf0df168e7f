// Reduction: what `drop_below` left out of the closed forms, and how far they are off by it at
// most, over the declared ranges.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <string>
#include <vector>

#include "elgen/outputs.hpp"

namespace elgen {

struct DroppedTerm {
  OutputKind output = {};
  std::uint32_t row = 0;
  std::uint32_t column = 0;
  std::string text = {};  ///< in the model language
  cln::cl_RA bound = 0;   ///< of its magnitude
};

/// |reduced - exact| <= constant + sum_j by_acceleration[j] |a_j|: accelerations have no ranges.
struct EntryError {
  cln::cl_RA constant = 0;
  std::vector<cln::cl_RA> by_acceleration = {};  ///< of inverse dynamics; elsewhere empty
  std::optional<cln::cl_RA> largest = {};        ///< bound of the entry's largest term, if known
};

struct ReducedOutput {
  OutputKind kind = {};
  std::uint32_t columns = 1;
  std::vector<EntryError> errors = {};  ///< one per entry, row-major
};

struct Reduction {
  cln::cl_RA below = 0;  ///< the share of the largest term of its entry
  std::vector<DroppedTerm> terms = {};
  std::vector<ReducedOutput> outputs = {};  ///< outputs that differ from the exact model's, and M
};

/// Null where the output is exact.
[[nodiscard]] const ReducedOutput* find_reduced(const Reduction& reduction, OutputKind kind);

}  // namespace elgen
