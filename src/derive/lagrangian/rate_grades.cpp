// Grades of expressions in the rates, by Taylor's formula to second order, one small value at a
// time.
#include "derive/lagrangian/rate_grades.hpp"

#include "formulate/chain_rule.hpp"
#include "formulate/needed.hpp"

namespace elgen {

using GiNaC::ex;

RateGrades::RateGrades(Definitions& definitions, const std::vector<ex>& rates)
    : definitions_(definitions) {
  for (const ex& rate : rates) parts_.emplace(rate, std::array<ex, 3>{0, rate, 0});
}

std::array<ex, 3> RateGrades::from_known(const ex& value) const {
  GiNaC::exmap at_rest;
  for (const ex& symbol : symbols_of(definitions_, value)) {
    const auto found = parts_.find(symbol);
    if (found != parts_.end()) at_rest.emplace(symbol, found->second[0]);
  }
  if (at_rest.empty()) return {value, 0, 0};
  const auto resting = [&](const ex& e) {
    return e.subs(at_rest, GiNaC::subs_options::no_pattern);
  };
  GiNaC::exvector linear;
  GiNaC::exvector quadratic;
  for (const Partial& first : partials(definitions_, value, Opcode::velocity)) {
    const std::array<ex, 3>& x = parts_.at(first.variable);
    const ex slope = resting(first.value);
    linear.push_back(slope * x[1]);
    quadratic.push_back(slope * x[2]);
    for (const Partial& second : partials(definitions_, first.value, Opcode::velocity)) {
      const ex curvature = resting(second.value) / 2;
      quadratic.push_back(curvature * x[1] * parts_.at(second.variable)[1]);
    }
  }
  return {resting(value), GiNaC::add(linear), GiNaC::add(quadratic)};
}

void RateGrades::split(std::uint32_t definition) {
  static constexpr std::array<const char*, 3> suffixes{"_rest", "_linear", "_quadratic"};
  const Definition old = definitions_.list[definition];
  std::array<ex, 3> parts = from_known(old.value);
  // A definition of one grade keeps its own symbol.
  for (std::size_t grade = 0; grade < parts.size(); ++grade) {
    const bool is_whole = parts[grade].is_equal(old.value);
    const std::string name = old.name.empty() ? std::string() : old.name + suffixes[grade];
    parts[grade] = is_whole ? old.symbol : define(definitions_, parts[grade], {name, old.origin});
  }
  parts_.emplace(old.symbol, parts);
}

std::array<ex, 3> RateGrades::operator()(const ex& value) {
  visit_needed(definitions_, value, Opcode::velocity, known_,
               [this](std::uint32_t definition) { split(definition); });
  return from_known(value);
}

}  // namespace elgen
