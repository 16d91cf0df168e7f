// Errors of the expression grammar: the code, the span, and a hint on what to write.
#pragma once

#include "parse/lexer.hpp"

namespace elgen {

/// The current token is no operand, but an operand is expected: E302, E301, or the lexer's error.
[[nodiscard]] Diagnostic missing_operand(const Lexer& tokens);

/// An operand is complete, and the current token can neither continue nor end the expression. E303:
/// two operands without an operator; E306: a decimal comma; E304: a bracket that was never opened;
/// E301, or the lexer's error.
[[nodiscard]] Diagnostic misplaced_token(const Lexer& tokens);

/// The current token does not close `opened`: E304, or the error of misplaced_token().
[[nodiscard]] Diagnostic unclosed_bracket(const Lexer& tokens, const Token& opened);

}  // namespace elgen
