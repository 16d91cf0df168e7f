// cpp_types: a type with a name where the header has one, else an array of the field's size.
#include "cpp_types.hpp"

#include <fmt/format.h>

#include "fields.hpp"

namespace elgen {

std::string field_type(OutputKind kind, const Field& field) {
  if (is_scalar(kind, field)) return "Scalar";
  const auto type = fmt::runtime(field_row(kind, field.name).type);
  return fmt::format(type, field.rows, field.rows * field.columns);
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
