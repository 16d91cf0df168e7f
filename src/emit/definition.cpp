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

std::string short_body(const Dialect& dialect, const Function& function, const Function& ordered,
                       const FunctionBody& body) {
  const std::string returned = dialect.returned(function, ordered, body);
  const std::string lines = declarations(dialect, body) +
                            (returned.empty() ? assignments(dialect, ordered, body) : returned);
  return dialect.opening(function, lines, false) + lines;
}

/// The statements and entries of one part; what crosses into another one is no declaration.
std::string part_body(const Dialect& dialect, const Function& function, const FunctionBody& body,
                      const Sections& cut, std::size_t part) {
  std::string lines;
  for (const SectionItem& item : cut.parts[part]) {
    const std::string& name = item.is_entry ? std::string() : body.statements[item.index].name;
    const std::string target = item.is_entry             ? dialect.target(function, item)
                               : cut.crosses[item.index] ? name
                                                         : dialect.declaration(name);
    lines += assignment(target, value_of(body, item));
  }
  return dialect.opening(function, lines, true) + lines;
}

std::vector<std::string> shared_names(const FunctionBody& body, const std::vector<bool>& crosses) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < crosses.size(); ++i) {
    if (crosses[i]) names.push_back(body.statements[i].name);
  }
  return names;
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
  const FunctionBody body = statements(program, ordered, dialect);
  if (length(body) <= longest_body) {
    const std::string text = short_body(dialect, function, ordered, body);
    return {{dialect.signature(function, text), text}};
  }
  const Sections cut = sections(body, section_length);
  const FunctionBody shared = statements(program, ordered, dialect, cut.crosses);
  const std::string calls = dialect.calling_body(function, cut.parts.size());
  FunctionDefinition result{{dialect.signature(function, calls), calls}};
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    const std::string text = part_body(dialect, ordered, shared, cut, part);
    result.parts.push_back({dialect.part_signature(function, part, text), text});
  }
  result.workspace = shared_names(body, cut.crosses);
  return result;
}

}  // namespace elgen
