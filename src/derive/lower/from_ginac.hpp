// from_ginac: EquationsOfMotion -> Graph. The only importer; nothing of GiNaC's order survives it.
#pragma once

#include <string>
#include <vector>

#include "elgen/leaf_names.hpp"
#include "elgen/scene.hpp"
#include "program/graph/graph.hpp"

namespace elgen {

struct EquationsOfMotion;

/// The entries of one output over a graph.
struct ImportedOutput {
  Graph graph = {};
  std::vector<Field> fields = {};               ///< entries number `values`
  std::vector<Ref> values = {};                 ///< every entry of every field
  std::vector<std::uint32_t> elimination = {};  ///< of parts
  /// Values of the graph, and what derive calls them; where outputs are repeated, with their names.
  std::vector<Ref> told_values = {};
  std::vector<std::string> told_names = {};
};

/// Imports the definitions that a requested output needs, once each, then its entries; for
/// `dynamics` those of every output that depends on q, v and t alone, one field each. E312: a
/// denominator is 0. E908: more than `maximum_nodes` nodes. E912: something GiNaC should
/// not hold, or an output that was not derived.
[[nodiscard]] Result<ImportedOutput> from_ginac(const EquationsOfMotion& equations,
                                                const OutputRequest& request,
                                                std::uint64_t maximum_nodes);

/// The equations by each route that leads to an output, the usual one first.
[[nodiscard]] std::vector<const EquationsOfMotion*> routes_to(const EquationsOfMotion& equations,
                                                              const OutputRequest& request);

/// E908 of what is derived: one message for the definitions of derive and the nodes of lower.
[[nodiscard]] Diagnostic too_many_nodes(const OutputRequest& request, std::uint64_t limit);

[[nodiscard]] LeafNames leaf_names(const EquationsOfMotion& equations);

}  // namespace elgen
