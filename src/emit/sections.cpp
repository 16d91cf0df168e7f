// sections: entries sorted behind the last statement they use, the whole cut into equal parts.
#include "sections.hpp"

namespace elgen {
namespace {

/// Entries by the number of statements that have to stand before them.
std::vector<std::vector<SectionItem>> entries_by_place(const FunctionBody& body) {
  std::vector<std::vector<SectionItem>> places(body.statements.size() + 1);
  for (std::uint32_t field = 0; field < body.entries.size(); ++field) {
    for (std::uint32_t index = 0; index < body.entries[field].size(); ++index) {
      const std::vector<std::uint32_t>& uses = body.entries[field][index].uses;
      places[uses.empty() ? 0 : uses.back() + 1].push_back({true, field, index});
    }
  }
  return places;
}

std::vector<SectionItem> ordered_items(const FunctionBody& body) {
  const std::vector<std::vector<SectionItem>> places = entries_by_place(body);
  std::vector<SectionItem> items = places.front();
  for (std::uint32_t i = 0; i < body.statements.size(); ++i) {
    items.push_back({false, 0, i});
    items.insert(items.end(), places[i + 1].begin(), places[i + 1].end());
  }
  return items;
}

std::vector<bool> crossing(const FunctionBody& body, const Sections& cut) {
  std::vector<std::size_t> part_of(body.statements.size());
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    for (const SectionItem& item : cut.parts[part]) {
      if (!item.is_entry) part_of[item.index] = part;
    }
  }
  std::vector<bool> crosses(body.statements.size());
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    for (const SectionItem& item : cut.parts[part]) {
      for (const std::uint32_t used : value_of(body, item).uses) {
        if (part_of[used] != part) crosses[used] = true;
      }
    }
  }
  return crosses;
}

}  // namespace

std::size_t length(const FunctionBody& body) {
  std::size_t count = body.statements.size();
  for (const std::vector<Term>& entries : body.entries) count += entries.size();
  return count;
}

const Term& value_of(const FunctionBody& body, const SectionItem& item) {
  return item.is_entry ? body.entries[item.field][item.index] : body.statements[item.index].value;
}

Sections sections(const FunctionBody& body, std::size_t length_of_part) {
  Sections cut{.parts = {{}}};
  for (const SectionItem& item : ordered_items(body)) {
    if (cut.parts.back().size() == length_of_part) cut.parts.emplace_back();
    cut.parts.back().push_back(item);
  }
  cut.crosses = crossing(body, cut);
  return cut;
}

}  // namespace elgen
