// Expressions inside the text of options: the part is parsed as a source of its own, then its spans
// are moved to where the part stands.
#include "check/expressions/syntax_part.hpp"

#include <algorithm>

namespace elgen {
namespace {

void move_span(Span& span, const Span& home) {
  span.source = home.source;
  span.begin = std::min(span.begin + home.begin, home.end);
  span.end = std::min(span.end + home.begin, home.end);
}

void move_spans(ExpressionSyntax& expression, const Span& home) {
  move_span(expression.span, home);
  move_span(expression.token, home);
  for (ExpressionSyntax& operand : expression.operands) {
    move_spans(operand, home);
  }
}

}  // namespace

std::optional<ExpressionSyntax> parse_part(const Span& home, const Limits& limits, Report& report) {
  const SourcePointer text = make_source("", std::string(covered_text(home)));
  Result<ExpressionSyntax> result = parse_expression(text, limits);
  for (Diagnostic& diagnostic : result.diagnostics) {
    move_span(diagnostic.span, home);
    if (diagnostic.related) {
      move_span(*diagnostic.related, home);
    }
    report.add(std::move(diagnostic));
  }
  if (result) {
    move_spans(*result, home);
  }
  return std::move(result.value);
}

}  // namespace elgen
