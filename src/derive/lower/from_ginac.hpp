// from_ginac: EquationsOfMotion -> Graph. Later stages do not depend on GiNaC's order of terms.
#pragma once

#include <string>
#include <vector>

#include "elgen/leaf_names.hpp"
#include "elgen/scene.hpp"
#include "program/graph/graph.hpp"

namespace elgen {

struct EquationsOfMotion;

/// One output: its graph, and the nodes of its entries.
struct ImportedOutput {
  Graph graph = {};
  std::vector<Field> fields = {};               ///< entries are indices into `values`
  std::vector<SignedNode> values = {};          ///< every entry of every field
  std::vector<std::uint32_t> elimination = {};  ///< order of elimination of M, for compose.hpp
  /// Nodes that the stage derive has named for readers of the code, and the names of these nodes.
  /// For `dynamics`, each name starts with the name of the repeated output.
  std::vector<SignedNode> intermediate_values = {};
  std::vector<std::string> value_names = {};
};

/// Imports each definition that the output needs once, then the entries of the output. `dynamics`
/// has the entries of every output for which is_in_dynamics() is true. E312: a denominator is 0.
/// E908: more than `maximum_nodes` nodes. E912: an expression of an unknown class, a complex or
/// rounded number, or an output that was not derived.
[[nodiscard]] Result<ImportedOutput> from_ginac(const EquationsOfMotion& equations,
                                                const OutputRequest& request,
                                                std::uint64_t maximum_nodes);

/// The equations of every route by which the output was derived. `equations` comes first, unless
/// only `equations.alternatives` have the output.
[[nodiscard]] std::vector<const EquationsOfMotion*> find_routes(const EquationsOfMotion& equations,
                                                                const OutputRequest& request);

/// E908, for too many definitions in derive and for too many nodes in lower.
[[nodiscard]] Diagnostic too_many_nodes_error(const OutputRequest& request, std::uint64_t limit);

[[nodiscard]] LeafNames leaf_names(const EquationsOfMotion& equations);

}  // namespace elgen
