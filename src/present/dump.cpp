// Closed forms as text: every term of every sum, in the order of the algebra.
#include <fmt/format.h>

#include "base/number_text.hpp"
#include "elgen/closed_forms.hpp"

namespace elgen {
namespace {

std::string polynomial_text(const Polynomial& sum) {
  if (sum.empty()) return "0";
  std::string text;
  for (const auto& [monomial, coefficient] : sum) {
    if (!text.empty()) text += " + ";
    text += "(" + number_text(coefficient.real);
    if (!cln::zerop(coefficient.imaginary)) text += " + i " + number_text(coefficient.imaginary);
    text += ")";
    for (const AtomPower& power : monomial)
      text += fmt::format(" #{}^{}", power.atom, power.exponent);
  }
  return text;
}

std::string fraction_text(const Fraction& form) {
  std::string text = polynomial_text(form.numerator);
  for (const auto& [factor, exponent] : form.denominator) {
    text += fmt::format(" / factor {}^{}", factor, exponent);
  }
  return text;
}

std::string atom_text(const Atom& atom) {
  std::string arguments;
  for (const Fraction& argument : atom.arguments) arguments += " [" + fraction_text(argument) + "]";
  switch (atom.kind) {
    case AtomKind::leaf:
      return fmt::format("leaf {} {}", static_cast<int>(atom.leaf), atom.index);
    case AtomKind::circular:
      return fmt::format("exp i{} / {}", arguments, number_text(atom.divisor));
    case AtomKind::root:
      return "sqrt" + arguments;
    case AtomKind::call:
      return fmt::format("{}{}", function_row(atom.function).name, arguments);
    case AtomKind::pi:
      return "pi";
  }
  return {};
}

}  // namespace

std::string dump(const ClosedForms& forms) {
  std::string text;
  for (std::size_t i = 0; i < forms.algebra.atoms.size(); ++i) {
    text += fmt::format("#{} = {}\n", i, atom_text(forms.algebra.atoms[i]));
  }
  for (std::size_t i = 0; i < forms.algebra.factors.size(); ++i) {
    text += fmt::format("factor {} = {}\n", i, polynomial_text(forms.algebra.factors[i].shown));
  }
  for (std::size_t i = 0; i < forms.functions.size(); ++i) {
    for (const ClosedField& field : forms.functions[i].fields) {
      for (const std::optional<Fraction>& entry : field.entries) {
        text += fmt::format("{} {} = {}\n", i, field.name, entry ? fraction_text(*entry) : "?");
      }
    }
  }
  return text;
}

}  // namespace elgen
