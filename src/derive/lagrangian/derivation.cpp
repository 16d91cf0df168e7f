// The parts of a Derivation; graded() and the tree are computed at the first call.
#include "derive/lagrangian/derivation.hpp"

#include <array>

#include "derive/lagrangian/turning.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

Seeds seeds(const Symbols& symbols, bool coordinates_move, bool time_passes) {
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
class RateGrades {
 public:
  RateGrades(Definitions& definitions, const std::vector<ex>& rates);

  /// Throws GiNaC's pole_error if the expression has no value at v = 0.
  [[nodiscard]] std::array<ex, 3> operator()(const ex& value);

 private:
  [[nodiscard]] std::array<ex, 3> from_known(const ex& value) const;
  void split(std::uint32_t definition);

  Definitions& definitions_;
  ExpressionMap<std::array<ex, 3>> parts_;  // of symbols that depend on the velocities
  std::vector<bool> known_;
};

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
  // A definition with a single non-zero part keeps its symbol.
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

void append_nonzero(Terms& terms, const ex& term) {
  if (!term.is_zero()) terms.push_back(term);
}

}  // namespace

std::vector<Weighted> weighted(const Terms& terms, int weight) {
  std::vector<Weighted> result;
  for (const ex& term : terms) result.push_back({term, weight});
  return result;
}

std::vector<Weighted> weighted(const EnergyTerms& terms, int weight) {
  return weighted(values_of(terms), weight);
}

void append(std::vector<Weighted>& to, const std::vector<Weighted>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Vector negative(Vector values) {
  for (ex& value : values) value = -value;
  return values;
}

Vector plus(Vector left, const Vector& right) {
  for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
  return left;
}

Vector substituted(Substitution& leaves, Definitions& definitions, const Vector& values) {
  Vector result;
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
      motion(definitions, motion_seeds(symbols), "_dot"),
      zero_acceleration(definitions, seeds(symbols, true, true), "_dot"),
      fixed_time(definitions, seeds(symbols, true, false), "_dot"),
      time_partial(definitions, seeds(symbols, false, true), "_by_t") {
  append(other_, weighted(lagrangian.kinetic, 1));
  append(other_, weighted(lagrangian.potential, -1));
  append(other_, weighted(lagrangian.lagrangian, 1));
}

Tangent Derivation::displacement(std::size_t velocity) {
  return {definitions, displacement_seeds(symbols, velocity)};
}

Tangent Derivation::unit_velocity(std::size_t velocity) {
  return {definitions, Seeds{{symbols.v[velocity], 1}}};
}

std::string Derivation::velocity_identifier(std::size_t velocity) const {
  return identifier_of(lagrangian.leaves.v[velocity]);
}

const GradedEnergies& Derivation::graded() {
  if (graded_) return *graded_;
  GradedEnergies energies;
  RateGrades grades(definitions, symbols.v);
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

Vector Derivation::by_position(const std::vector<Weighted>& sum) {
  return along_velocities(*this, gradient(definitions, sum, symbols.q));
}

Vector Derivation::by_velocity(const std::vector<Weighted>& sum) {
  Vector momentum = gradient(definitions, sum, symbols.v);
  for (ex& entry : momentum) entry = define(definitions, entry);
  return momentum;
}

}  // namespace elgen
