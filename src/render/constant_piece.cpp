// constant_piece: 1/2*cos(3/10) -> \frac{1}{2} \cos \left( \frac{3}{10} \right)
//
// In the model language a constant is its own text; elsewhere its form is walked.
#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>

#include "base/number_text.hpp"
#include "equations.hpp"
#include "symbols.hpp"

namespace elgen::rendering {
namespace {

/// In the model language a constant stands as it is, a sum or product of its own.
Precedence text_precedence(const ConstantForm& form) {
  const auto is_negative = [](const ConstantForm& x) {
    return x.kind == ConstantKind::rational && cln::minusp(x.number);
  };
  switch (form.kind) {
    case ConstantKind::rational:
      if (is_negative(form)) return Precedence::sum;
      return cln::denominator(form.number) == 1 ? Precedence::atom : Precedence::product;
    case ConstantKind::sum:
      return Precedence::sum;
    case ConstantKind::product:
      if (form.parts.size() == 1) return Precedence::power;
      return is_negative(form.parts.front().form) ? Precedence::sum : Precedence::product;
    default:
      return Precedence::atom;
  }
}

/// 3 and 9.81, but not 1/2: a denominator with a factor 5 is one of a decimal number.
bool is_decimal(const cln::cl_RA& number) {
  const cln::cl_I denominator = cln::denominator(number);
  const bool has_five = denominator == 1 || cln::zerop(cln::mod(denominator, 5));
  return has_five && exact_decimal(number) && exact_text(number).find('e') == std::string::npos;
}

Piece number_piece(const Notation& notation, const cln::cl_RA& number) {
  if (cln::minusp(number)) return negated(notation, number_piece(notation, -number));
  if (is_decimal(number)) return {exact_text(number)};
  return quotient(notation, {integer_text(cln::numerator(number))},
                  {integer_text(cln::denominator(number))});
}

Piece piece(const Notation& notation, const ConstantForm& form);

Piece sum_piece(const Notation& notation, const std::vector<ConstantPart>& terms) {
  const Piece first = piece(notation, terms.front().form);
  Piece total = terms.front().weight < 0 ? negated(notation, first) : first;
  for (std::size_t i = 1; i < terms.size(); ++i) {
    const Piece term = piece(notation, terms[i].form);
    total = terms[i].weight < 0 ? difference(notation, total, term) : sum(notation, total, term);
  }
  return total;
}

Piece product_piece(const Notation& notation, const std::vector<ConstantPart>& parts) {
  std::vector<Factor> above;
  std::vector<Factor> below;
  for (const ConstantPart& part : parts) {
    (part.weight > 0 ? above : below)
        .push_back({piece(notation, part.form), std::abs(part.weight)});
  }
  if (above.empty()) above.push_back({Piece{"1"}});
  const Piece numerator = product(notation, above);
  return below.empty() ? numerator : quotient(notation, numerator, product(notation, below));
}

Piece call_piece(const Notation& notation, const ConstantForm& form) {
  std::vector<Piece> arguments;
  for (const ConstantPart& part : form.parts) {
    arguments.push_back(piece(notation, part.weight < 0 ? elgen::negated(part.form) : part.form));
  }
  if (form.kind == ConstantKind::square_root) return square_root(notation, arguments.front());
  return call(notation, form.function, arguments);
}

Piece piece(const Notation& notation, const ConstantForm& form) {
  switch (form.kind) {
    case ConstantKind::rational:
      return number_piece(notation, form.number);
    case ConstantKind::pi:
      return {latex_symbol("pi").text()};
    case ConstantKind::sum:
      return sum_piece(notation, form.parts);
    case ConstantKind::product:
      return product_piece(notation, form.parts);
    default:
      return call_piece(notation, form);
  }
}

}  // namespace

Piece constant_piece(const Notation& notation, const ConstantForm& form) {
  if (notation.is_two_dimensional) return piece(notation, form);
  return {text_of(form), text_precedence(form)};
}

}  // namespace elgen::rendering
