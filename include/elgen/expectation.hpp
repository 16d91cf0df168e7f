// Expectation: the claim of an [[expect]] about an output or the motion.
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
struct StatedLeaf {
  Opcode kind = Opcode::coordinate;
  std::uint32_t number = 0;
  cln::cl_R value = 0;
};

/// A state with known outputs: the start of the model with these leaves replaced. Momenta that are
/// not listed follow from the rates.
struct StatedState {
  std::vector<StatedLeaf> leaves = {};
  cln::cl_R tolerance = 0;  ///< tolerance of an entry, relative to the largest entry
};

/// One [[expect]] line: the closed form of every entry of an output's field, row-major. Repetitions
/// are expanded.
struct Expectation {
  /// "mass_matrix", "forward_dynamics", a user output; or "conserved"; or "equations", whose
  /// entries are left side - right side of equations of motion.
  std::string output;
  std::string field = {};  ///< the field that the file names, as "multipliers"; "": the first
  /// The number of the first entry of the field among all entries of the output.
  std::uint32_t first = 0;
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  std::vector<ExpressionId> entries = {};
  std::vector<Span> spans = {};                 ///< of each entry
  std::vector<std::optional<Unit>> units = {};  ///< of each entry; empty: not checked
  /// The only state at which the claim holds; none: every state.
  std::optional<StatedState> at = {};
  Span span = {};

  /// True if the entries are constants of motion, not entries of an output.
  [[nodiscard]] bool is_conserved() const { return output == "conserved"; }
  /// True if the entries vanish along the motion.
  [[nodiscard]] bool is_equations() const { return output == "equations"; }
};

}  // namespace elgen
