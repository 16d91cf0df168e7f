// statements: follows the operands of each statement to named instructions. cut_into_parts() moves
// each entry behind the last statement whose value the entry uses, then cuts the statements into
// parts of equal length.
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

  /// The operands in the definition of the instruction `at`, even if this instruction has a name.
  StatementOperands walk_definition(std::uint32_t at) {
    inline_operand(at);
    return take_operands();
  }

  StatementOperands walk_values(const std::vector<std::uint32_t>& all) {
    for (const std::uint32_t at : all) visit_operand(at);
    return take_operands();
  }

 private:
  void visit_operand(std::uint32_t at) {
    if (names_[at].empty()) return inline_operand(at);
    operands_.uses.push_back(
        std::min(at, static_cast<std::uint32_t>(first_repeated_instruction(function_))));
  }

  void inline_operand(std::uint32_t at) {
    operands_.inlined_instructions.push_back(at);
    const Instruction& i = function_.instructions[at];
    if (operand_count(i) > 0) visit_operand(i.a);
    if (operand_count(i) > 1) visit_operand(i.b);
  }

  StatementOperands take_operands() {
    std::vector<std::uint32_t>& uses = operands_.uses;
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    return std::exchange(operands_, {});
  }

  const Function& function_;
  const std::vector<std::string>& names_;
  StatementOperands operands_ = {};
};

using AssignedValues = std::vector<std::uint32_t>;

AssignedValues values_assigned_by(const AssignStatement& assign) { return {assign.instruction}; }
AssignedValues values_assigned_by(const SineCosineStatement& pair) {
  return {pair.sine, pair.cosine};
}
AssignedValues values_assigned_by(const EntryStatement& /*entry*/) { return {}; }
AssignedValues values_assigned_by(const LoopOperandStatement& /*given*/) { return {}; }
AssignedValues values_assigned_by(const LoopStatement& loop) { return {loop.first}; }

/// Sort key: named values keep the order of evaluation; an entry follows the last value that it
/// uses.
std::uint64_t sort_key(const Statement& statement) {
  const AssignedValues named = assigned_values(statement);
  if (!named.empty()) return 2 * (std::uint64_t{named.front()} + 1);
  const std::vector<std::uint32_t>& uses = operands_of(statement).uses;
  return uses.empty() ? 0 : 2 * (std::uint64_t{uses.back()} + 1) + 1;
}

/// The statements in ascending order of sort_key(). Statements with equal keys keep their order.
std::multimap<std::uint64_t, Statement> sort_statements(const std::vector<Statement>& statements) {
  std::multimap<std::uint64_t, Statement> by_place;
  for (const Statement& statement : statements) by_place.emplace(sort_key(statement), statement);
  return by_place;
}

/// If one value of a statement crosses, marks all values of this statement in `crosses`, because
/// the statement writes all values together.
void unify_crossings(const BodyParts& cut, std::vector<bool>& crosses) {
  for (const std::vector<Statement>& part : cut.parts) {
    for (const Statement& statement : part) {
      const AssignedValues named = assigned_values(statement);
      const bool is_shared =
          std::ranges::any_of(named, [&](std::uint32_t at) { return crosses[at]; });
      for (const std::uint32_t at : named) crosses[at] = is_shared;
    }
  }
}

std::vector<bool> find_crossing_values(const BodyParts& cut) {
  std::vector<std::size_t> part_of;
  std::vector<bool> crosses;
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    for (const Statement& statement : cut.parts[part]) {
      for (const std::uint32_t used : operands_of(statement).uses) {
        if (part_of[used] != part) crosses[used] = true;
      }
      for (const std::uint32_t at : assigned_values(statement)) {
        part_of.resize(at + 1);
        crosses.resize(at + 1);
        part_of[at] = part;
      }
    }
  }
  unify_crossings(cut, crosses);
  return crosses;
}

}  // namespace

const StatementOperands& operands_of(const Statement& statement) {
  return std::visit([](const auto& of) -> const StatementOperands& { return of.operands; },
                    statement);
}

std::vector<std::uint32_t> assigned_values(const Statement& statement) {
  return std::visit([](const auto& of) { return values_assigned_by(of); }, statement);
}

std::vector<Statement> make_statements(const Function& function,
                                       const std::vector<std::string>& names,
                                       SineCosinePairing pairing, const ColumnLoop& loop) {
  OperandWalk walk(function, names);
  std::vector<Statement> all;
  for (std::uint32_t at = 0; at < first_repeated_instruction(function); ++at) {
    if (names[at].empty()) continue;
    if (pairing == SineCosinePairing::joint && starts_sine_cosine_pair(function, at)) {
      all.emplace_back(
          SineCosineStatement{at, at + 1, walk.walk_values({function.instructions[at].a})});
      ++at;
    } else {
      all.emplace_back(AssignStatement{at, walk.walk_definition(at)});
    }
  }
  for (std::uint32_t index = 0; index < loop.varying_operands.size(); ++index) {
    all.emplace_back(LoopOperandStatement{loop.varying_operands[index], index,
                                          walk.walk_values({loop.varying_operands[index]})});
  }
  if (loop.count > 0)
    all.emplace_back(LoopStatement{loop.first, walk.walk_values(loop.invariant_operands)});
  for (std::uint32_t field = 0; field < function.fields.size(); ++field) {
    const std::vector<std::uint32_t>& entries = function.fields[field].entries;
    for (std::uint32_t index = 0; index < entries.size(); ++index) {
      all.emplace_back(
          EntryStatement{entries[index], field, index, walk.walk_values({entries[index]})});
    }
  }
  return all;
}

BodyParts cut_into_parts(const std::vector<Statement>& statements, std::size_t length_of_part) {
  BodyParts cut{.parts = {{}}};
  for (const auto& [place, statement] : sort_statements(statements)) {
    if (cut.parts.back().size() == length_of_part) cut.parts.emplace_back();
    cut.parts.back().push_back(statement);
  }
  cut.crosses_parts = find_crossing_values(cut);
  return cut;
}

}  // namespace elgen
