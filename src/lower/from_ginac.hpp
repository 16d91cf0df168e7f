// from_ginac: EquationsOfMotion -> Graph. The only importer; nothing of GiNaC's order survives it.
#pragma once

#include "elgen/equations_of_motion.hpp"
#include "graph.hpp"

namespace elgen {

/// The entries of some outputs over one graph, in the order given.
struct ImportedOutputs {
  Graph graph = {};
  std::vector<std::vector<Field>> fields = {};  ///< per output; entries number `values`
  std::vector<Ref> values = {};                 ///< every entry of every field
};

/// Imports the definitions that `outputs` need, once each, then the entries.
/// E312: a constant denominator is 0. E908: more than `maximum_nodes` nodes. E912: something GiNaC
/// should not hold.
[[nodiscard]] Result<ImportedOutputs> from_ginac(const EquationsOfMotion& equations,
                                                 const std::vector<const OutputEquations*>& outputs,
                                                 std::uint64_t maximum_nodes);

}  // namespace elgen
