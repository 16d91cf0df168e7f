// The ordered list of definitions: appending, and what an expression depends on.
#include <algorithm>

#include "elgen/lagrangian.hpp"

namespace elgen {

namespace {

bool is_atomic(const GiNaC::ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value) || GiNaC::is_a<GiNaC::symbol>(value)) return true;
  return GiNaC::is_a<GiNaC::mul>(value) && GiNaC::is_a<GiNaC::symbol>(-value);
}

const SymbolPlace& place(const Definitions& definitions, const GiNaC::ex& symbol) {
  return definitions.places.at(symbol);
}

bool precedes(const SymbolPlace& left, const SymbolPlace& right) {
  if (left.is_definition != right.is_definition) return right.is_definition;
  return left.index < right.index;
}

void collect_symbols(const GiNaC::ex& value, std::vector<GiNaC::ex>& symbols) {
  if (GiNaC::is_a<GiNaC::symbol>(value)) {
    symbols.push_back(value);
    return;
  }
  for (std::size_t i = 0; i < value.nops(); ++i) collect_symbols(value.op(i), symbols);
}

}  // namespace

std::vector<GiNaC::ex> symbols_of(const Definitions& definitions, const GiNaC::ex& value) {
  std::vector<GiNaC::ex> symbols;
  collect_symbols(value, symbols);
  // GiNaC's operand order depends on addresses: sort by our own.
  std::sort(symbols.begin(), symbols.end(), [&](const GiNaC::ex& a, const GiNaC::ex& b) {
    return precedes(place(definitions, a), place(definitions, b));
  });
  symbols.erase(std::unique(symbols.begin(), symbols.end(), ExpressionEqual{}), symbols.end());
  return symbols;
}

LeafSet dependence(const Definitions& definitions, const GiNaC::ex& value) {
  LeafSet depends;
  for (const GiNaC::ex& symbol : symbols_of(definitions, value)) {
    depends |= place(definitions, symbol).depends;
  }
  return depends;
}

void add_leaf(Definitions& definitions, const GiNaC::ex& symbol, Opcode kind) {
  const auto rank = static_cast<std::uint32_t>(definitions.places.size());
  definitions.places.emplace(symbol, SymbolPlace{false, rank, kind});
}

GiNaC::ex define(Definitions& definitions, const GiNaC::ex& value, Label label) {
  if (is_atomic(value)) return value;
  const auto known = definitions.known_values.find(value);
  if (known != definitions.known_values.end()) return known->second;

  Definition definition{GiNaC::realsymbol(), value, std::move(label.name), label.origin, {}, {}};
  for (const GiNaC::ex& symbol : symbols_of(definitions, value)) {
    const SymbolPlace& at = place(definitions, symbol);
    if (at.is_definition) definition.uses.push_back(at.index);
    definition.depends |= at.depends;
  }
  const auto index = static_cast<std::uint32_t>(definitions.list.size());
  definitions.places.emplace(definition.symbol, SymbolPlace{true, index, definition.depends});
  definitions.known_values.emplace(value, definition.symbol);
  definitions.list.push_back(std::move(definition));
  return definitions.list.back().symbol;
}

void name(Definitions& definitions, const GiNaC::ex& symbol, const std::string& text) {
  const auto found = definitions.places.find(symbol);
  if (found == definitions.places.end() || !found->second.is_definition) return;
  std::string& known = definitions.list[found->second.index].name;
  if (known.empty()) known = text;
}

}  // namespace elgen
