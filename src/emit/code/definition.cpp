// definition: writes a short function as one body and cuts a long function into parts, because
// compile time grows faster than the length (9 000 operations: g++ 21 s whole, 4 s in parts):
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
#include <variant>

#include "emit/code/local_names.hpp"
#include "emit/code/statements.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

/// True if a body of this many statements is cut into parts. A body with inner instructions is
/// never cut, because it has values of two types, and a workspace has only one type.
bool needs_parts(const CompiledDialect& dialect, std::size_t statements) {
  return statements > longest_body && dialect.inner() == nullptr;
}

void add_used_names(const Instruction& instruction, UsedNames& used) {
  if (is_leaf(instruction.opcode)) used.variables.insert(leaf_row(instruction.opcode).symbol);
  if (instruction.opcode == Opcode::square_root) used.functions.insert("sqrt");
  if (instruction.opcode != Opcode::call) return;
  const FunctionRow& row = function_row(instruction.function);
  if (row.own_name.empty() && !is_circular(row.id)) used.functions.insert(row.name);
}

/// Records the array or struct that a statement writes.
void add_used_array(const Entry& /*entry*/, UsedNames& used) { used.variables.insert("result"); }
void add_used_array(const LoopOperand& /*given*/, UsedNames& used) { used.variables.insert("w"); }
void add_used_array(const Assign& /*assign*/, UsedNames& /*used*/) {}
void add_used_array(const SineAndCosine& /*pair*/, UsedNames& /*used*/) {}
void add_used_array(const Loop& /*loop*/, UsedNames& /*used*/) {}

/// True if another part uses one of the instructions (Sections::crosses; empty without parts).
bool any_crosses(const std::vector<std::uint32_t>& instructions, const std::vector<bool>& crosses) {
  return std::ranges::any_of(instructions,
                             [&](std::uint32_t at) { return at < crosses.size() && crosses[at]; });
}

