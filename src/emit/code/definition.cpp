// definition: writes a short function as one body and cuts a long function into parts, because
// compile time grows faster than the length (g++, 9 000 operations: one body 21 s, parts 4 s):
//     Dynamics<Scalar> result;
//     detail::DynamicsWorkspace<Scalar> w;
//     detail::dynamics_part_1(result, w, p, q, v);
//     …
//     return result;
//
// A loop over columns belongs to a single part.
#include "emit/code/definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <variant>

#include "emit/code/local_names.hpp"
#include "emit/code/statements.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

void add_used_names(const Instruction& instruction, UsedNames& used) {
  if (is_leaf(instruction.opcode)) used.variables.insert(leaf_row(instruction.opcode).symbol);
  if (instruction.opcode == Opcode::square_root) used.functions.insert("sqrt");
  if (instruction.opcode != Opcode::call) return;
  const FunctionRow& row = function_row(instruction.function);
  if (row.own_name.empty() && !is_circular(row.id)) used.functions.insert(row.name);
}

/// Adds to `used` the name of the array or struct that the statement writes.
void add_used_array(const EntryStatement& /*entry*/, UsedNames& used) {
  used.variables.insert("result");
}
void add_used_array(const LoopOperandStatement& /*given*/, UsedNames& used) {
  used.variables.insert("w");
}
void add_used_array(const AssignStatement& /*assign*/, UsedNames& /*used*/) {}
void add_used_array(const SineCosineStatement& /*pair*/, UsedNames& /*used*/) {}
void add_used_array(const AnglesStatement& /*angles*/, UsedNames& /*used*/) {}
void add_used_array(const LoopStatement& /*loop*/, UsedNames& /*used*/) {}

/// True if `crosses` marks one of `instructions`. `crosses`: BodyParts::crosses_parts; empty if the
/// function has no parts.
bool any_crosses_parts(const std::vector<std::uint32_t>& instructions,
                       const std::vector<bool>& crosses) {
  return std::ranges::any_of(instructions,
                             [&](std::uint32_t at) { return at < crosses.size() && crosses[at]; });
}

UsedNames used_names(const Function& function, const std::vector<Statement>& statements,
                     const std::vector<bool>& crosses) {
  UsedNames used;
  for (const Statement& statement : statements) {
    const StatementOperands& operands = operands_of(statement);
    for (const std::uint32_t at : operands.inlined_instructions)
      add_used_names(function.instructions[at], used);
    std::visit([&](const auto& of) { add_used_array(of, used); }, statement);
    if (any_crosses_parts(assigned_values(statement), crosses) ||
        any_crosses_parts(operands.uses, crosses)) {
      used.variables.insert("w");
    }
  }
  return used;
}

class DefinitionWriter {
 public:
  DefinitionWriter(const CompiledDialect& dialect, const Program& program, const Function& function,
                   Storage storage)
      : dialect_(dialect),
        program_(program),
        function_(function),
        ordered_(to_storage_order(function, storage)),
        loop_(column_loop(ordered_)),
        names_(local_names(dialect, program, ordered_)),
        loop_names_{names_},
        formulas_(program, ordered_, dialect, names_) {
    for (std::uint32_t at = loop_.first; at < names_.size(); ++at) {
      const std::optional<std::size_t> index = solved_index(loop_, ordered_, at);
      names_[at] = index ? fmt::format("solved[{}]", *index) : "";
    }
  }

  FunctionDefinition write_definition() {
    const std::vector<Statement> all = make_statements(ordered_, names_, pairing(), loop_);
    if (all.size() <= max_body_statements) return {single_body_text(all)};
    BodyParts cut = cut_into_parts(all, statements_per_part);
    if (loop_.count > 0) cut.crosses_parts[loop_.first] = true;
    FunctionDefinition result;
    result.workspace = {dialect_.workspace_name(function_), move_to_workspace(cut.crosses_parts)};
    UsedNames passed_on;
    for (const LeafRow& leaf : leaf_table()) passed_on.variables.insert(leaf.symbol);
    result.whole = {dialect_.signature(function_, passed_on),
                    dialect_.body_calling_parts(function_, cut.parts.size())};
    for (std::size_t part = 0; part < cut.parts.size(); ++part) {
      result.parts.push_back(part_text(cut, part));
    }
    return result;
  }

 private:
  [[nodiscard]] SineCosinePairing pairing() const {
    if (dialect_.body_rules().groups_angles) return SineCosinePairing::grouped;
    return dialect_.has_sine_cosine_calls() ? SineCosinePairing::joint
                                            : SineCosinePairing::separate;
  }

  [[nodiscard]] DefinitionText single_body_text(const std::vector<Statement>& all) const {
    std::string lines;
    for (const std::string& array : array_declarations()) lines += fmt::format("  {};\n", array);
    FieldTexts entries(ordered_.fields.size());
    for (const Statement& statement : all) {
      if (const EntryStatement* const entry = std::get_if<EntryStatement>(&statement)) {
        entries[entry->field].push_back(formulas_.name_or_formula(entry->instruction).text);
      } else {
        lines += statement_text(statement, {});
      }
    }
    const UsedNames used = used_names(ordered_, all, {});
    const std::string returned = dialect_.return_statement(function_, ordered_, entries);
    return {dialect_.signature(function_, used),
            dialect_.body_prologue(function_, used, false) + lines +
                (returned.empty() ? entry_assignments(dialect_, ordered_, entries) : returned)};
  }

