// sections: small bodies cut by hand, and laws over random ones.
#include "emit/code/sections.hpp"

#include <rapidcheck.h>

#include <catch2/catch.hpp>

using namespace elgen;

namespace {

using Uses = std::vector<std::uint32_t>;

Statement named(std::uint32_t instruction, Uses uses) {
  return {instruction, std::move(uses), {}, false, 0, 0};
}

Statement entry(std::uint32_t index, Uses uses) { return {0, std::move(uses), {}, true, 0, index}; }

/// Named instruction i uses some earlier ones, entries use any.
std::vector<Statement> random_body() {
  std::vector<Statement> body;
  const auto count = *rc::gen::inRange<std::uint32_t>(0, 40);
  for (std::uint32_t i = 0; i < count; ++i) {
    body.push_back(named(i, i > 0 ? Uses{*rc::gen::inRange<std::uint32_t>(0, i)} : Uses{}));
  }
  for (std::uint32_t index = 0; index < 4; ++index) {
    const bool uses_any = index % 2 == 1 && count > 0;
    body.push_back(
        entry(index, uses_any ? Uses{*rc::gen::inRange<std::uint32_t>(0, count)} : Uses{}));
  }
  return body;
}

}  // namespace

TEST_CASE("an entry stands behind the last statement it uses") {
  const Sections cut = sections(
      {named(0, {}), named(1, {0}), named(2, {1}), entry(0, {2}), entry(1, {0}), entry(2, {})}, 4);
  REQUIRE(cut.parts.size() == 2);
  const auto is_entry = [&](std::size_t part, std::size_t item, std::uint32_t index) {
    const Statement& found = cut.parts[part][item];
    return found.is_entry && found.index == index;
  };
  CHECK(is_entry(0, 0, 2));  // uses nothing
  CHECK(is_entry(0, 2, 1));  // behind the first
  CHECK(is_entry(1, 1, 0));  // behind the last
  CHECK(cut.crosses == std::vector<bool>{false, true, false});
}

TEST_CASE("a sine and a cosine of one statement cross together") {
  Statement pair = named(0, {});
  pair.cosine = 1;
  const Sections cut = sections({pair, named(2, {0}), named(3, {1})}, 2);
  REQUIRE(cut.parts.size() == 2);
  CHECK(cut.crosses == std::vector<bool>{true, true, false, false});
}

TEST_CASE("parts are in order, full, and share exactly what crosses") {
  CHECK(rc::check("laws of sections", [] {
    const std::vector<Statement> body = random_body();
    const std::size_t count = body.size() - 4;
    const auto part_length = *rc::gen::inRange<std::size_t>(1, 10);
    const Sections cut = sections(body, part_length);
    std::vector<std::size_t> part_of(count, cut.parts.size());
    std::size_t items = 0;
    std::vector<bool> crosses(count);
    for (std::size_t part = 0; part < cut.parts.size(); ++part) {
      RC_ASSERT(cut.parts[part].size() == part_length || part + 1 == cut.parts.size());
      for (const Statement& statement : cut.parts[part]) {
        ++items;
        for (const std::uint32_t used : statement.uses) {
          RC_ASSERT(part_of[used] < cut.parts.size());  // computed before
          if (part_of[used] != part) crosses[used] = true;
        }
        if (!statement.is_entry) part_of[statement.instruction] = part;
      }
    }
    RC_ASSERT(items == body.size());
    RC_ASSERT(crosses == cut.crosses);
  }));
}
