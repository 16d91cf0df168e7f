// Block roots: all solutions of the equations of one block.
#pragma once

#include <optional>
#include <vector>

#include "analyse/boxes.hpp"
#include "analyse/exact_roots.hpp"
#include "analyse/rest.hpp"
#include "elgen/limits.hpp"

namespace elgen {

/// The system at rest and its closed forms, at the values of the parameters.
struct RestSystem {
  const Model& model;
  const Program& program;  ///< r, M and W of RestProgram
  ClosedForms& forms;      ///< of these
  const std::vector<SearchKind>& kinds;
  State state = {};  ///< parameters and inputs as they are, coordinates at their starts

  [[nodiscard]] const Function& residual() const { return program.functions[0]; }
  /// The form of one equation; none beyond the budget.
  [[nodiscard]] const std::optional<Fraction>& row(std::uint32_t velocity) const {
    return forms.functions[0].fields[0].entries[velocity];
  }
};

/// Roots of one block: values of its coordinates, in their order.
struct BlockRoots {
  bool is_identity = false;  ///< of an equation without coordinates: 0 = 0 for all parameters
  std::vector<std::vector<CoordinateAtRest>> roots = {};
  Completeness completeness = Completeness::proved;
  std::vector<UndecidedBox> undecided = {};
  std::uint64_t boxes = 0;
  std::uint64_t enclosures = 0;
  std::uint64_t starts = 0;
  bool is_cut = false;  ///< by the limit of enclosures
};

/// E531 where a coordinate has no range. The search ends at the limits of boxes and enclosures.
[[nodiscard]] Result<BlockRoots> block_roots(RestSystem& system, const RestBlock& block,
                                             const Limits& most);

/// The first derivative of a row that is not 0 at a root of one coordinate, where all before it are
/// exactly 0 at the values of the parameters.
struct RootOrder {
  std::uint32_t order = 1;  ///< of the zero
  Fraction derivative = {};
};
[[nodiscard]] std::optional<RootOrder> root_order(RestSystem& system, std::uint32_t row,
                                                  std::uint32_t coordinate,
                                                  const CoordinateAtRest& root);

}  // namespace elgen
