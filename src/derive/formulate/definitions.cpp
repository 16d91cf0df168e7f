// The ordered list of definitions: appends definitions, finds the leaves on which an expression
// depends, and writes expressions as text with sorted terms. This text is never parsed.
#include <algorithm>
#include <sstream>

#include "elgen/lagrangian.hpp"
#include "formula/formula_text.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

bool is_atomic(const ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value) || GiNaC::is_a<GiNaC::symbol>(value)) return true;
  return GiNaC::is_a<GiNaC::mul>(value) && GiNaC::is_a<GiNaC::symbol>(-value);
}

const SymbolPlace& symbol_place(const Definitions& definitions, const ex& symbol) {
  return definitions.places.at(symbol);
}

bool precedes(const SymbolPlace& left, const SymbolPlace& right) {
  if (left.is_definition != right.is_definition) return right.is_definition;
  return left.index < right.index;
}

void collect_symbols(const ex& value, std::vector<ex>& symbols) {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    symbols.push_back(value);
    return;
  }
  for (std::size_t i = 0; i < value.nops(); ++i) collect_symbols(value.op(i), symbols);
}

/// If `value` is the symbol of a definition without a name, names it after `definitions.meaning`.
/// Returns `value`.
ex name_after_meaning(Definitions& definitions, const ex& value) {
  const auto& [kind, frame, axis] = definitions.meaning;
  if (kind.empty() || definitions.value_names.names.contains(value)) return value;
  const auto place = definitions.places.find(value);
  if (place == definitions.places.end() || !place->second.is_definition) return value;
  std::string name = kind;
  if (!frame.empty()) name += "_" + frame;
  if (!axis.empty()) name += "_" + axis;
  const int number = ++definitions.value_names.counts[name];
  if (number > 1) name += "_" + std::to_string(number);
  definitions.value_names.names.emplace(value, std::move(name));
  return value;
}

}  // namespace

std::vector<ex> symbols_of(const Definitions& definitions, const ex& value) {
  std::vector<ex> symbols;
  collect_symbols(value, symbols);
  // GiNaC's order of operands depends on addresses, so sort by elgen's order.
  std::sort(symbols.begin(), symbols.end(), [&](const ex& a, const ex& b) {
    return precedes(symbol_place(definitions, a), symbol_place(definitions, b));
  });
  symbols.erase(std::unique(symbols.begin(), symbols.end(), ExpressionEqual{}), symbols.end());
  return symbols;
}

LeafSet dependence(const Definitions& definitions, const ex& value) {
  LeafSet depends;
  for (const ex& symbol : symbols_of(definitions, value)) {
    depends |= symbol_place(definitions, symbol).leaf_dependence;
  }
  return depends;
}

void add_leaf(Definitions& definitions, const ex& symbol, Opcode kind) {
  const auto rank = static_cast<std::uint32_t>(definitions.places.size());
  definitions.places.emplace(symbol, SymbolPlace{false, rank, kind});
}

ex define(Definitions& definitions, const ex& value, Label label) {
  if (is_atomic(value)) return name_after_meaning(definitions, value);
  const auto known = definitions.known_values.find(value);
  if (known != definitions.known_values.end())
    return name_after_meaning(definitions, known->second);

  Definition definition{GiNaC::realsymbol(), value, std::move(label.name), label.origin, {}, {}};
  for (const ex& symbol : symbols_of(definitions, value)) {
    const SymbolPlace& at = symbol_place(definitions, symbol);
    if (at.is_definition) definition.used_definitions.push_back(at.index);
    definition.leaf_dependence |= at.leaf_dependence;
  }
  const auto index = static_cast<std::uint32_t>(definitions.list.size());
  definitions.places.emplace(definition.symbol,
                             SymbolPlace{true, index, definition.leaf_dependence});
  definitions.known_values.emplace(value, definition.symbol);
  definitions.list.push_back(std::move(definition));
  return name_after_meaning(definitions, definitions.list.back().symbol);
}

