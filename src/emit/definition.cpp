// definition: a short function is one body. A long one is cut, because the time of compilers
// grows faster than the length of a function (9 000 operations: g++ 21 s whole, 4 s in parts):
//
//     Dynamics<Scalar> result;
//     detail::DynamicsWorkspace<Scalar> w;
//     detail::dynamics_part_1(result, w, p, q, v);
//     …
//     return result;
#include "definition.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fields.hpp"
#include "layout.hpp"

namespace elgen {
namespace {

std::string declarations(const Dialect& dialect, const FunctionBody& body) {
  std::string lines;
  for (const Statement& statement : body.statements) {
    lines += assignment(dialect.declaration(statement.name), statement.value);
  }
  return lines;
}

std::string short_lines(const Dialect& dialect, const Function& function, const Function& ordered,
                        const FunctionBody& body) {
  const std::string returned = dialect.returned(function, ordered, body);
  return declarations(dialect, body) +
         (returned.empty() ? assignments(dialect, ordered, body) : returned);
}

/// Temporaries under names that are unique in the function.
std::vector<std::string> local_names(const Dialect& dialect, const Program& program,
                                     const Function& function) {
  std::vector<std::string> names = temporary_names(program, function);
  std::set<std::string> taken;
  for (std::string& name : names) {
    if (name.empty()) continue;
    name = dialect.temporary(name);
    while (!taken.insert(name).second) name += '_';
  }
  return names;
}

/// The names of statements that cross into other parts; they are spelt as shared from here on.
std::vector<std::string> take_shared(const Dialect& dialect, std::vector<std::string>& names,
                                     const std::vector<bool>& crosses) {
  std::vector<std::string> shared;
  std::size_t statement = 0;
  for (std::string& name : names) {
    if (name.empty() || !crosses[statement++]) continue;
    shared.push_back(name);
    name = dialect.shared(name);
  }
  return shared;
}

void use(const Instruction& instruction, UsedNames& used) {
  const std::optional<Argument> argument = argument_of(instruction.opcode);
  if (argument) used.variables.insert(argument_name(*argument));
  if (instruction.opcode == Opcode::square_root) used.functions.insert("sqrt");
  if (instruction.opcode != Opcode::call || !own_name(instruction.function).empty()) return;
  used.functions.insert(function_row(instruction.function).name);
}

UsedNames used_names(const Function& function, const FunctionBody& body, const Sections& cut,
                     std::size_t part) {
  UsedNames used;
  for (const SectionItem& item : cut.parts[part]) {
    const Term& value = value_of(body, item);
    for (const std::uint32_t at : value.instructions) use(function.instructions[at], used);
    const auto crosses = [&cut](std::uint32_t statement) { return cut.crosses[statement]; };
    const bool is_shared = !item.is_entry && crosses(item.index);
    if (item.is_entry) used.variables.insert("result");
    if (is_shared || std::any_of(value.uses.begin(), value.uses.end(), crosses))
      used.variables.insert("w");
  }
  return used;
}

/// The statements and entries of one part; what crosses into another one is no declaration.
std::string part_lines(const Dialect& dialect, const Function& function, const FunctionBody& body,
                       const Sections& cut, std::size_t part) {
  std::string lines;
  for (const SectionItem& item : cut.parts[part]) {
    const std::string& name = item.is_entry ? std::string() : body.statements[item.index].name;
    const std::string target = item.is_entry             ? dialect.target(function, item)
                               : cut.crosses[item.index] ? name
                                                         : dialect.declaration(name);
    lines += assignment(target, value_of(body, item));
  }
  return lines;
}

}  // namespace

std::string assignment(const std::string& target, const Term& value) {
  const std::string start = fmt::format("  {} = ", target);
  const Wrapping wrapping{line_width - start.size() - 1, "      "};
  return start + fmt::format("{}", fmt::join(wrap_expression(value.text, wrapping), "\n")) + ";\n";
}

std::string assignments(const Dialect& dialect, const Function& function,
                        const FunctionBody& body) {
  std::string lines;
  for (std::uint32_t field = 0; field < body.entries.size(); ++field) {
    for (std::uint32_t index = 0; index < body.entries[field].size(); ++index) {
      const SectionItem entry{true, field, index};
      lines += assignment(dialect.target(function, entry), value_of(body, entry));
    }
  }
  return lines;
}

FunctionDefinition definition(const Dialect& dialect, const Program& program,
                              const Function& function, Storage storage) {
  const Function ordered = stored(function, storage);
  std::vector<std::string> names = local_names(dialect, program, ordered);
  const FunctionBody body = statements(program, ordered, dialect, names);
  const bool is_short = length(body) <= longest_body;
  const Sections cut = sections(body, is_short ? longest_body : section_length);
  if (is_short) {
    const UsedNames used = used_names(ordered, body, cut, 0);
    return {{dialect.signature(function, used), dialect.opening(function, used, false) +
                                                    short_lines(dialect, function, ordered, body)}};
  }
  FunctionDefinition result;
  result.workspace = take_shared(dialect, names, cut.crosses);
  const UsedNames passed_on{{argument_names.begin(), argument_names.end()}};
  result.whole = {dialect.signature(function, passed_on),
                  dialect.calling_body(function, cut.parts.size())};
  const FunctionBody shared = statements(program, ordered, dialect, names);
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    const UsedNames used = used_names(ordered, shared, cut, part);
    result.parts.push_back(
        {dialect.part_signature(function, part, used),
         dialect.opening(function, used, true) + part_lines(dialect, ordered, shared, cut, part)});
  }
  return result;
}

}  // namespace elgen
