// Sorted, signed printing. The strings are for people; nothing reads them back.
#include "formulate/print.hpp"

#include <algorithm>
#include <sstream>

namespace elgen {

using GiNaC::ex;

namespace {

std::string plain(const ex& value) {
  std::ostringstream text;
  text << GiNaC::dflt << value;
  return text.str();
}

bool is_positive_integer(const ex& value) { return value.info(GiNaC::info_flags::posint); }

}  // namespace

std::string ExpressionPrinter::operator()(const ex& value) const {
  const Signed printed = print(value);
  if (!printed.negative) return printed.text;
  return GiNaC::is_a<GiNaC::add>(value) ? "-(" + printed.text + ")" : "-" + printed.text;
}

ExpressionPrinter::Signed ExpressionPrinter::print(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    const SymbolPlace& at = definitions_.places.at(value);
    return {false, at.is_definition ? "d" + std::to_string(at.index) : plain(value)};
  }
  if (GiNaC::is_a<GiNaC::numeric>(value)) {
    const bool negative = value.info(GiNaC::info_flags::negative);
    return {negative, plain(negative ? -value : value)};
  }
  if (GiNaC::is_a<GiNaC::add>(value)) return sum(value);
  if (GiNaC::is_a<GiNaC::mul>(value)) return product(value);
  if (GiNaC::is_a<GiNaC::power>(value)) return power(value);
  if (GiNaC::is_a<GiNaC::function>(value)) return function(value);
  return {false, plain(value)};
}

std::vector<ExpressionPrinter::Signed> ExpressionPrinter::sorted(const ex& value,
                                                                 bool as_factors) const {
  std::vector<Signed> parts;
  for (std::size_t i = 0; i < value.nops(); ++i) {
    parts.push_back(as_factors ? factor(value.op(i)) : print(value.op(i)));
  }
  std::sort(parts.begin(), parts.end(),
            [](const Signed& left, const Signed& right) { return left.text < right.text; });
  return parts;
}

/// The first term is positive; where it is not, the sum is printed as its negative.
ExpressionPrinter::Signed ExpressionPrinter::sum(const ex& value) const {
  const std::vector<Signed> terms = sorted(value, false);
  const bool negative = terms.front().negative;
  std::string text = terms.front().text;
  for (std::size_t i = 1; i < terms.size(); ++i) {
    text += (terms[i].negative == negative ? " + " : " - ") + terms[i].text;
  }
  return {negative, text};
}

ExpressionPrinter::Signed ExpressionPrinter::product(const ex& value) const {
  Signed result;
  for (const Signed& part : sorted(value, true)) {
    result.negative = result.negative != part.negative;
    if (part.text == "1") continue;
    result.text += (result.text.empty() ? "" : "*") + part.text;
  }
  return result;
}

ExpressionPrinter::Signed ExpressionPrinter::factor(const ex& value) const {
  Signed printed = print(value);
  if (GiNaC::is_a<GiNaC::add>(value)) printed.text = "(" + printed.text + ")";
  return printed;
}

ExpressionPrinter::Signed ExpressionPrinter::power(const ex& value) const {
  const ex exponent = value.op(1);
  Signed base = factor(value.op(0));
  if (base.negative && !exponent.info(GiNaC::info_flags::integer)) {
    base = {false, "(-" + base.text + ")"};
  }
  const std::string raised = (*this)(exponent);
  const bool negative = base.negative && exponent.info(GiNaC::info_flags::odd);
  return {negative,
          base.text + "^" + (is_positive_integer(exponent) ? raised : "(" + raised + ")")};
}

ExpressionPrinter::Signed ExpressionPrinter::function(const ex& value) const {
  std::string text = GiNaC::ex_to<GiNaC::function>(value).get_name() + "(";
  for (std::size_t i = 0; i < value.nops(); ++i) {
    text += (i == 0 ? "" : ", ") + (*this)(value.op(i));
  }
  return {false, text + ")"};
}

std::string dump(const Definitions& definitions) {
  const ExpressionPrinter print(definitions);
  std::string text;
  for (std::size_t i = 0; i < definitions.list.size(); ++i) {
    const Definition& definition = definitions.list[i];
    text += "d" + std::to_string(i) + " = " + print(definition.value);
    text += definition.name.empty() ? "\n" : "    ; " + definition.name + "\n";
  }
  return text;
}

}  // namespace elgen