void name_definition(Definitions& definitions, const ex& symbol, const std::string& text) {
  const auto found = definitions.places.find(symbol);
  if (found == definitions.places.end() || !found->second.is_definition) return;
  std::string& known = definitions.list[found->second.index].name;
  if (known.empty()) known = text;
}

namespace {

std::string ginac_text(const ex& value) {
  std::ostringstream text;
  text << GiNaC::dflt << value;
  return text.str();
}

/// Prints an expression as a text and a sign, because GiNaC moves signs in and out of sums.
class ExpressionWriter {
 public:
  explicit ExpressionWriter(const Definitions& definitions) : definitions_(definitions) {}

  Summand print(const ex& value) const {
    if (GiNaC::is_a<GiNaC::symbol>(value)) {
      const SymbolPlace& at = definitions_.places.at(value);
      return {{at.is_definition ? "d" + std::to_string(at.index) : ginac_text(value)}};
    }
    if (GiNaC::is_a<GiNaC::numeric>(value)) {
      const bool is_negative = value.info(GiNaC::info_flags::negative);
      return {{ginac_text(is_negative ? -value : value)}, is_negative};
    }
    if (GiNaC::is_a<GiNaC::add>(value)) return print_sum(value);
    if (GiNaC::is_a<GiNaC::mul>(value)) return print_product(value);
    if (GiNaC::is_a<GiNaC::power>(value)) return print_power(value);
    if (GiNaC::is_a<GiNaC::function>(value)) return {print_call(value)};
    return {{ginac_text(value)}};
  }

  FormulaText formula_text(const ex& value) const { return sum_text({print(value)}); }

 private:
  std::vector<Summand> sorted_summands(const ex& value, Binding least) const {
    std::vector<Summand> parts;
    for (const ex& part : value) {
      const auto [term, is_negative] = print(part);
      parts.push_back({bracket_if_weaker(term, least), is_negative});
    }
    std::sort(parts.begin(), parts.end(), [](const Summand& left, const Summand& right) {
      return left.term.text < right.term.text;
    });
    return parts;
  }

  /// If the first term is negative, prints the negated sum, and returns the sign separately.
  Summand print_sum(const ex& value) const {
    std::vector<Summand> terms = sorted_summands(value, Binding::sum);
    const bool is_negative = terms.front().is_subtracted;
    for (Summand& term : terms) term.is_subtracted = term.is_subtracted != is_negative;
    return {sum_text(terms), is_negative};
  }

  Summand print_product(const ex& value) const {
    bool is_negative = false;
    std::vector<FormulaText> factors;
    for (const Summand& part : sorted_summands(value, Binding::product)) {
      is_negative = is_negative != part.is_subtracted;
      if (part.term.text != "1") factors.push_back(part.term);
    }
    return {product_text(model_spelling, factors), is_negative};
  }

  Summand print_power(const ex& value) const {
    const ex exponent = value.op(1);
    Summand base = print(value.op(0));
    if (!exponent.info(GiNaC::info_flags::integer)) base = {formula_text(value.op(0))};
    FormulaText above = formula_text(exponent);
    if (!exponent.info(GiNaC::info_flags::posint)) above.binding = Binding::sum;
    const bool is_negative = base.is_subtracted && exponent.info(GiNaC::info_flags::odd);
    return {power_text(base.term, above), is_negative};
  }

  FormulaText print_call(const ex& value) const {
    std::vector<FormulaText> arguments;
    for (const ex& argument : value) arguments.push_back(formula_text(argument));
    return named_call_text(GiNaC::ex_to<GiNaC::function>(value).get_name(), arguments);
  }

  const Definitions& definitions_;
};

}  // namespace

std::string expression_text(const Definitions& definitions, const ex& value) {
  return ExpressionWriter(definitions).formula_text(value).text;
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
