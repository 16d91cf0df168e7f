// sections: entries sorted behind the last statement they use, the whole cut into equal parts.
#include "emit/code/sections.hpp"

#include <algorithm>

namespace elgen {
namespace {

/// Instructions are numbered in the order of evaluation.
std::uint64_t place_of(const Statement& statement) {
  if (!statement.is_entry) return 2 * (std::uint64_t{statement.instruction} + 1);
  return statement.uses.empty() ? 0 : 2 * (std::uint64_t{statement.uses.back()} + 1) + 1;
}

std::vector<Statement> ordered(std::vector<Statement> statements) {
  std::stable_sort(
      statements.begin(), statements.end(),
      [](const Statement& a, const Statement& b) { return place_of(a) < place_of(b); });
  return statements;
}

/// One statement writes both of a sine and a cosine to the same place.
void cross_together(const Sections& cut, std::vector<bool>& crosses) {
  for (const std::vector<Statement>& part : cut.parts) {
    for (const Statement& statement : part) {
      if (!statement.cosine) continue;
      const bool is_shared = crosses[statement.instruction] || crosses[*statement.cosine];
      crosses[statement.instruction] = crosses[*statement.cosine] = is_shared;
    }
  }
}

std::vector<bool> crossing(const Sections& cut) {
  std::vector<std::size_t> part_of;
  std::vector<bool> crosses;
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    for (const Statement& statement : cut.parts[part]) {
      for (const std::uint32_t used : statement.uses) {
        if (part_of[used] != part) crosses[used] = true;
      }
      if (statement.is_entry) continue;
      const std::uint32_t last = statement.cosine.value_or(statement.instruction);
      part_of.resize(last + 1);
      crosses.resize(last + 1);
      part_of[statement.instruction] = part_of[last] = part;
    }
  }
  cross_together(cut, crosses);
  return crosses;
}

}  // namespace

Sections sections(const std::vector<Statement>& statements, std::size_t length_of_part) {
  Sections cut{.parts = {{}}};
  for (Statement& statement : ordered(statements)) {
    if (cut.parts.back().size() == length_of_part) cut.parts.emplace_back();
    cut.parts.back().push_back(std::move(statement));
  }
  cut.crosses = crossing(cut);
  return cut;
}

}  // namespace elgen
