// The parts of a Derivation. graded_energies() and the tree are computed at the first call.
#include "derive/lagrangian/derivation.hpp"

#include <array>

#include "derive/lagrangian/turning.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

Seeds direction_seeds(const Symbols& symbols, bool coordinates_move, bool time_passes) {
  Seeds result;
  if (coordinates_move) add_seeds(result, symbols.q, symbols.q_rates);
  if (time_passes) result.emplace(symbols.t, 1);
  return result;
}

/// Splits an expression into its parts f0, f1, f2 of degree 0, 1 and 2 in the velocities:
/// f(q, s v, t) = f0 + s f1 + s^2 f2 + …. This gives T = T2 + T1 + T0 and V = V1 + V0. If each
/// variable of f(x, y, …) is a polynomial x = x0 + s x1 + s^2 x2, Taylor's formula gives:
///
///     f0 = f(x0),   f1 = sum df/dx x1,   f2 = sum df/dx x2 + 1/2 sum sum d2f/dxdy x1 y1
///
///     before    w = dot(q) + N, T = 1/2*J*w^2
///     after     w0 = N, w1 = dot(q);  T2 = 1/2*J*w1^2, T1 = J*w0*w1, T0 = 1/2*J*w0^2
class DegreeSplitter {
 public:
  DegreeSplitter(Definitions& definitions, const std::vector<ex>& rates);

  /// Throws GiNaC's pole_error if the expression has no value at v = 0.
  [[nodiscard]] std::array<ex, 3> operator()(const ex& value);

 private:
  [[nodiscard]] std::array<ex, 3> split_value(const ex& value) const;
  void split_definition(std::uint32_t definition);

  Definitions& definitions_;
  ExpressionMap<std::array<ex, 3>> parts_;  // symbol x that depends on v -> (x0, x1, x2)
  std::vector<bool> known_;
};

DegreeSplitter::DegreeSplitter(Definitions& definitions, const std::vector<ex>& rates)
    : definitions_(definitions) {
  for (const ex& rate : rates) parts_.emplace(rate, std::array<ex, 3>{0, rate, 0});
}

std::array<ex, 3> DegreeSplitter::split_value(const ex& value) const {
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
  for (const PartialDerivative& first :
       partial_derivatives(definitions_, value, Opcode::velocity)) {
    const std::array<ex, 3>& x = parts_.at(first.variable);
    const ex slope = resting(first.value);
    linear.push_back(slope * x[1]);
    quadratic.push_back(slope * x[2]);
    for (const PartialDerivative& second :
         partial_derivatives(definitions_, first.value, Opcode::velocity)) {
      const ex curvature = resting(second.value) / 2;
      quadratic.push_back(curvature * x[1] * parts_.at(second.variable)[1]);
    }
  }
  return {resting(value), GiNaC::add(linear), GiNaC::add(quadratic)};
}

void DegreeSplitter::split_definition(std::uint32_t definition) {
  static constexpr std::array<const char*, 3> suffixes{"_rest", "_linear", "_quadratic"};
  const Definition old = definitions_.list[definition];
  std::array<ex, 3> parts = split_value(old.value);
  // A definition with a single non-zero part keeps its symbol.
  for (std::size_t grade = 0; grade < parts.size(); ++grade) {
    const bool is_whole = parts[grade].is_equal(old.value);
    const std::string name = old.name.empty() ? std::string() : old.name + suffixes[grade];
    parts[grade] = is_whole ? old.symbol : define(definitions_, parts[grade], {name, old.origin});
  }
  parts_.emplace(old.symbol, parts);
}

std::array<ex, 3> DegreeSplitter::operator()(const ex& value) {
  visit_needed_definitions(definitions_, value, Opcode::velocity, known_,
                           [this](std::uint32_t definition) { split_definition(definition); });
  return split_value(value);
}

void append_nonzero(Terms& terms, const ex& term) {
  if (!term.is_zero()) terms.push_back(term);
}

}  // namespace

std::vector<WeightedTerm> weighted_terms(const Terms& terms, int weight) {
  std::vector<WeightedTerm> result;
  for (const ex& term : terms) result.push_back({term, weight});
  return result;
}

std::vector<WeightedTerm> weighted_terms(const EnergyTerms& terms, int weight) {
  return weighted_terms(values_of(terms), weight);
}

void append_terms(std::vector<WeightedTerm>& to, const std::vector<WeightedTerm>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

RealVector negate(RealVector values) {
  for (ex& value : values) value = -value;
  return values;
}

RealVector vector_sum(RealVector left, const RealVector& right) {
  for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
  return left;
}

RealVector define_and_substitute(Substitution& leaves, Definitions& definitions,
                                 const RealVector& values) {
  RealVector result;
  for (const ex& value : values) {
    const ex entry = define(definitions, value);
    result.push_back(leaves(entry));
  }
  return result;
}

Derivation::Derivation(const Lagrangian& source)
    : lagrangian(source),
      definitions(lagrangian.definitions),
      symbols(lagrangian.symbols),
      motion_rate(definitions, motion_seeds(symbols), "_dot"),
      rate_without_acceleration(definitions, direction_seeds(symbols, true, true), "_dot"),
      rate_at_fixed_time(definitions, direction_seeds(symbols, true, false), "_dot"),
      time_partial(definitions, direction_seeds(symbols, false, true), "_by_t") {
  append_terms(lagrangian_terms_, weighted_terms(lagrangian.kinetic, 1));
  append_terms(lagrangian_terms_, weighted_terms(lagrangian.potential, -1));
  append_terms(lagrangian_terms_, weighted_terms(lagrangian.lagrangian, 1));
}

Tangent Derivation::displacement_tangent(std::size_t velocity) {
  return {definitions, displacement_seeds(symbols, velocity)};
}

Tangent Derivation::velocity_tangent(std::size_t velocity) {
  return {definitions, Seeds{{symbols.v[velocity], 1}}};
}

std::string Derivation::velocity_identifier(std::size_t velocity) const {
  return identifier_of(lagrangian.leaves.v[velocity]);
}

const GradedEnergies& Derivation::graded_energies() {
  if (graded_) return *graded_;
  GradedEnergies energies;
  DegreeSplitter grades(definitions, symbols.v);
  for (const EnergyTerm& term : lagrangian.kinetic) {
    const auto parts = grades(term.value);
    append_nonzero(energies.kinetic0, parts[0]);
    append_nonzero(energies.kinetic1, parts[1]);
    append_nonzero(energies.kinetic2, parts[2]);
  }
  for (const EnergyTerm& term : lagrangian.potential) {
    const auto parts = grades(term.value);
    append_nonzero(energies.potential0, parts[0]);
    append_nonzero(energies.potential1, parts[1]);
  }
  for (const EnergyTerm& term : lagrangian.lagrangian) {
    const auto parts = grades(term.value);
    append_nonzero(energies.potential0, -parts[0]);
    append_nonzero(energies.potential1, -parts[1]);
    append_nonzero(energies.kinetic2, parts[2]);
  }
  graded_ = std::move(energies);
  return *graded_;
}

RealVector Derivation::gradient_by_position(const std::vector<WeightedTerm>& sum) {
  return project_to_velocities(*this, gradient(definitions, sum, symbols.q));
}

RealVector Derivation::gradient_by_velocity(const std::vector<WeightedTerm>& sum) {
  RealVector momentum = gradient(definitions, sum, symbols.v);
  for (ex& entry : momentum) entry = define(definitions, entry);
  return momentum;
}

}  // namespace elgen
