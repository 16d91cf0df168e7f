// statements: every named instruction in the order of evaluation, then the entries.
// -(a*b) is written -a * b and (-a)*b likewise: both round to the same number.
#include "statements.hpp"

#include <algorithm>

namespace elgen {
namespace {

class Writer {
 public:
  Writer(const Program& program, const Function& function, const Vocabulary& vocabulary,
         const std::vector<std::string>& names)
      : function_(function),
        names_(names),
        formulas_(program, function, vocabulary, names),
        statement_of_(names.size()) {}

  FunctionBody body() {
    FunctionBody body;
    for (std::uint32_t at = 0; at < names_.size(); ++at) {
      if (names_[at].empty()) continue;
      statement_of_[at] = static_cast<std::uint32_t>(body.statements.size());
      body.statements.push_back({names_[at], term(formulas_.definition(at), at, true)});
    }
    for (const Field& field : function_.fields) {
      std::vector<Term>& entries = body.entries.emplace_back();
      for (const std::uint32_t at : field.entries) {
        entries.push_back(term(formulas_.entry(at), at, false));
      }
    }
    return body;
  }

 private:
  [[nodiscard]] Term term(const Formula& formula, std::uint32_t at, bool is_definition) const {
    Term term{formula.text()};
    collect(at, is_definition, term);
    std::sort(term.uses.begin(), term.uses.end());
    term.uses.erase(std::unique(term.uses.begin(), term.uses.end()), term.uses.end());
    return term;
  }

  void collect(std::uint32_t at, bool is_written_out, Term& term) const {
    if (!is_written_out && !names_[at].empty()) return term.uses.push_back(statement_of_[at]);
    term.instructions.push_back(at);
    const Instruction& i = function_.instructions[at];
    if (operand_count(i) > 0) collect(i.a, false, term);
    if (operand_count(i) > 1) collect(i.b, false, term);
  }

  const Function& function_;
  const std::vector<std::string>& names_;
  FunctionFormulas formulas_;
  std::vector<std::uint32_t> statement_of_;  ///< of each instruction that has a name
};

}  // namespace

FunctionBody statements(const Program& program, const Function& function,
                        const Vocabulary& vocabulary, const std::vector<std::string>& names) {
  return Writer(program, function, vocabulary, names).body();
}

std::set<FunctionId> called_functions(const Function& function) {
  std::set<FunctionId> calls;
  for (const Instruction& instruction : function.instructions) {
    if (instruction.opcode == Opcode::call) calls.insert(instruction.function);
  }
  return calls;
}

}  // namespace elgen
