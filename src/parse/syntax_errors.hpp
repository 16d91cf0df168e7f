// The error where the grammar of expressions does not go on: the code, the place, what to write.
#pragma once

#include "parse/lexer.hpp"

namespace elgen {

/// An operand was due, another token is current: E302, E301, or the lexer's own error.
[[nodiscard]] Diagnostic missing_operand(const Lexer& tokens);

/// An operand is complete and the current token can neither continue nor end it: E303 two operands
/// side by side, E306 decimal comma, E304 a bracket that was never opened, E301, or the lexer's.
[[nodiscard]] Diagnostic misplaced_token(const Lexer& tokens);

/// `opened` is not closed by the current token: E304, or what misplaced_token() says.
[[nodiscard]] Diagnostic unclosed_bracket(const Lexer& tokens, const Token& opened);

}  // namespace elgen
