// dialect: what C and C++ have in common.
#include "dialect.hpp"

#include "fields.hpp"

namespace elgen {

Dialect::Dialect(const Model& model, const Program& program, std::string_view access)
    : Vocabulary(code_spelling()),
      model_(model),
      program_(program),
      access_(access),
      parameters_(parameter_members(model, program.leaves)) {}

std::string Dialect::leaf(const Instruction& instruction) const {
  const bool is_parameter = instruction.opcode == Opcode::parameter;
  return is_parameter ? "p" + access_ + parameters_[instruction.a] : variable_text(instruction);
}

Formula Dialect::square_root(const Formula& radicand) const {
  return called(library_function("sqrt"), {radicand});
}

Formula Dialect::call(FunctionId function, const std::vector<Formula>& arguments) const {
  switch (function) {
    case FunctionId::sign:
      return called(own_function("sign_of"), arguments);
    case FunctionId::min:
      return called(own_function("smaller"), arguments);
    case FunctionId::max:
      return called(own_function("larger"), arguments);
    default:
      return called(library_function(function_row(function).name), arguments);
  }
}

std::string Dialect::shared(const std::string& name) const { return "w" + access_ + name; }

OutputKind Dialect::kind_of(const Function& function, const Field& field) const {
  return kind_of_field(program_, function, field);
}

bool Dialect::is_number(const Function& function, const Field& field) const {
  return is_scalar(kind_of(function, field), field);
}

}  // namespace elgen