UsedNames used_names(const Function& function, const std::vector<Statement>& statements,
                     const std::vector<bool>& crosses) {
  UsedNames used;
  for (const Statement& statement : statements) {
    const StatementOperands& operands = operands_of(statement);
    for (const std::uint32_t at : operands.written) add_used_names(function.instructions[at], used);
    std::visit([&](const auto& of) { add_used_array(of, used); }, statement);
    if (any_crosses(named_by(statement), crosses) || any_crosses(operands.uses, crosses)) {
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
        ordered_(in_storage_order(function, storage)),
        loop_(column_loop(ordered_)),
        names_(local_names(dialect, program, ordered_)),
        loop_names_{names_},
        formulas_(program, ordered_, dialect, names_) {
    for (std::uint32_t at = loop_.first; at < names_.size(); ++at) {
      names_[at] = solved_name(loop_, ordered_, at);
    }
  }

  FunctionDefinition definition() {
    const Pairing pairing = dialect_.has_pairs() ? Pairing::joint : Pairing::separate;
    const std::vector<Statement> all = statements(ordered_, names_, pairing, loop_);
    if (!needs_parts(dialect_, all.size())) return {short_text(all)};
    Sections cut = sections(all, section_length);
    if (loop_.count > 0) cut.crosses[loop_.first] = true;
    FunctionDefinition result;
    result.workspace = {dialect_.workspace_name(function_), move_to_workspace(cut.crosses)};
    UsedNames passed_on;
    for (const LeafRow& leaf : leaf_table()) passed_on.variables.insert(leaf.symbol);
    result.whole = {dialect_.signature(function_, passed_on),
                    dialect_.body_with_calls(function_, cut.parts.size())};
    for (std::size_t part = 0; part < cut.parts.size(); ++part) {
      result.parts.push_back(part_text(cut, part));
    }
    return result;
  }

 private:
  [[nodiscard]] DefinitionText short_text(const std::vector<Statement>& all) const {
    std::string lines;
    for (const std::string& array : arrays()) {
      lines += fmt::format("  {} {};\n", dialect_.scalar(), array);
    }
    FieldTexts entries(ordered_.fields.size());
    for (const Statement& statement : all) {
      if (const Entry* const entry = std::get_if<Entry>(&statement)) {
        entries[entry->field].push_back(formulas_.entry(entry->instruction).text);
      } else {
        lines += written(statement, {});
      }
    }
    const UsedNames used = used_names(ordered_, all, {});
    const std::string returned = dialect_.return_statement(function_, ordered_, entries);
    return {dialect_.signature(function_, used),
            dialect_.opening(function_, used, false) + lines +
                (returned.empty() ? assignments(dialect_, ordered_, entries) : returned)};
  }

  [[nodiscard]] DefinitionText part_text(const Sections& cut, std::size_t part) const {
    std::string lines;
    for (const Statement& statement : cut.parts[part]) lines += written(statement, cut.crosses);
    const UsedNames used = used_names(ordered_, cut.parts[part], cut.crosses);
    return {dialect_.part_signature(function_, part, used),
            dialect_.opening(function_, used, true) + lines};
  }

  /// Writes a statement. A value that another part reads is in the workspace; others are declared.
  [[nodiscard]] std::string written(const Statement& statement,
                                    const std::vector<bool>& crosses) const {
    const bool is_declared = !any_crosses(named_by(statement), crosses);
    return std::visit([&](const auto& of) { return text(of, is_declared); }, statement);
  }

  [[nodiscard]] std::string text(const Assign& assign, bool is_declared) const {
    const std::uint32_t at = assign.instruction;
    return assignment(is_declared ? dialect_of(at).declaration(names_[at]) : names_[at],
                      formulas_.definition(at).text);
  }

  [[nodiscard]] std::string text(const SineAndCosine& pair, bool is_declared) const {
    const FormulaText angle = formulas_.operand(pair.sine, ordered_.instructions[pair.sine].a);
    return dialect_of(pair.sine).pair(names_[pair.sine], names_[pair.cosine], angle, is_declared);
  }

  [[nodiscard]] std::string text(const Entry& entry, bool /*is_declared*/) const {
    return assignment(dialect_.target(ordered_, entry.field, entry.index),
                      formulas_.entry(entry.instruction).text);
  }

  [[nodiscard]] std::string text(const LoopOperand& given, bool /*is_declared*/) const {
    return assignment(fmt::format("{}[{}]", loop_names_.given, given.index),
                      formulas_.entry(given.instruction).text);
  }

  [[nodiscard]] std::string text(const Loop& /*loop*/, bool /*is_declared*/) const {
    return column_lines(dialect_, program_, ordered_, loop_, loop_names_);
  }

  [[nodiscard]] const CompiledDialect& dialect_of(std::uint32_t at) const {
    const bool is_inner = ordered_.instructions[at].is_inner && dialect_.inner() != nullptr;
    return is_inner ? *dialect_.inner() : dialect_;
  }

  /// Returns the members of the workspace: values that cross into other parts, and the arrays of
  /// the loop. Changes `names_` to the names in the workspace. All values of the loop count as
  /// crossing.
  std::vector<std::string> move_to_workspace(const std::vector<bool>& crosses) {
    std::vector<std::string> shared;
    for (std::size_t at = 0; at < std::min<std::size_t>(crosses.size(), loop_.first); ++at) {
      if (!crosses[at]) continue;
      shared.push_back(names_[at]);
      names_[at] = loop_names_.values[at] = dialect_.shared(names_[at]);
    }
    for (std::size_t at = loop_.first; at < names_.size(); ++at) {
      if (!names_[at].empty()) names_[at] = dialect_.shared(names_[at]);
    }
    const std::vector<std::string> of_loop = arrays();
    shared.insert(shared.end(), of_loop.begin(), of_loop.end());
    loop_names_.given = dialect_.shared(loop_names_.given);
    loop_names_.solved = dialect_.shared(loop_names_.solved);
    return shared;
  }

  /// "given[60]", "solved[60]": declarators for the arrays of the loop; empty without a loop.
  [[nodiscard]] std::vector<std::string> arrays() const {
    if (loop_.count == 0) return {};
    return {fmt::format("{}[{}]", loop_names_.given, loop_.given.size()),
            fmt::format("{}[{}]", loop_names_.solved, loop_.solved.size() * loop_.count)};
  }

  const CompiledDialect& dialect_;
  const Program& program_;
  const Function& function_;
  const Function ordered_;
  const ColumnLoop loop_;
  std::vector<std::string> names_;
  ColumnNames loop_names_;
  const FunctionFormulas formulas_;
};

}  // namespace

std::string assignments(const CompiledDialect& dialect, const Function& function,
                        const FieldTexts& entries) {
  std::string lines;
  for (std::uint32_t field = 0; field < entries.size(); ++field) {
    for (std::uint32_t index = 0; index < entries[field].size(); ++index) {
      lines += assignment(dialect.target(function, field, index), entries[field][index]);
    }
  }
  return lines;
}

FunctionDefinition definition(const CompiledDialect& dialect, const Program& program,
                              const Function& function, Storage storage) {
  return DefinitionWriter(dialect, program, function, storage).definition();
}

}  // namespace elgen
