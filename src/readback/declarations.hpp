// declarations: what a header declares beside functions: names, units and ranges, and the values of
// parameters.
#pragma once

#include <string>

#include "readback/dialect.hpp"
#include "readback/expression_reader.hpp"
#include "readback/token_reader.hpp"

namespace elgen {

/// {{"x", "theta"}} or {{ {-2.0, 2.0}, {-unbounded, unbounded} }}, or {} of nothing
void read_declared_values(TokenReader& tokens, const DeclaredArray& array);

/// What expressions may name of the parameters.
[[nodiscard]] std::map<std::string, ParameterMember, std::less<>> parameter_members(
    const Origin& origin);

/// The members of C++ with the values of the model.
void read_cpp_parameters(TokenReader& tokens, const Origin& origin);

/// The members of C, and the macro with their values.
void read_c_parameters(TokenReader& tokens, const Origin& origin, const CodeDialect& dialect);
void read_c_defaults(TokenReader& tokens, const Origin& origin, const CodeDialect& dialect);

}  // namespace elgen
