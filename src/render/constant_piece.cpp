// constant_piece: "1/2*cos(3/10)" -> \frac{1}{2} \cos \left( \frac{3}{10} \right)
//
// The text is an expression of the model language, so its parser reads it.
#include <cln/integer.h>
#include <cln/rational.h>
#include <fmt/format.h>

#include <algorithm>

#include "equations.hpp"
#include "evaluate/decimal.hpp"
#include "parse/expression_parser.hpp"

namespace elgen::rendering {
namespace {

/// In the model language a constant stands as it is, a sum or product of its own.
Precedence text_precedence(const std::string& text) {
  int depth = 0;
  Precedence lowest = Precedence::atom;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (depth > 0) continue;
    if (c == ' ') lowest = std::min(lowest, Precedence::sum);
    if (c == '/' || c == '*') lowest = std::min(lowest, Precedence::product);
    if (c == '^') lowest = std::min(lowest, Precedence::power);
  }
  return lowest;
}

Piece piece(const Notation& notation, const ExpressionSyntax& syntax);

std::vector<Piece> pieces(const Notation& notation, const ExpressionSyntax& syntax) {
  std::vector<Piece> all;
  for (const ExpressionSyntax& operand : syntax.operands) all.push_back(piece(notation, operand));
  return all;
}

Piece sum_piece(const Notation& notation, const ExpressionSyntax& syntax) {
  Piece total = piece(notation, syntax.operands.front());
  for (std::size_t i = 1; i < syntax.operands.size(); ++i) {
    const ExpressionSyntax& term = syntax.operands[i];
    const bool is_negative = term.kind == SyntaxKind::negate;
    const Piece magnitude = piece(notation, is_negative ? term.operands.front() : term);
    total = is_negative ? difference(notation, total, magnitude) : sum(notation, total, magnitude);
  }
  return total;
}

Piece call_piece(const Notation& notation, const ExpressionSyntax& syntax) {
  const std::vector<Piece> arguments = pieces(notation, syntax);
  for (const FunctionRow& row : function_table) {
    if (row.name == syntax.text) return call(notation, row.id, arguments);
  }
  return square_root(notation, arguments.front());
}

Piece power_piece(const Notation& notation, const ExpressionSyntax& syntax) {
  const Piece base = piece(notation, syntax.operands.front());
  const bool is_safe = base.precedence == Precedence::atom;
  const std::string exponent = piece(notation, syntax.operands.back()).text();
  return {fmt::format(fmt::runtime(notation.power),
                      is_safe ? base.text() : fmt::format("\\left( {} \\right)", base.text()),
                      exponent),
          Precedence::power};
}

Piece piece(const Notation& notation, const ExpressionSyntax& syntax) {
  switch (syntax.kind) {
    case SyntaxKind::number:
      return {syntax.token.source->text.substr(syntax.token.begin,
                                               syntax.token.end - syntax.token.begin)};
    case SyntaxKind::name:
      return {latex_symbol(syntax.text).text()};
    case SyntaxKind::negate:
      return negated(notation, piece(notation, syntax.operands.front()));
    case SyntaxKind::add:
      return sum_piece(notation, syntax);
    case SyntaxKind::multiply: {
      std::vector<Factor> factors;
      for (const Piece& factor : pieces(notation, syntax)) factors.push_back({factor});
      return product(notation, factors);
    }
    case SyntaxKind::divide: {
      const std::vector<Piece> parts = pieces(notation, syntax);
      return quotient(notation, parts.front(), parts.back());
    }
    case SyntaxKind::power:
      return power_piece(notation, syntax);
    case SyntaxKind::call:
      return call_piece(notation, syntax);
  }
  return {};
}

/// 3 and 9.81, but not 1/2: a denominator with a factor 5 is one of a decimal number.
bool is_decimal(const Constant& constant) {
  if (!is_rational(constant.value)) return false;
  const cln::cl_I denominator = cln::denominator(cln::rational(constant.value));
  const bool has_five = denominator == 1 || cln::zerop(cln::mod(denominator, 5));
  return has_five && exact_decimal(constant.value) &&
         exact_text(constant.value).find('e') == std::string::npos;
}

}  // namespace

Piece constant_piece(const Notation& notation, const Constant& constant) {
  const std::string& text = constant.text;
  if (!notation.is_two_dimensional) return {text, text_precedence(text)};
  if (is_decimal(constant)) return {exact_text(constant.value)};
  const SourcePointer source = make_source("constant", text);
  const Span whole{source.get(), 0, static_cast<std::uint32_t>(text.size())};
  Limits limits;
  limits.expression_depth = parsing::deepest_expression;
  limits.literal_digits = text.size();
  const auto syntax = parsing::read_expression(parsing::copied_text(whole), limits);
  return syntax ? piece(notation, *syntax) : Piece{fmt::format("\\mathrm{{{}}}", text)};
}

}  // namespace elgen::rendering
