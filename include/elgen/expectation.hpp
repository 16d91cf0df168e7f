// Expectation: what an [[expect]] of a model says is true of an output or of the motion.
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

/// The number that a leaf has at a state of an [[expect]].
struct StatedLeaf {
  Opcode kind = Opcode::coordinate;
  std::uint32_t number = 0;
  cln::cl_R value = 0;
};

/// A state at which outputs are known: the start of the model, but for these leaves. Momenta that
/// are not among them are those of the rates.
struct StatedState {
  std::vector<StatedLeaf> leaves = {};
  cln::cl_R within = 0;  ///< how far off an entry may be, of the largest one
};

/// One [[expect]] line: the closed form of every entry of a field of an output, row-major. Sized
/// entries are expanded.
struct Expectation {
  /// "mass_matrix", "forward_dynamics", a user output; or "conserved", or "equations", whose
  /// entries are left - right of equations of motion
  std::string output;
  std::string field = {};   ///< "multipliers", which the file names instead; else the first one
  std::uint32_t first = 0;  ///< where it begins among the entries of the output
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  std::vector<ExpressionId> entries = {};
  std::vector<Span> spans = {};                 ///< of each entry, in the file
  std::vector<std::optional<Unit>> units = {};  ///< of each entry; empty where none are checked
  std::optional<StatedState> at = {};           ///< the only state they hold at; none: at all
  Span span = {};

  /// Whether its entries are constant along the motion, not those of an output.
  [[nodiscard]] bool is_conserved() const { return output == "conserved"; }
  /// Whether its entries vanish along the motion.
  [[nodiscard]] bool are_equations() const { return output == "equations"; }
};

}  // namespace elgen
