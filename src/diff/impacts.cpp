// Impacts: the rows of impacts.def.
#include <algorithm>
#include <array>

#include "elgen/diff.hpp"

namespace elgen {
namespace {

constexpr std::array rows{
#define ELGEN_IMPACT(name, doc) ImpactRow{#name, doc},
#include "elgen/impacts.def"
#undef ELGEN_IMPACT
};

}  // namespace

const ImpactRow& impact_row(Impact impact) { return rows[static_cast<std::size_t>(impact)]; }

std::optional<Impact> find_impact(std::string_view word) {
  const auto found = std::ranges::find(rows, word, &ImpactRow::word);
  if (found == rows.end()) return std::nullopt;
  return static_cast<Impact>(found - rows.begin());
}

}  // namespace elgen
