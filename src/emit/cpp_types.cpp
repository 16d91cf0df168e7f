// cpp_types: a type with a name where the header has one, else an array of the field's size.
#include "cpp_types.hpp"

#include <fmt/format.h>

#include "fields.hpp"

namespace elgen {

std::string field_type(OutputKind kind, const Field& field) {
  if (is_scalar(kind, field)) return "Scalar";
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
    case OutputKind::user_bias:
    case OutputKind::reaction:
      return fmt::format("std::array<Scalar, {}>", field.rows * field.columns);
    case OutputKind::user_jacobian:
      return fmt::format("std::array<Scalar, {} * velocity_count>", field.rows);
    case OutputKind::forward_dynamics:
      return field.name == "acceleration" ? "Accelerations<Scalar>"
                                          : "std::array<Scalar, velocity_count>";
    default:
      return "Forces<Scalar>";
  }
}

std::string argument_type(Argument argument) {
  switch (argument) {
    case Argument::parameters:
      return "const Parameters<Scalar>&";
    case Argument::coordinates:
      return "const Coordinates<Scalar>&";
    case Argument::velocities:
      return "const Velocities<Scalar>&";
    case Argument::accelerations:
      return "const Accelerations<Scalar>&";
    case Argument::inputs:
      return "const Inputs<Scalar>&";
    case Argument::time:
      break;
  }
  // Not deduced, so that t may be a number of another type.
  return "const std::common_type_t<Scalar>&";
}

}  // namespace elgen
