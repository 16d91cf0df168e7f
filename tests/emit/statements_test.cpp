// statements: what is computed under a name, what is written out, and what either is made of.
// Sections: small bodies cut by hand, and laws over random ones.
#include "emit/code/statements.hpp"

#include <rapidcheck.h>

#include "fixture.hpp"

using namespace elgen;

namespace {

using Numbers = std::vector<std::uint32_t>;

Statement named(std::uint32_t instruction, Numbers uses) {
  return {instruction, std::move(uses), {}, false, 0, 0};
}

Statement entry(std::uint32_t index, Numbers uses) {
  return {0, std::move(uses), {}, true, 0, index};
}

/// Named instruction i uses some earlier ones, entries use any.
std::vector<Statement> random_body() {
  std::vector<Statement> body;
  const auto count = *rc::gen::inRange<std::uint32_t>(0, 40);
  for (std::uint32_t i = 0; i < count; ++i) {
    body.push_back(named(i, i > 0 ? Numbers{*rc::gen::inRange<std::uint32_t>(0, i)} : Numbers{}));
  }
  for (std::uint32_t index = 0; index < 4; ++index) {
    const bool uses_any = index % 2 == 1 && count > 0;
    body.push_back(
        entry(index, uses_any ? Numbers{*rc::gen::inRange<std::uint32_t>(0, count)} : Numbers{}));
  }
  return body;
}

}  // namespace

TEST_CASE("a shared value is one statement, before its uses") {
  const Program program = elgen::testing::read_program(
      "parameters a b\nfunction gravity\n  0 = parameter a\n  1 = parameter b\n"
      "  2 = add 0 1\n  3 = multiply 2 2\n  4 = negate 3\n  result 2 1 = 4 2\n");
  const std::vector<Statement> all =
      statements(program.functions.front(), {"", "", "total", "", ""}, Pairing::joint);
  REQUIRE(all.size() == 3);
  CHECK(all[0].instruction == 2);
  CHECK_FALSE(all[0].is_entry);
  CHECK(all[0].uses.empty());
  CHECK(all[0].written == Numbers{2, 0, 1});
  CHECK(all[1].is_entry);
  CHECK(all[1].uses == Numbers{2});
  CHECK(all[1].written == Numbers{4, 3});
  CHECK(all[2].index == 1);
  CHECK(all[2].uses == Numbers{2});
  CHECK(all[2].written.empty());
}

TEST_CASE("a sine and a cosine of one angle are one statement, where the language has one call") {
  const Program program = elgen::testing::read_program(
      "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = add 0 1\n  3 = sin 2\n  4 = cos 2\n  5 = sin 0\n  result 3 1 = 3 4 5\n");
  const std::vector<std::string> names = {"", "", "sum", "sine", "cosine", "other"};
  const std::vector<Statement> joint = statements(program.functions.front(), names, Pairing::joint);
  REQUIRE(joint.size() == 3 + 3);
  CHECK(joint[1].instruction == 3);
  CHECK(joint[1].cosine == 4);
  CHECK(joint[1].uses == Numbers{2});
  CHECK(joint[1].written.empty());  // the calls are not spelt out
  CHECK_FALSE(joint[2].cosine);
  const std::vector<Statement> separate =
      statements(program.functions.front(), names, Pairing::separate);
  REQUIRE(separate.size() == 4 + 3);
  CHECK(separate[1].written == Numbers{3});
  CHECK_FALSE(separate[1].cosine);
}

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