  [[nodiscard]] DefinitionText part_text(const BodyParts& cut, std::size_t part) const {
    std::string lines;
    for (const Statement& statement : cut.parts[part])
      lines += statement_text(statement, cut.crosses_parts);
    const UsedNames used = used_names(ordered_, cut.parts[part], cut.crosses_parts);
    return {dialect_.part_signature(function_, part, used),
            dialect_.body_prologue(function_, used, true) + lines};
  }

  /// The text of `statement`, which declares its values unless another part reads one of them.
  [[nodiscard]] std::string statement_text(const Statement& statement,
                                           const std::vector<bool>& crosses) const {
    const bool is_declared = !any_crosses_parts(assigned_values(statement), crosses);
    return std::visit([&](const auto& of) { return text(of, is_declared); }, statement);
  }

  [[nodiscard]] std::string text(const AssignStatement& assign, bool is_declared) const {
    const std::uint32_t at = assign.instruction;
    return assignment(is_declared ? dialect_of(at).declaration(names_[at]) : names_[at],
                      formulas_.formula(at).text);
  }

  [[nodiscard]] std::string text(const SineCosineStatement& pair, bool is_declared) const {
    const FormulaText angle =
        formulas_.operand_formula(pair.sine, ordered_.instructions[pair.sine].a);
    return dialect_of(pair.sine).sine_cosine_statement(names_[pair.sine], names_[pair.cosine],
                                                       angle, is_declared);
  }

  [[nodiscard]] std::string text(const AnglesStatement& group, bool is_declared) const {
    std::vector<AngleTexts> angles;
    std::optional<std::uint32_t> last;
    for (const std::uint32_t at : group.calls) {
      const Instruction& call = ordered_.instructions[at];
      if (last != call.a) angles.push_back({formulas_.operand_formula(at, call.a)});
      last = call.a;
      (call.function == FunctionId::sin ? angles.back().sine : angles.back().cosine) = names_[at];
    }
    return dialect_of(group.calls.front()).angles_statement(angles, group.number, is_declared);
  }

  [[nodiscard]] std::string text(const EntryStatement& entry, bool /*is_declared*/) const {
    return assignment(dialect_.assignment_target(ordered_, entry.field, entry.index),
                      formulas_.name_or_formula(entry.instruction).text);
  }

  [[nodiscard]] std::string text(const LoopOperandStatement& given, bool /*is_declared*/) const {
    return assignment(fmt::format("{}[{}]", loop_names_.given, given.index),
                      formulas_.name_or_formula(given.instruction).text);
  }

  [[nodiscard]] std::string text(const LoopStatement& /*loop*/, bool /*is_declared*/) const {
    return column_loop_text(dialect_, program_, ordered_, loop_, loop_names_);
  }

  [[nodiscard]] const CompiledDialect& dialect_of(std::uint32_t at) const {
    const bool is_inner =
        ordered_.instructions[at].is_inner && dialect_.inner_vocabulary() != nullptr;
    return is_inner ? *dialect_.inner_vocabulary() : dialect_;
  }

  /// Returns the members of the workspace with their types: values that cross into other parts, and
  /// the arrays of the loop. Changes `names_` to the names in the workspace. All values of the loop
  /// count as crossing.
  std::vector<std::string> move_to_workspace(const std::vector<bool>& crosses) {
    std::vector<std::string> shared;
    for (std::uint32_t at = 0; at < std::min<std::size_t>(crosses.size(), loop_.first); ++at) {
      if (!crosses[at]) continue;
      shared.push_back(fmt::format("{} {}", dialect_of(at).scalar_type(), names_[at]));
      names_[at] = loop_names_.values[at] = dialect_.workspace_member(names_[at]);
    }
    for (std::size_t at = loop_.first; at < names_.size(); ++at) {
      if (!names_[at].empty()) names_[at] = dialect_.workspace_member(names_[at]);
    }
    const std::vector<std::string> of_loop = array_declarations();
    shared.insert(shared.end(), of_loop.begin(), of_loop.end());
    loop_names_.given = dialect_.workspace_member(loop_names_.given);
    loop_names_.solved = dialect_.workspace_member(loop_names_.solved);
    return shared;
  }

  /// "Scalar given[60]", "Scalar solved[60]": the arrays of the loop; empty without a loop.
  [[nodiscard]] std::vector<std::string> array_declarations() const {
    if (loop_.count == 0) return {};
    const std::string_view type = dialect_.scalar_type();
    return {fmt::format("{} {}[{}]", type, loop_names_.given, loop_.varying_operands.size()),
            fmt::format("{} {}[{}]", type, loop_names_.solved,
                        loop_.stored_instructions.size() * loop_.count)};
  }

  const CompiledDialect& dialect_;
  const Program& program_;
  const Function& function_;
  const Function ordered_;
  const ColumnLoop loop_;
  std::vector<std::string> names_;
  ColumnLoopNames loop_names_;
  const FunctionFormulas formulas_;
};

}  // namespace

std::string entry_assignments(const CompiledDialect& dialect, const Function& function,
                              const FieldTexts& entries) {
  std::string lines;
  for (std::uint32_t field = 0; field < entries.size(); ++field) {
    for (std::uint32_t index = 0; index < entries[field].size(); ++index) {
      lines += assignment(dialect.assignment_target(function, field, index), entries[field][index]);
    }
  }
  return lines;
}

FunctionDefinition function_definition(const CompiledDialect& dialect, const Program& program,
                                       const Function& function, Storage storage) {
  return DefinitionWriter(dialect, program, function, storage).write_definition();
}

}  // namespace elgen
