// statements: the operands of each are followed to where a name stands for them. Sections: entries
// sorted behind the last statement they use, the whole cut into equal parts.
#include "emit/code/statements.hpp"

#include <algorithm>

#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

void collect(const Function& function, const std::vector<std::string>& names, std::uint32_t at,
             Statement& statement) {
  const bool is_definition = !statement.is_entry && at == statement.instruction;
  const auto first = static_cast<std::uint32_t>(first_repeated(function));
  if (!names[at].empty() && !is_definition) return statement.uses.push_back(std::min(at, first));
  statement.written.push_back(at);
  const Instruction& i = function.instructions[at];
  if (operand_count(i) > 0) collect(function, names, i.a, statement);
  if (operand_count(i) > 1) collect(function, names, i.b, statement);
}

void sort_uses(Statement& statement) {
  std::vector<std::uint32_t>& uses = statement.uses;
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
}

/// The text of a sine and a cosine is their angle.
Statement completed(const Function& function, const std::vector<std::string>& names,
                    Statement statement) {
  const std::uint32_t at = statement.instruction;
  collect(function, names, statement.cosine ? function.instructions[at].a : at, statement);
  sort_uses(statement);
  return statement;
}

/// The numbers that are given to the loop, and the loop.
void add_loop(const Function& function, const std::vector<std::string>& names,
              const ColumnLoop& loop, std::vector<Statement>& all) {
  const auto field = static_cast<std::uint32_t>(function.fields.size());
  for (std::uint32_t index = 0; index < loop.given.size(); ++index) {
    all.push_back(completed(function, names, {loop.given[index], {}, {}, true, field, index}));
  }
  Statement statement{.instruction = loop.first};
  for (const std::uint32_t at : loop.shared) collect(function, names, at, statement);
  sort_uses(statement);
  all.push_back(std::move(statement));
}

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

std::vector<Statement> statements(const Function& function, const std::vector<std::string>& names,
                                  Pairing pairing, const ColumnLoop& loop) {
  std::vector<Statement> all;
  for (std::uint32_t at = 0; at < first_repeated(function); ++at) {
    if (names[at].empty()) continue;
    Statement statement{.instruction = at};
    if (pairing == Pairing::joint && is_sine_with_cosine(function, at)) {
      statement.cosine = ++at;
    }
    all.push_back(completed(function, names, std::move(statement)));
  }
  if (loop.count > 0) add_loop(function, names, loop, all);
  for (std::uint32_t field = 0; field < function.fields.size(); ++field) {
    const std::vector<std::uint32_t>& entries = function.fields[field].entries;
    for (std::uint32_t index = 0; index < entries.size(); ++index) {
      all.push_back(completed(function, names, {entries[index], {}, {}, true, field, index}));
    }
  }
  return all;
}

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
