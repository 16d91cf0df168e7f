// derive_steps: the textbook route through the definitions, one coordinate after the other. The
// outputs themselves go shorter ways (derivation.hpp); tests compare the two.
#include "elgen/steps.hpp"

#include "derive/lagrangian/turning.hpp"
#include "derive/outputs/outputs.hpp"

namespace elgen {

using GiNaC::ex;

namespace {

FieldEquations scalar(std::string name, ex value) {
  return {std::move(name), 1, 1, {std::move(value)}};
}

FieldEquations vector_field(const std::array<ex, 3>& components) {
  return {"", 3, 1, {components.begin(), components.end()}};
}

class StepByStep {
 public:
  explicit StepByStep(const Lagrangian& lagrangian)
      : derivation_(lagrangian), is_whole_(!lagrangian.lagrangian.empty()) {}

  Steps operator()() {
    if (!derivation_.lagrangian.masses.empty()) add_motions();
    add_energies();
    add_coordinates();
    add_invariants();
    steps_.equations.symbols = derivation_.symbols;
    steps_.equations.leaves = derivation_.lagrangian.leaves;
    steps_.equations.definitions = std::move(derivation_.definitions);
    return std::move(steps_);
  }

 private:
  void add(const std::string& name, std::vector<FieldEquations> fields) {
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
        velocity[axis] = derivation_.coasting(mass.position[axis]);
      }
      velocities.push_back(vector_field(velocity));
    }
    add("positions", std::move(positions));
    add("velocities", std::move(velocities));
  }

  void add_energies() {
    std::vector<FieldEquations> fields;
    if (is_whole_) {
      lagrangian_ = GiNaC::add(derivation_.lagrangian.lagrangian);
    } else {
      const ex kinetic = define(derivation_.definitions, kinetic_energy(derivation_));
      const ex potential = define(derivation_.definitions, full_potential_energy(derivation_));
      fields.push_back(scalar("T", kinetic));
      fields.push_back(scalar("V", potential));
      lagrangian_ = kinetic - potential;
    }
    lagrangian_ = define(derivation_.definitions, lagrangian_);
    fields.push_back(scalar("L", lagrangian_));
    add("energies", std::move(fields));
  }

  void add_coordinates() {
    momentum_ = derivation_.by_velocity({{lagrangian_, 1}});
    const Vector partial = derivation_.by_position({{lagrangian_, 1}});
    const Vector turning = turning_force(derivation_, momentum_);
    const Vector dissipation = elgen::dissipation(derivation_);
    const Vector force = applied_force(derivation_, InputForces::acting);
    for (std::size_t i = 0; i < derivation_.size(); ++i) {
      const ex rate = derivation_.motion(momentum_[i]) + turning[i];
      add(derivation_.lagrangian.leaves.v[i],
          {scalar("momentum", momentum_[i]), scalar("momentum_rate", rate),
           scalar("partial", partial[i]), scalar("dissipation", dissipation[i]),
           scalar("force", force[i]), scalar("left", rate - partial[i] + dissipation[i])});
    }
  }

  void add_invariants() {
    ex energy = -lagrangian_;
    for (std::size_t i = 0; i < derivation_.size(); ++i) {
      energy += derivation_.symbols.v[i] * momentum_[i];
    }
    const ex by_time = derivation_.passing(lagrangian_);
    add("invariants", {scalar("E", energy), scalar("L_by_t", by_time)});
  }

  Derivation derivation_;
  bool is_whole_;
  ex lagrangian_;
  Vector momentum_;
  Steps steps_;
};

}  // namespace

Result<Steps> derive_steps(const Lagrangian& lagrangian) {
  try {
    return StepByStep(lagrangian)();
  } catch (const GiNaC::pole_error&) {
    return Diagnostic{Code::E313, {}, "the Lagrangian divides by zero, whatever the state is"};
  }
}

}  // namespace elgen
