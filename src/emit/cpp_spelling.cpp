// cpp_spelling: one spelling for each opcode. sign, min and max are helpers of the header, because
// the standard library has none that every ordered scalar takes.
#include "cpp_spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cpp_constant.hpp"
#include "cpp_names.hpp"
#include "layout.hpp"

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

/// An argument's type, and its name where the body uses it.
std::string argument(std::string_view type, std::string_view name, bool is_used) {
  return is_used ? fmt::format("const {}& {}", type, name) : fmt::format("const {}&", type);
}

std::vector<std::string> cpp_arguments(const Model& model, const Function& function) {
  const OutputRow& row = output_row(function.kind);
  const std::set<Opcode> used = usage(function).opcodes;
  const bool mass_takes_velocity = function.kind == OutputKind::mass_matrix && !model.quadratic;
  std::vector<std::string> list;
  const auto add = [&](bool is_taken, std::string_view type, std::string_view name, Opcode opcode) {
    if (is_taken) list.push_back(argument(type, name, used.count(opcode) != 0));
  };
  add(true, "Parameters<Scalar>", "p", Opcode::parameter);
  add(true, "Coordinates<Scalar>", "q", Opcode::coordinate);
  add(row.takes_velocity || mass_takes_velocity, "Velocities<Scalar>", "v", Opcode::velocity);
  add(row.takes_acceleration, "Accelerations<Scalar>", "a", Opcode::acceleration);
  add(row.takes_input, "Inputs<Scalar>", "u", Opcode::input);
  add(model.uses_time, "std::common_type_t<Scalar>", "t", Opcode::time);
  return list;
}

std::string result_type(const Function& function) {
  if (returns_struct(function)) return struct_name(function) + "<Scalar>";
  return field_type(function.kind, function.fields.front());
}

/// "name(a, b) noexcept" in lines below `start`: arguments aligned, or indented where that is narrow.
std::string with_arguments(const std::string& start, const std::vector<std::string>& arguments) {
  constexpr std::size_t widest_alignment = 60;
  const bool is_aligned = start.size() <= widest_alignment;
  const std::string indent(is_aligned ? start.size() : 4, ' ');
  std::string text = is_aligned ? start : start + "\n" + indent;
  std::size_t column = is_aligned ? start.size() : indent.size();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_last = i + 1 == arguments.size();
    const std::string piece = arguments[i] + (is_last ? ") noexcept" : ",");
    const std::size_t needed = piece.size() + (is_last ? 2 : 0);
    const bool breaks = i > 0 && column + 1 + needed > line_width;
    if (breaks) text += "\n" + indent;
    if (i > 0 && !breaks) text += ' ';
    column = (breaks ? indent.size() : column + (i > 0 ? 1 : 0)) + piece.size();
    text += piece;
  }
  return text;
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

std::string field_type(OutputKind kind, const Field& field) {
  switch (kind) {
    case OutputKind::mass_matrix:
    case OutputKind::coriolis_matrix:
      return "SquareMatrix<Scalar>";
    case OutputKind::input_matrix:
      return "InputMatrix<Scalar>";
    case OutputKind::user_value:
    case OutputKind::user_bias:
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

std::string cpp_signature(const Model& model, const Function& function) {
  const std::string type = result_type(function);
  std::vector<std::string> arguments = cpp_arguments(model, function);
  if (entry_count(function) > largest_returned) {
    arguments.insert(arguments.begin(), type + "& result");
    return with_arguments(fmt::format("void {}(", function.name), arguments);
  }
  return with_arguments(fmt::format("[[nodiscard]] {} {}(", type, function.name), arguments);
}

}  // namespace elgen
