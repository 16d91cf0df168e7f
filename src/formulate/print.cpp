// Sorted printing. The strings are for people; nothing reads them back.
#include "formulate/print.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace elgen {

using GiNaC::ex;

namespace {

std::string plain(const ex& value) {
  std::ostringstream text;
  text << GiNaC::dflt << value;
  return text.str();
}

bool needs_brackets(const ex& value) {
  return GiNaC::is_a<GiNaC::add>(value) || GiNaC::is_a<GiNaC::mul>(value) ||
         (GiNaC::is_a<GiNaC::numeric>(value) && !value.info(GiNaC::info_flags::nonnegint));
}

}  // namespace

std::string ExpressionPrinter::joined(const ex& value, const char* separator) const {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < value.nops(); ++i) {
    const ex part = value.op(i);
    const bool bracketed = GiNaC::is_a<GiNaC::add>(part) && GiNaC::is_a<GiNaC::mul>(value);
    parts.push_back(bracketed ? "(" + (*this)(part) + ")" : (*this)(part));
  }
  std::sort(parts.begin(), parts.end());
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::string ExpressionPrinter::operator()(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    const SymbolPlace& at = definitions_.places.at(value);
    return at.is_definition ? "d" + std::to_string(at.index) : plain(value);
  }
  if (GiNaC::is_a<GiNaC::add>(value)) return joined(value, " + ");
  if (GiNaC::is_a<GiNaC::mul>(value)) return joined(value, "*");
  if (GiNaC::is_a<GiNaC::power>(value)) {
    const std::string base = (*this)(value.op(0));
    const std::string exponent = (*this)(value.op(1));
    return (needs_brackets(value.op(0)) ? "(" + base + ")" : base) + "^" +
           (needs_brackets(value.op(1)) ? "(" + exponent + ")" : exponent);
  }
  if (GiNaC::is_a<GiNaC::function>(value)) {
    std::string text = GiNaC::ex_to<GiNaC::function>(value).get_name() + "(";
    for (std::size_t i = 0; i < value.nops(); ++i) {
      text += (i == 0 ? "" : ", ") + (*this)(value.op(i));
    }
    return text + ")";
  }
  return plain(value);
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
