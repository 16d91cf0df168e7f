// LeafNames: what the leaves of every later stage are called, as the model writes them.
#pragma once

#include <string>
#include <vector>

#include "elgen/leaves.hpp"
#include "elgen/model.hpp"

namespace elgen {

/// "m", "l[2]", "theta", "q[1]"; of rates what dot() is written around.
struct LeafNames : LeafValues<std::string> {
  bool uses_time = false;
};

[[nodiscard]] LeafNames leaf_names(const Model& model);

/// "m", "dot(x)", "t": a leaf as models write it.
[[nodiscard]] std::string leaf_text(const LeafNames& leaves, Opcode kind, std::uint32_t number);

/// draw() for every leaf, in their order, t among them.
template <class Draw>
[[nodiscard]] auto draw_leaves(const LeafNames& leaves, const Draw& draw) {
  return map_leaves([&draw](const std::string&) { return draw(); }, leaves);
}

}  // namespace elgen
