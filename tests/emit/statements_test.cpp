// Tests statements (named values, expressions written in place, operands) and the parts into which
// a body is cut: small bodies by hand, and laws of random bodies.
#include "emit/code/statements.hpp"

#include <rapidcheck.h>

#include "fixture.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

using Numbers = std::vector<std::uint32_t>;

Statement assign(std::uint32_t instruction, Numbers uses) {
  return AssignStatement{instruction, {std::move(uses), {}}};
}

Statement entry(std::uint32_t index, Numbers uses) {
  return EntryStatement{0, 0, index, {std::move(uses), {}}};
}

/// Assignments and then four entries; each uses at most one value of an earlier assignment.
std::vector<Statement> random_body() {
  std::vector<Statement> body;
  const auto count = *rc::gen::inRange<std::uint32_t>(0, 40);
  for (std::uint32_t i = 0; i < count; ++i) {
    body.push_back(assign(i, i > 0 ? Numbers{*rc::gen::inRange<std::uint32_t>(0, i)} : Numbers{}));
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
  const Program program = read_program(
      "parameters a b\nfunction gravity\n  0 = parameter a\n  1 = parameter b\n"
      "  2 = add 0 1\n  3 = multiply 2 2\n  4 = negate 3\n  result 2 1 = 4 2\n");
  const std::vector<Statement> all = make_statements(
      program.functions.front(), {"", "", "total", "", ""}, SineCosinePairing::joint);
  REQUIRE(all.size() == 3);
  CHECK(std::get<AssignStatement>(all[0]).instruction == 2);
  CHECK(operands_of(all[0]).uses.empty());
  CHECK(operands_of(all[0]).inlined_instructions == Numbers{2, 0, 1});
  CHECK(std::get<EntryStatement>(all[1]).index == 0);
  CHECK(operands_of(all[1]).uses == Numbers{2});
  CHECK(operands_of(all[1]).inlined_instructions == Numbers{4, 3});
  CHECK(std::get<EntryStatement>(all[2]).index == 1);
  CHECK(operands_of(all[2]).uses == Numbers{2});
  CHECK(operands_of(all[2]).inlined_instructions.empty());
}

TEST_CASE(
    "a sine and a cosine of one angle are one statement if the language has one call for both") {
  const Program program = read_program(
      "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = add 0 1\n  3 = sin 2\n  4 = cos 2\n  5 = sin 0\n  result 3 1 = 3 4 5\n");
  const std::vector<std::string> names = {"", "", "sum", "sine", "cosine", "other"};
  const std::vector<Statement> joint =
      make_statements(program.functions.front(), names, SineCosinePairing::joint);
  REQUIRE(joint.size() == 3 + 3);
  CHECK(assigned_values(joint[1]) == Numbers{3, 4});
  CHECK(std::holds_alternative<SineCosineStatement>(joint[1]));
  CHECK(operands_of(joint[1]).uses == Numbers{2});
  CHECK(operands_of(joint[1]).inlined_instructions.empty());  // no call is written in place
  CHECK(std::holds_alternative<AssignStatement>(joint[2]));
  const std::vector<Statement> separate =
      make_statements(program.functions.front(), names, SineCosinePairing::separate);
  REQUIRE(separate.size() == 4 + 3);
  CHECK(operands_of(separate[1]).inlined_instructions == Numbers{3});
  CHECK(std::holds_alternative<AssignStatement>(separate[1]));
}

TEST_CASE("a group of angles stands at its first sine, after the operands of its other angles") {
  const Program program = read_program(
      "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = sin 0\n  3 = multiply 2 1\n  4 = add 0 1\n  5 = sin 4\n  6 = cos 4\n  7 = cos 3\n"
      "  result 4 1 = 2 5 6 7\n");
  const std::vector<std::string> names = {"", "", "s", "product", "sum", "s2", "c2", "c3"};
  const std::vector<Statement> all =
      make_statements(program.functions.front(), names, SineCosinePairing::grouped);
  REQUIRE(all.size() == 4 + 4);
  CHECK(assigned_values(all[0]) == Numbers{4});
  CHECK(std::get<AnglesStatement>(all[1]).calls == Numbers{2, 5, 6});
  CHECK(std::get<AnglesStatement>(all[1]).number == 1);
  CHECK(assigned_values(all[1]) == Numbers{2, 5, 6});
  CHECK(operands_of(all[1]).uses == Numbers{4});
  CHECK(operands_of(all[1]).inlined_instructions == Numbers{0});  // no call is written in place
  CHECK(assigned_values(all[2]) == Numbers{3});
  CHECK(std::holds_alternative<AssignStatement>(all[3]));  // an angle alone is no group
  const BodyParts cut = cut_into_parts(all, 2);
  REQUIRE(cut.parts.size() == 4);
  CHECK(std::holds_alternative<AnglesStatement>(cut.parts[0][1]));
  CHECK(std::get<EntryStatement>(cut.parts[1][0]).index == 0);
  CHECK(cut.crosses_parts == std::vector<bool>{false, false, true, true, false, true, true, false});
}

TEST_CASE("an entry follows the last statement that it uses") {
  const BodyParts cut = cut_into_parts(
      {assign(0, {}), assign(1, {0}), assign(2, {1}), entry(0, {2}), entry(1, {0}), entry(2, {})},
      4);
  REQUIRE(cut.parts.size() == 2);
  const auto is_entry = [&](std::size_t part, std::size_t item, std::uint32_t index) {
    const EntryStatement* const found = std::get_if<EntryStatement>(&cut.parts[part][item]);
    return found != nullptr && found->index == index;
  };
  CHECK(is_entry(0, 0, 2));  // entry 2 uses no value
  CHECK(is_entry(0, 2, 1));  // entry 1 uses value 0
  CHECK(is_entry(1, 1, 0));  // entry 0 uses value 2
  CHECK(cut.crosses_parts == std::vector<bool>{false, true, false});
}

TEST_CASE("a loop follows the statements for its inputs and names its first instruction") {
  Program program = read_program(
      "coordinates x y\nfunction gravity\n  0 = coordinate x\n  1 = coordinate y\n"
      "  2 = add 0 1\n  3 = multiply 2 0\n  4 = multiply 2 1\n  result 2 1 = 3 4\n");
  Function& function = program.functions.front();
  function.repeated = {1, 2};
  const std::vector<std::string> names = {"", "", "sum", "solved[0]", "solved[1]"};
  const std::vector<Statement> all =
      make_statements(function, names, SineCosinePairing::joint, column_loop(function));
  REQUIRE(all.size() == 1 + 2 + 1 + 2);
  CHECK(std::get<LoopOperandStatement>(all[1]).instruction == 0);
  CHECK(std::get<LoopOperandStatement>(all[2]).instruction == 1);
  CHECK(operands_of(all[2]).inlined_instructions == Numbers{1});
  CHECK(assigned_values(all[2]).empty());
  CHECK(std::get<LoopStatement>(all[3]).first == 3);
  CHECK(assigned_values(all[3]) == Numbers{3});
  CHECK(operands_of(all[3]).uses == Numbers{2});
  CHECK(operands_of(all[5]).uses == Numbers{3});  // value 3 stands for all columns
}

TEST_CASE("a sine and cosine of one statement cross a cut together") {
  const BodyParts cut =
      cut_into_parts({SineCosineStatement{0, 1}, assign(2, {0}), assign(3, {1})}, 2);
  REQUIRE(cut.parts.size() == 2);
  CHECK(cut.crosses_parts == std::vector<bool>{true, true, false, false});
}

TEST_CASE("parts are in order and full, and share exactly the values that cross a cut") {
  CHECK(rc::check("laws of sections", [] {
    const std::vector<Statement> body = random_body();
    const std::size_t count = body.size() - 4;
    const auto part_length = *rc::gen::inRange<std::size_t>(1, 10);
    const BodyParts cut = cut_into_parts(body, part_length);
    std::vector<std::size_t> part_of(count, cut.parts.size());
    std::size_t items = 0;
    std::vector<bool> crosses(count);
    for (std::size_t part = 0; part < cut.parts.size(); ++part) {
      RC_ASSERT(cut.parts[part].size() == part_length || part + 1 == cut.parts.size());
      for (const Statement& statement : cut.parts[part]) {
        ++items;
        for (const std::uint32_t used : operands_of(statement).uses) {
          RC_ASSERT(part_of[used] < cut.parts.size());  // computed before its use
          if (part_of[used] != part) crosses[used] = true;
        }
        for (const std::uint32_t at : assigned_values(statement)) part_of[at] = part;
      }
    }
    RC_ASSERT(items == body.size());
    RC_ASSERT(crosses == cut.crosses_parts);
  }));
}
