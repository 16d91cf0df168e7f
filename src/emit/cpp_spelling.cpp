// cpp_spelling: one spelling for each opcode. sign, min and max are helpers of the header, because
// the standard library has none that every ordered scalar takes.
#include "cpp_spelling.hpp"

#include <fmt/format.h>

#include "cpp_constant.hpp"
#include "cpp_names.hpp"

namespace elgen {
namespace {

std::string member_text(const Model& model, const std::string& leaf) {
  for (const Parameter& parameter : model.parameters) {
    if (parameter.name != leaf) continue;
    const ParameterArray& array = model.parameter_arrays[parameter.array];
    return array.is_array ? fmt::format("p.{}[{}]", array.name, parameter.element)
                          : "p." + array.name;
  }
  return "p." + leaf;
}

}  // namespace

CppSpelling::CppSpelling(const Model& model, const Program& program) {
  for (const std::string& leaf : program.leaves.parameters) {
    parameters_.push_back(member_text(model, leaf));
  }
}

std::string CppSpelling::leaf(const Instruction& instruction) const {
  switch (instruction.opcode) {
    case Opcode::parameter:
      return parameters_[instruction.a];
    case Opcode::coordinate:
      return fmt::format("q[{}]", instruction.a);
    case Opcode::velocity:
      return fmt::format("v[{}]", instruction.a);
    case Opcode::acceleration:
      return fmt::format("a[{}]", instruction.a);
    case Opcode::input:
      return fmt::format("u[{}]", instruction.a);
    default:
      return "t";
  }
}

Term CppSpelling::constant(const Constant& constant) const {
  const bool is_negative = cln::minusp(constant.value);
  const std::string magnitude = is_short_constant(constant.value)
                                    ? cpp_magnitude(constant.value)
                                    : constant_name(constant) + "<Scalar>()";
  return {(is_negative ? "-" : "") + magnitude,
          is_negative ? Precedence::negation : Precedence::primary};
}

std::string CppSpelling::call(FunctionId function, const std::string& arguments) const {
  switch (function) {
    case FunctionId::sign:
      return fmt::format("detail::sign_of<Scalar>({})", arguments);
    case FunctionId::min:
      return fmt::format("detail::smaller<Scalar>({})", arguments);
    case FunctionId::max:
      return fmt::format("detail::larger<Scalar>({})", arguments);
    default:
      return fmt::format("{}({})", function_row(function).name, arguments);
  }
}

std::string CppSpelling::square_root(const std::string& argument) const {
  return "sqrt(" + argument + ")";
}

std::string CppSpelling::temporary(const std::string& name) const { return cpp_temporary(name); }

std::string CppSpelling::shared(const std::string& name) const { return "w." + name; }

std::string field_type(OutputKind kind, const Field& field) {
  switch (kind) {
    case OutputKind::mass_matrix:
    case OutputKind::coriolis_matrix:
      return "SquareMatrix<Scalar>";
    case OutputKind::input_matrix:
      return "InputMatrix<Scalar>";
    case OutputKind::coordinate_rates:
    case OutputKind::normalized:
      return "Coordinates<Scalar>";
    case OutputKind::inverse_dynamics_derivatives:
    case OutputKind::forward_dynamics_derivatives:
      return field.name == "by_input" ? "InputMatrix<Scalar>" : "SquareMatrix<Scalar>";
    case OutputKind::linearization:
      return field.name == "A" ? "std::array<Scalar, 4 * velocity_count * velocity_count>"
                               : "std::array<Scalar, 2 * velocity_count * input_count>";
    case OutputKind::user_value:
      if (field.columns > 1) {
        return fmt::format("std::array<Scalar, {}>", field.rows * field.columns);
      }
      [[fallthrough]];
    case OutputKind::user_bias:
    case OutputKind::reaction:
      return field.rows == 1 ? "Scalar" : fmt::format("std::array<Scalar, {}>", field.rows);
    case OutputKind::user_jacobian:
      return fmt::format("std::array<Scalar, {} * velocity_count>", field.rows);
    case OutputKind::forward_dynamics:
      return field.name == "acceleration" ? "Accelerations<Scalar>"
                                          : "std::array<Scalar, velocity_count>";
    default:
      break;
  }
  const std::vector<FieldRow>& rows = output_row(kind).fields;
  const bool is_vector = !rows.empty() && rows.front().rows == Extent::velocities;
  return is_vector ? "Forces<Scalar>" : "Scalar";
}

OutputKind kind_of_field(const Program& program, const Function& function, const Field& field) {
  if (function.kind != OutputKind::dynamics) return function.kind;
  for (const Function& candidate : program.functions) {
    if (candidate.name == field.name) return candidate.kind;
  }
  const OutputRow* row = find_output(field.name);
  return row != nullptr ? row->kind : function.kind;
}

bool is_returned(const Function& function) { return entry_count(function) <= largest_returned; }

}  // namespace elgen
