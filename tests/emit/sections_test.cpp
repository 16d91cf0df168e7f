// sections: small bodies cut by hand, and laws over random ones.
#include "emit/sections.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

Term term(std::vector<std::uint32_t> uses) { return {"", std::move(uses)}; }

/// Statement i uses some earlier ones, entries use any.
FunctionBody random_body() {
  FunctionBody body;
  const auto count = *rc::gen::inRange<std::uint32_t>(0, 40);
  for (std::uint32_t i = 0; i < count; ++i) {
    body.statements.push_back({"", term({})});
    if (i > 0) body.statements.back().value = term({*rc::gen::inRange<std::uint32_t>(0, i)});
  }
  body.entries.resize(2);
  for (std::vector<Term>& entries : body.entries) {
    entries.push_back(term({}));
    if (count > 0) entries.push_back(term({*rc::gen::inRange<std::uint32_t>(0, count)}));
  }
  return body;
}

}  // namespace

TEST_CASE("an entry stands behind the last statement it uses") {
  FunctionBody body;
  body.statements = {{"a", term({})}, {"b", term({0})}, {"c", term({1})}};
  body.entries = {{term({2}), term({0}), term({})}};
  CHECK(length(body) == 6);
  const Sections cut = sections(body, 4);
  REQUIRE(cut.parts.size() == 2);
  const auto is_entry = [&](std::size_t part, std::size_t item, std::uint32_t index) {
    const SectionItem& found = cut.parts[part][item];
    return found.is_entry && found.index == index;
  };
  CHECK(is_entry(0, 0, 2));  // uses nothing
  CHECK(is_entry(0, 2, 1));  // behind a
  CHECK(is_entry(1, 1, 0));  // behind c
  CHECK(cut.crosses == std::vector<bool>{false, true, false});
}

TEST_CASE("parts are in order, full, and share exactly what crosses") {
  CHECK(rc::check("laws of sections", [] {
    const FunctionBody body = random_body();
    const auto part_length = *rc::gen::inRange<std::size_t>(1, 10);
    const Sections cut = sections(body, part_length);
    std::vector<std::size_t> part_of(body.statements.size(), cut.parts.size());
    std::size_t items = 0;
    std::vector<bool> crosses(body.statements.size());
    for (std::size_t part = 0; part < cut.parts.size(); ++part) {
      RC_ASSERT(cut.parts[part].size() == part_length || part + 1 == cut.parts.size());
      for (const SectionItem& item : cut.parts[part]) {
        ++items;
        for (const std::uint32_t used : value_of(body, item).uses) {
          RC_ASSERT(part_of[used] < cut.parts.size());  // computed before
          if (part_of[used] != part) crosses[used] = true;
        }
        if (!item.is_entry) part_of[item.index] = part;
      }
    }
    RC_ASSERT(items == length(body));
    RC_ASSERT(crosses == cut.crosses);
  }));
}
