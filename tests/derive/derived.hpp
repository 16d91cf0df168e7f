// A system with its textbook equations and a Derivation for comparison.
#pragma once

#include "derive/lagrangian/derivation.hpp"
#include "support/systems.hpp"
#include "textbook.hpp"

namespace elgen::test {

inline Lagrangian lagrangian_of(const std::string& text) {
  Result<UnreducedLagrangian> lagrangian = formulate(checked_model(text).model);
  if (!lagrangian) throw std::runtime_error(format(lagrangian.diagnostics));
  return *lagrangian;
}

struct Derived {
  explicit Derived(const std::string& text)
      : source(lagrangian_of(text)), textbook(source), derivation(source) {}

  [[nodiscard]] bool agree(const GiNaC::ex& derived, const GiNaC::ex& expected) const {
    std::vector<GiNaC::ex> leaves = source.symbols.parameters;
    for (const auto* list :
         {&source.symbols.q, &source.symbols.v, &source.symbols.a, &source.symbols.u}) {
      leaves.insert(leaves.end(), list->begin(), list->end());
    }
    leaves.push_back(source.symbols.t);
    return vanishes(written_out(derivation.definitions, derived) - expected, leaves);
  }

  [[nodiscard]] std::size_t size() const { return source.symbols.q.size(); }

  Lagrangian source;
  Textbook textbook;
  Derivation derivation;
};

}  // namespace elgen::test
