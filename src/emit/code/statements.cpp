// statements: follows the operands of each statement to named instructions. A group of angles
// stands at its first sine or cosine, after the operands of its other angles. cut_into_parts()
// moves each entry behind the last statement whose value the entry uses, then cuts the statements
// into parts of equal length.
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
AssignedValues values_assigned_by(const AnglesStatement& angles) { return angles.calls; }
AssignedValues values_assigned_by(const EntryStatement& /*entry*/) { return {}; }
AssignedValues values_assigned_by(const LoopOperandStatement& /*given*/) { return {}; }
AssignedValues values_assigned_by(const LoopStatement& loop) { return {loop.first}; }

/// Creates the statements of named values. Every statement follows its operands.
class ValueStatements {
 public:
  ValueStatements(const Function& function, const std::vector<std::string>& names,
                  SineCosinePairing pairing)
      : function_(function),
        pairing_(pairing),
        walk_(function, names),
        is_added_(names.size(), false) {
    if (pairing != SineCosinePairing::grouped) return;
    for (const AngleGroup& group : angle_groups(function)) {
      for (const std::uint32_t at : group) groups_.emplace(at, group);
    }
  }

  void add(std::uint32_t at) {
    if (is_added_[at]) return;
    Statement statement = make_statement(at);
    for (const std::uint32_t value : assigned_values(statement)) is_added_[value] = true;
    for (const std::uint32_t used : operands_of(statement).uses) add(used);
    all_.push_back(std::move(statement));
  }

  std::vector<Statement> take() { return std::move(all_); }

 private:
  Statement make_statement(std::uint32_t at) {
    if (const auto group = groups_.find(at); group != groups_.end())
      return AnglesStatement{group->second, ++group_count_,
                             walk_.walk_values(angles_of(group->second))};
    const std::uint32_t operand = function_.instructions[at].a;
    const bool is_pair =
        pairing_ != SineCosinePairing::separate && starts_sine_cosine_pair(function_, at);
    if (is_pair) return SineCosineStatement{at, at + 1, walk_.walk_values({operand})};
    return AssignStatement{at, walk_.walk_definition(at)};
  }

  std::vector<std::uint32_t> angles_of(const AngleGroup& group) const {
    std::vector<std::uint32_t> angles;
    for (const std::uint32_t at : group) angles.push_back(function_.instructions[at].a);
    return angles;
  }

  const Function& function_;
  SineCosinePairing pairing_;
  OperandWalk walk_;
  std::vector<bool> is_added_;
  std::map<std::uint32_t, AngleGroup> groups_ = {};  ///< of each call
  std::size_t group_count_ = 0;                      ///< in all_ or in work
  std::vector<Statement> all_ = {};
};

/// The statements in a new order: named values keep their order; an entry follows the last value
/// that it uses.
std::multimap<std::size_t, Statement> sort_statements(const std::vector<Statement>& statements) {
  std::map<std::uint32_t, std::size_t> places;
  std::multimap<std::size_t, Statement> by_place;
  for (const Statement& statement : statements) {
    const AssignedValues named = assigned_values(statement);
    std::size_t place = named.empty() ? 0 : by_place.size() + 1;
    for (const std::uint32_t at : named) places[at] = place;
    if (named.empty()) {
      for (const std::uint32_t used : operands_of(statement).uses)
        place = std::max(place, places.at(used));
    }
    by_place.emplace(place, statement);
  }
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
        part_of.resize(std::max<std::size_t>(part_of.size(), at + 1));
        crosses.resize(part_of.size());
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
  ValueStatements values(function, names, pairing);
  for (std::uint32_t at = 0; at < first_repeated_instruction(function); ++at) {
    if (!names[at].empty()) values.add(at);
  }
  std::vector<Statement> all = values.take();
  OperandWalk walk(function, names);
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
