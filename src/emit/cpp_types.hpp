// cpp_types: fields, functions and arguments -> the C++ types that hold them.
#pragma once

#include <string>

#include "arguments.hpp"
#include "elgen/program.hpp"

namespace elgen {

/// "Forces<Scalar>", "Scalar", "std::array<Scalar, 3>": what holds a field of a function.
[[nodiscard]] std::string field_type(OutputKind kind, const Field& field);

/// "SquareMatrix<Scalar>", "ForwardDynamics<Scalar>"
[[nodiscard]] std::string result_type(const Function& function);

/// "const Coordinates<Scalar>&"
[[nodiscard]] std::string argument_type(Argument argument);

}  // namespace elgen
