// statements: follows the operands of each statement to named instructions. Sections: moves each
// entry behind the last statement whose value it uses, then cuts the statements into parts of equal
// length.
#include "emit/code/statements.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

/// Follows operands to named instructions. Every instruction of the loop counts as the first
/// instruction of the loop.
class OperandWalk {
 public:
  OperandWalk(const Function& function, const std::vector<std::string>& names)
      : function_(function), names_(names) {}

  /// Walks the definition of an instruction, even if the instruction has a name.
  StatementOperands definition(std::uint32_t at) {
    write_out(at);
    return finish();
  }

  StatementOperands values(const std::vector<std::uint32_t>& all) {
    for (const std::uint32_t at : all) read(at);
    return finish();
  }

 private:
  void read(std::uint32_t at) {
    if (names_[at].empty()) return write_out(at);
    operands_.uses.push_back(
        std::min(at, static_cast<std::uint32_t>(first_repeated_instruction(function_))));
  }

  void write_out(std::uint32_t at) {
    operands_.written.push_back(at);
    const Instruction& i = function_.instructions[at];
    if (operand_count(i) > 0) read(i.a);
    if (operand_count(i) > 1) read(i.b);
  }

  StatementOperands finish() {
    std::vector<std::uint32_t>& uses = operands_.uses;
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    return std::exchange(operands_, {});
  }

  const Function& function_;
  const std::vector<std::string>& names_;
  StatementOperands operands_ = {};
};

using Named = std::vector<std::uint32_t>;

Named names_of(const Assign& assign) { return {assign.instruction}; }
Named names_of(const SineAndCosine& pair) { return {pair.sine, pair.cosine}; }
Named names_of(const Entry& /*entry*/) { return {}; }
Named names_of(const LoopOperand& /*given*/) { return {}; }
Named names_of(const Loop& loop) { return {loop.first}; }

/// Sort key: named values keep the order of evaluation; an entry follows the last value that it
/// uses.
std::uint64_t sort_key(const Statement& statement) {
  const Named named = named_by(statement);
  if (!named.empty()) return 2 * (std::uint64_t{named.front()} + 1);
  const std::vector<std::uint32_t>& uses = operands_of(statement).uses;
  return uses.empty() ? 0 : 2 * (std::uint64_t{uses.back()} + 1) + 1;
}

/// The statements by sort_key(). Statements with equal keys keep their order.
std::multimap<std::uint64_t, Statement> ordered(const std::vector<Statement>& statements) {
  std::multimap<std::uint64_t, Statement> by_place;
  for (const Statement& statement : statements) by_place.emplace(sort_key(statement), statement);
  return by_place;
}

/// If one value of a statement crosses, marks all values of this statement in `crosses`, because
/// the statement writes all values together.
void cross_together(const Sections& cut, std::vector<bool>& crosses) {
  for (const std::vector<Statement>& part : cut.parts) {
    for (const Statement& statement : part) {
      const Named named = named_by(statement);
      const bool is_shared =
          std::ranges::any_of(named, [&](std::uint32_t at) { return crosses[at]; });
      for (const std::uint32_t at : named) crosses[at] = is_shared;
    }
  }
}

std::vector<bool> crossing(const Sections& cut) {
  std::vector<std::size_t> part_of;
  std::vector<bool> crosses;
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    for (const Statement& statement : cut.parts[part]) {
      for (const std::uint32_t used : operands_of(statement).uses) {
        if (part_of[used] != part) crosses[used] = true;
      }
      for (const std::uint32_t at : named_by(statement)) {
        part_of.resize(at + 1);
        crosses.resize(at + 1);
        part_of[at] = part;
      }
    }
  }
  cross_together(cut, crosses);
  return crosses;
}

}  // namespace

const StatementOperands& operands_of(const Statement& statement) {
  return std::visit([](const auto& of) -> const StatementOperands& { return of.operands; },
                    statement);
}

std::vector<std::uint32_t> named_by(const Statement& statement) {
  return std::visit([](const auto& of) { return names_of(of); }, statement);
}

std::vector<Statement> statements(const Function& function, const std::vector<std::string>& names,
                                  Pairing pairing, const ColumnLoop& loop) {
  OperandWalk walk(function, names);
  std::vector<Statement> all;
  for (std::uint32_t at = 0; at < first_repeated_instruction(function); ++at) {
    if (names[at].empty()) continue;
    if (pairing == Pairing::joint && is_sine_with_cosine(function, at)) {
      all.emplace_back(SineAndCosine{at, at + 1, walk.values({function.instructions[at].a})});
      ++at;
    } else {
      all.emplace_back(Assign{at, walk.definition(at)});
    }
  }
  for (std::uint32_t index = 0; index < loop.given.size(); ++index) {
    all.emplace_back(LoopOperand{loop.given[index], index, walk.values({loop.given[index]})});
  }
  if (loop.count > 0) all.emplace_back(Loop{loop.first, walk.values(loop.shared)});
  for (std::uint32_t field = 0; field < function.fields.size(); ++field) {
    const std::vector<std::uint32_t>& entries = function.fields[field].entries;
    for (std::uint32_t index = 0; index < entries.size(); ++index) {
      all.emplace_back(Entry{entries[index], field, index, walk.values({entries[index]})});
    }
  }
  return all;
}

Sections sections(const std::vector<Statement>& statements, std::size_t length_of_part) {
  Sections cut{.parts = {{}}};
  for (const auto& [place, statement] : ordered(statements)) {
    if (cut.parts.back().size() == length_of_part) cut.parts.emplace_back();
    cut.parts.back().push_back(statement);
  }
  cut.crosses = crossing(cut);
  return cut;
}

}  // namespace elgen
