// Expectation: the claim of an [[expect]] entry about an output or the motion.
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elgen/expression.hpp"
#include "elgen/opcodes.hpp"
#include "elgen/source_text.hpp"
#include "elgen/units.hpp"

namespace elgen {

/// The value of a leaf at a state of an [[expect]].
struct LeafAssignment {
  Opcode kind = Opcode::coordinate;
  std::uint32_t number = 0;
  cln::cl_R value = 0;
};

/// A state at which an [[expect]] gives the values of an output: the start of the model, with
/// `leaves` replaced. Momenta that `leaves` does not contain are computed from the rates.
struct ExpectationState {
  std::vector<LeafAssignment> leaves = {};
  cln::cl_R tolerance = 0;  ///< allowed error of an entry / largest |entry| of the field
};

/// One equation of an [[expect]] after repetitions are expanded: the expected expressions of all
/// entries of one field of an output, row-major.
struct Expectation {
  /// "mass_matrix", "forward_dynamics" or another output; "conserved"; or "equations", with the
  /// left sides minus the right sides of equations of motion as entries.
  std::string output;
  std::string field = {};  ///< name of the field, for example "multipliers"; "": the first field
  /// The number of the first entry of the field among all entries of the output.
  std::uint32_t first = 0;
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  std::vector<ExpressionId> entries = {};
  std::vector<Span> spans = {};                 ///< place of each entry in the file
  std::vector<std::optional<Unit>> units = {};  ///< by entry; none: unknown; empty: not checked
  /// The only state about which the claim is made; none: the claim is about every state.
  std::optional<ExpectationState> state = {};
  Span span = {};

  /// True if the claim is that the entries are constant along every motion.
  [[nodiscard]] bool claims_conservation() const { return output == "conserved"; }
  /// True if the claim is that the entries are 0 along every motion.
  [[nodiscard]] bool claims_equations() const { return output == "equations"; }
};

}  // namespace elgen
