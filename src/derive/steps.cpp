// derive_textbook_steps: Lagrange's equations as in a textbook, one coordinate after the other. The
// outputs use shorter routes (derivation.hpp); tests compare both.
#include "elgen/steps.hpp"

#include <algorithm>

#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

FieldEquations make_field(std::string name, Terms entries) {
  const auto rows = static_cast<std::uint32_t>(entries.size());
  return {std::move(name), rows, 1, std::move(entries)};
}

FieldEquations vector_field(const std::array<ex, 3>& components) {
  return {"", 3, 1, {components.begin(), components.end()}};
}

class StepsDerivation {
 public:
  explicit StepsDerivation(const Lagrangian& lagrangian)
      : derivation_(lagrangian), has_whole_lagrangian_(!lagrangian.lagrangian.empty()) {}

  DerivationSteps operator()() {
    if (!derivation_.lagrangian.masses.empty()) add_motions();
    if (!derivation_.lagrangian.constraints.empty()) add_constraints();
    add_energies();
    add_coordinates();
    add_invariants();
    steps_.equations.symbols = derivation_.symbols;
    steps_.equations.leaves = derivation_.lagrangian.leaves;
    steps_.equations.definitions = std::move(derivation_.definitions);
    return std::move(steps_);
  }

 private:
  void add_step(const std::string& name, std::vector<FieldEquations> fields) {
    for (FieldEquations& field : fields) {
      for (ex& entry : field.entries) entry = define(derivation_.definitions, entry);
    }
    OutputRequest request;
    request.kind = OutputKind::user_value;
    request.user = static_cast<std::uint32_t>(steps_.requests.size());
    request.name = name;
    steps_.requests.push_back(request);
    steps_.equations.outputs.push_back({request, std::move(fields)});
  }

  void add_motions() {
    std::vector<FieldEquations> positions;
    std::vector<FieldEquations> velocities;
    for (const PointMass& mass : derivation_.lagrangian.masses) {
      steps_.masses.push_back(mass.origin);
      positions.push_back(vector_field(mass.position));
      std::array<ex, 3> velocity;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        velocity[axis] = derivation_.rate_without_acceleration(mass.position[axis]);
      }
      velocities.push_back(vector_field(velocity));
    }
    add_step("positions", std::move(positions));
    add_step("velocities", std::move(velocities));
  }

  /// A field with f (or phi) of each constraint, then a field with the right-hand side 0.
  void add_constraints() {
    std::vector<FieldEquations> sides;
    for (const ConstraintEquation& constraint : derivation_.lagrangian.constraints) {
      sides.push_back(
          make_field(derivation_.lagrangian.leaves.multipliers[sides.size()], {constraint.value}));
    }
    sides.push_back(make_field("", {ex(0)}));
    add_step("constraints", std::move(sides));
  }

  /// The non-zero summands: `of_masses` (the sum over points and bodies), then `others`. If all are
  /// 0, the list is a single 0.
  [[nodiscard]] Terms nonzero_summands(const ex& of_masses, const Terms& others) {
    Terms result{of_masses};
    result.insert(result.end(), others.begin(), others.end());
    std::erase_if(result, [](const ex& term) { return term.is_zero(); });
    if (result.empty()) result.emplace_back(0);
    for (ex& term : result) term = define(derivation_.definitions, term);
    return result;
  }

  void add_energies() {
    const Lagrangian& all = derivation_.lagrangian;
    if (has_whole_lagrangian_) {
      summands_ = nonzero_summands(0, values_of(all.lagrangian));
      add_step("energies", {make_field("L", summands_)});
      return;
    }
    const ex of_masses = kinetic_energy_of_masses(derivation_);
    GiNaC::exvector spins;
    Terms others;
    for (const auto& [value, origin] : all.kinetic) {
      (origin == EnergyOrigin::spin ? spins : others).push_back(value);
    }
    summands_ = nonzero_summands(of_masses + GiNaC::add(spins), others);
    const Terms potential =
        nonzero_summands(potential_energy_of_masses(derivation_), values_of(all.potential));
    add_step("energies", {make_field("T", summands_), make_field("V", potential)});
    for (const ex& term : potential) summands_.push_back(-term);
  }

  void add_coordinates() {
    std::vector<RealVector> rates;
    std::vector<RealVector> partials;
    for (const ex& term : summands_) {
      momenta_.push_back(derivation_.gradient_by_velocity({{term, 1}}));
      partials.push_back(derivation_.gradient_by_position({{term, 1}}));
      rates.push_back(hamel_force(derivation_, momenta_.back()));
    }
    std::vector<RealVector> dissipation;
    for (const EnergyTerm& term : derivation_.lagrangian.dissipation) {
      dissipation.push_back(derivation_.gradient_by_velocity({{term.value, 1}}));
    }
    const RealVector force = applied_force(derivation_, InputForces::acting);
    const RealVector held = constraint_force(derivation_, derivation_.symbols.multipliers);
    for (std::size_t i = 0; i < derivation_.size(); ++i) {
      Terms rate;
      for (std::size_t k = 0; k < summands_.size(); ++k) {
        rate.push_back(derivation_.motion_rate(momenta_[k][i]) + rates[k][i]);
      }
      add_step(
          derivation_.lagrangian.leaves.v[i],
          {make_field("momentum", row(momenta_, i)), make_field("momentum_rate", std::move(rate)),
           make_field("partial", row(partials, i)), make_field("dissipation", row(dissipation, i)),
           make_field("force", {force[i] + held[i]})});
    }
  }

  [[nodiscard]] static Terms row(const std::vector<RealVector>& all, std::size_t i) {
    Terms result;
    for (const RealVector& each : all) result.push_back(each[i]);
    return result;
  }

  void add_invariants() {
    Terms energies;
    Terms by_time;
    for (std::size_t k = 0; k < summands_.size(); ++k) {
      ex energy = -summands_[k];
      for (std::size_t i = 0; i < derivation_.size(); ++i) {
        energy += derivation_.symbols.v[i] * momenta_[k][i];
      }
      energies.push_back(energy);
      by_time.push_back(derivation_.time_partial(summands_[k]));
    }
    add_step("invariants",
             {make_field("E", std::move(energies)), make_field("L_by_t", std::move(by_time))});
  }

  Derivation derivation_;
  bool has_whole_lagrangian_;
  Terms summands_ = {};                   ///< of L
  std::vector<RealVector> momenta_ = {};  ///< of each summand
  DerivationSteps steps_;
};

}  // namespace

Result<DerivationSteps> derive_textbook_steps(const Lagrangian& lagrangian) {
  try {
    return StepsDerivation(lagrangian)();
  } catch (const GiNaC::pole_error&) {
    return Diagnostic{Code::E313, {}, "the Lagrangian divides by zero, whatever the state is"};
  }
}

}  // namespace elgen
