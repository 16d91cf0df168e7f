// Sorted, signed printing. The strings are for people; nothing reads them back.
#include <algorithm>
#include <sstream>

#include "elgen/lagrangian.hpp"
#include "model/formula.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

std::string plain(const ex& value) {
  std::ostringstream text;
  text << GiNaC::dflt << value;
  return text.str();
}

/// A value up to its sign, which GiNaC moves in and out of sums.
class ExpressionWriter {
 public:
  explicit ExpressionWriter(const Definitions& definitions) : definitions_(definitions) {}

  Summand print(const ex& value) const {
    if (GiNaC::is_a<GiNaC::symbol>(value)) {
      const SymbolPlace& at = definitions_.places.at(value);
      return {{at.is_definition ? "d" + std::to_string(at.index) : plain(value)}};
    }
    if (GiNaC::is_a<GiNaC::numeric>(value)) {
      const bool is_negative = value.info(GiNaC::info_flags::negative);
      return {{plain(is_negative ? -value : value)}, is_negative};
    }
    if (GiNaC::is_a<GiNaC::add>(value)) return total(value);
    if (GiNaC::is_a<GiNaC::mul>(value)) return product_of(value);
    if (GiNaC::is_a<GiNaC::power>(value)) return raised(value);
    if (GiNaC::is_a<GiNaC::function>(value)) return {call_of(value)};
    return {{plain(value)}};
  }

  Formula whole(const ex& value) const { return sum(spelling_, {print(value)}); }

 private:
  std::vector<Summand> sorted(const ex& value, Binding least) const {
    std::vector<Summand> parts;
    for (const ex& part : value) {
      const auto [term, is_negative] = print(part);
      parts.push_back({at_least(spelling_, term, least), is_negative});
    }
    std::sort(parts.begin(), parts.end(), [](const Summand& left, const Summand& right) {
      return left.term.text() < right.term.text();
    });
    return parts;
  }

  /// The first term is positive; where it is not, the sum is printed as its negative.
  Summand total(const ex& value) const {
    std::vector<Summand> terms = sorted(value, Binding::sum);
    const bool is_negative = terms.front().is_subtracted;
    for (Summand& term : terms) term.is_subtracted = term.is_subtracted != is_negative;
    return {sum(spelling_, terms), is_negative};
  }

  Summand product_of(const ex& value) const {
    bool is_negative = false;
    std::vector<Formula> factors;
    for (const Summand& part : sorted(value, Binding::product)) {
      is_negative = is_negative != part.is_subtracted;
      if (part.term.text() != "1") factors.push_back(part.term);
    }
    return {product(spelling_, factors), is_negative};
  }

  Summand raised(const ex& value) const {
    const ex exponent = value.op(1);
    Summand base = print(value.op(0));
    if (!exponent.info(GiNaC::info_flags::integer)) base = {whole(value.op(0))};
    Formula above = whole(exponent);
    if (!exponent.info(GiNaC::info_flags::posint)) above.binding = Binding::sum;
    const bool is_negative = base.is_subtracted && exponent.info(GiNaC::info_flags::odd);
    return {power(spelling_, base.term, above), is_negative};
  }

  Formula call_of(const ex& value) const {
    std::vector<Formula> arguments;
    for (const ex& argument : value) arguments.push_back(whole(argument));
    return called(GiNaC::ex_to<GiNaC::function>(value).get_name(), arguments);
  }

  const Definitions& definitions_;
  const Spelling& spelling_ = model_spelling;
};

}  // namespace

std::string expression_text(const Definitions& definitions, const ex& value) {
  return ExpressionWriter(definitions).whole(value).text();
}

std::string dump(const Definitions& definitions) {
  std::string text;
  for (std::size_t i = 0; i < definitions.list.size(); ++i) {
    const Definition& definition = definitions.list[i];
    text += "d" + std::to_string(i) + " = " + expression_text(definitions, definition.value);
    text += definition.name.empty() ? "\n" : "    ; " + definition.name + "\n";
  }
  return text;
}

}  // namespace elgen
