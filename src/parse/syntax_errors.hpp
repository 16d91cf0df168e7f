// Errors of the expression grammar: the code, the span, and a hint on what to write.
#pragma once

#include "parse/lexer.hpp"

namespace elgen {

/// The error if an operand is expected, but not found: E302, E301, or the lexer's error.
[[nodiscard]] Diagnostic missing_operand_error(const Lexer& tokens);

/// The error if an operand is complete, but the current token can neither continue nor end the
/// expression. E303: two operands without an operator; E306: a decimal comma; E304: a bracket that
/// was never opened; E301, or the lexer's error.
[[nodiscard]] Diagnostic misplaced_token_error(const Lexer& tokens);

/// The error if the current token does not close `opened`: E304, or misplaced_token_error().
[[nodiscard]] Diagnostic unclosed_bracket_error(const Lexer& tokens, const Token& opened);

}  // namespace elgen
