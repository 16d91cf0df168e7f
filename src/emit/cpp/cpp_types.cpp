// cpp_types: a type with a name where the header has one, else an array of the field's size.
#include "emit/cpp/cpp_types.hpp"

#include <fmt/format.h>

#include "emit/text/fields.hpp"

namespace elgen {

std::string field_type(OutputKind kind, const Field& field) {
  if (is_scalar(kind, field)) return "Scalar";
  const auto type = fmt::runtime(field_row(kind, field.name).type);
  return fmt::format(type, field.rows, field.rows * field.columns);
}

/// That of t is not deduced, so that t may be a number of another type.
std::string argument_type(Opcode argument) {
  return fmt::format("const {}&", leaf_row(argument).type);
}

}  // namespace elgen
