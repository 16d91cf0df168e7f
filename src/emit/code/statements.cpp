// statements: the operands of each are followed to where a name stands for them.
#include "emit/code/statements.hpp"

#include <algorithm>

#include "lower/code_interface.hpp"

namespace elgen {
namespace {

void collect(const Function& function, const std::vector<std::string>& names, std::uint32_t at,
             Statement& statement) {
  const bool is_definition = !statement.is_entry && at == statement.instruction;
  if (!names[at].empty() && !is_definition) return statement.uses.push_back(at);
  statement.written.push_back(at);
  const Instruction& i = function.instructions[at];
  if (operand_count(i) > 0) collect(function, names, i.a, statement);
  if (operand_count(i) > 1) collect(function, names, i.b, statement);
}

/// Of a sine and a cosine, their angle is what is written out.
Statement completed(const Function& function, const std::vector<std::string>& names,
                    Statement statement) {
  const std::uint32_t at = statement.instruction;
  collect(function, names, statement.cosine ? function.instructions[at].a : at, statement);
  std::vector<std::uint32_t>& uses = statement.uses;
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  return statement;
}

}  // namespace

std::vector<Statement> statements(const Function& function, const std::vector<std::string>& names,
                                  Pairing pairing) {
  std::vector<Statement> all;
  for (std::uint32_t at = 0; at < names.size(); ++at) {
    if (names[at].empty()) continue;
    Statement statement{.instruction = at};
    if (pairing == Pairing::joint && is_sine_with_cosine(function, at)) {
      statement.cosine = ++at;
    }
    all.push_back(completed(function, names, std::move(statement)));
  }
  for (std::uint32_t field = 0; field < function.fields.size(); ++field) {
    const std::vector<std::uint32_t>& entries = function.fields[field].entries;
    for (std::uint32_t index = 0; index < entries.size(); ++index) {
      all.push_back(completed(function, names, {entries[index], {}, {}, true, field, index}));
    }
  }
  return all;
}

}  // namespace elgen
