// Which definitions an expression needs, operands first, without recursion: chains may be long.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "elgen/lagrangian.hpp"

namespace elgen {

/// Visits the definitions `value` needs, operands first, that depend on `mask` and are not `known`
/// yet.
template <class Visit>
void visit_needed(const Definitions& definitions, const GiNaC::ex& value, LeafSet mask,
                  std::vector<bool>& known, const Visit& visit) {
  std::vector<std::pair<std::uint32_t, bool>> stack;
  const auto push = [&](std::uint32_t index) {
    const bool is_known = index < known.size() && known[index];
    if (!is_known && definitions.list[index].depends.has_any(mask))
      stack.emplace_back(index, false);
  };
  for (const GiNaC::ex& symbol : symbols_of(definitions, value)) {
    const SymbolPlace& at = definitions.places.at(symbol);
    if (at.is_definition) push(at.index);
  }
  while (!stack.empty()) {
    const auto [index, operands_done] = stack.back();
    if (index < known.size() && known[index]) {
      stack.pop_back();
    } else if (!operands_done) {
      stack.back().second = true;
      for (const std::uint32_t used : definitions.list[index].uses) push(used);
    } else {
      stack.pop_back();
      if (known.size() <= index) known.resize(index + 1, false);
      known[index] = true;
      visit(index);
    }
  }
}

}  // namespace elgen
