// Values: converts a TOML value to a ValueSyntax, by the type of its key.
#pragma once

#include "elgen/syntax.hpp"
#include "parse/toml_document.hpp"

namespace elgen {

/// The state of reading a file: the limits, and the diagnostics so far.
struct FileReadState {
  const Limits& limits;
  Diagnostics diagnostics = {};

  void report(Code code, const Span& span, std::string message, std::string hint = {});
};

/// A number or a string as an expression; E104, E109 for other types; E3xx, E9xx of the expression.
[[nodiscard]] ValueSyntax read_expression_value(const TomlValue& value, FileReadState& reading);

/// A string as a name with or without an index; E104, E109, E205, or E3xx and E9xx of the parser.
[[nodiscard]] ValueSyntax read_name(const TomlValue& value, FileReadState& reading);

/// A list of `count` expressions (0: any number); E104, E109, and the errors of the expressions.
[[nodiscard]] ValueSyntax read_expression_list(const TomlValue& value, std::size_t count,
                                               FileReadState& reading);

/// An expression, a list, or a list of lists.
[[nodiscard]] ValueSyntax read_matrix_or_expression(const TomlValue& value, FileReadState& reading);

/// A list of pairs [axis, angle]; the axis is a string or a list of three expressions.
[[nodiscard]] ValueSyntax read_turns(const TomlValue& value, FileReadState& reading);

[[nodiscard]] ValueSyntax read_text(const TomlValue& value, FileReadState& reading);
[[nodiscard]] ValueSyntax read_latex_symbol(const TomlValue& value, FileReadState& reading);
[[nodiscard]] ValueSyntax read_boolean(const TomlValue& value, FileReadState& reading);
[[nodiscard]] ValueSyntax read_integer(const TomlValue& value, FileReadState& reading);

/// Reports E104, "number `1` where a string is expected", or E109 if the value is a number that is
/// not decimal.
void report_wrong_type(const TomlValue& value, std::string_view expected, FileReadState& reading);

/// Moves the parsed expression, if any, to `expression`, and its diagnostics to `reading`.
void store_expression(Result<ExpressionSyntax> read, ExpressionSyntax& expression,
                      FileReadState& reading);

/// A value of `kind` with the text and the span of `value`; the span of a string lacks the quotes.
[[nodiscard]] ValueSyntax make_value(const TomlValue& value, ValueKind kind);

}  // namespace elgen
