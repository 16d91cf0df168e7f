#include "emit/code/compiled_dialect.hpp"

#include <fmt/format.h>

#include "emit/code/definition.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/text/layout.hpp"

namespace elgen {

CompiledDialect::CompiledDialect(const Model& model, const Program& program, LanguageId language,
                                 std::string_view access)
    : Dialect(model, program, language),
      access_(access),
      parameters_(parameter_member_texts(model, program.leaves)) {}

std::string CompiledDialect::leaf(Opcode kind, std::uint32_t number) const {
  if (kind == Opcode::parameter) return "p" + access_ + parameters_[number];
  const std::string_view name = leaf_row(kind).symbol;
  return is_single(kind) ? std::string(name) : fmt::format("{}[{}]", name, number);
}

std::string CompiledDialect::loop_assignment(const std::string& target,
                                             const std::string& value) const {
  return assignment("  " + target, value);
}

FunctionDefinition CompiledDialect::function_definition(const Function& function,
                                                        Storage storage) const {
  return elgen::function_definition(*this, program(), function, storage);
}

std::string CompiledDialect::workspace_member(const std::string& name) const {
  return "w" + access_ + name;
}

}  // namespace elgen
