// Block roots: all solutions of the equations of one block.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "analyse/boxes.hpp"
#include "analyse/exact_roots.hpp"
#include "analyse/rest.hpp"
#include "elgen/limits.hpp"

namespace elgen {

/// The system at rest, its closed forms, and the values of its parameters.
struct RestSystem {
  const Model& model;
  const Program& program;  ///< r, M and W of RestProgram
  ClosedForms& forms;      ///< of the functions in `program`
  const std::vector<SearchKind>& kinds;
  State state = {};  ///< values of parameters and inputs, start values of coordinates

  [[nodiscard]] const Function& residual() const { return program.functions[0]; }
  /// The closed form of r[velocity]; none if the form exceeds the budget.
  [[nodiscard]] const std::optional<Fraction>& equation_form(std::uint32_t velocity) const {
    return forms.functions[0].fields[0].entries[velocity];
  }
};

/// The roots of one block, each with the values of the block's coordinates in order.
struct BlockRoots {
  bool is_identity = false;  ///< an equation without coordinates is 0 = 0 for all parameters
  std::vector<std::vector<RestCoordinate>> roots = {};
  Completeness completeness = Completeness::proved;
  std::vector<UndecidedBox> undecided = {};
  std::uint64_t boxes = 0;
  std::uint64_t enclosures = 0;
  std::uint64_t starts = 0;
  std::string_view reached_limit = {};  ///< "boxes" or "enclosures"; empty: no limit was reached
};

/// The roots of `block`, or E531 for a coordinate without a range. The search stops at the limits
/// of boxes and enclosures in `limits`.
[[nodiscard]] Result<BlockRoots> block_roots(RestSystem& system, const RestBlock& block,
                                             const Limits& limits);

/// Among the derivatives of a row by one coordinate, the derivative of lowest order that is not 0
/// at a root. At the root, for the values of the parameters, the row and all derivatives of lower
/// order are exactly 0.
struct LeadingDerivative {
  std::uint32_t order = 1;  ///< of the derivative; equals the multiplicity of the root
  Fraction derivative = {};
};
[[nodiscard]] std::optional<LeadingDerivative> leading_derivative(RestSystem& system,
                                                                  std::uint32_t row,
                                                                  std::uint32_t coordinate,
                                                                  const RestCoordinate& root);

}  // namespace elgen
