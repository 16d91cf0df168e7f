// cpp_types: fields and arguments -> the C++ types that hold them.
#pragma once

#include <string>

#include "elgen/arguments.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// "Forces<Scalar>", "Scalar", "std::array<Scalar, 3>": what holds a field of a function.
[[nodiscard]] std::string field_type(OutputKind kind, const Field& field);

/// "const Coordinates<Scalar>&"
[[nodiscard]] std::string argument_type(Opcode argument);

}  // namespace elgen
