// The quantities of frames and of their bodies, compared with the oracle, which knows bodies only
// by their positions in the world.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <numeric>

#include "elgen/steps.hpp"
#include "framed.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The values of listed quantities at a state. Components of earlier quantities are leaves.
class ListedValues {
 public:
  ListedValues(const FrameSteps& steps, const State& state)
      : definitions_(steps.equations.definitions), leaves_(steps.equations.symbols) {
    GiNaC::Digits = 60;
    set(leaves_.parameters, state.parameters);
    set(leaves_.q, state.q);
    set(leaves_.v, state.v);
    set({leaves_.t}, {state.t});
    for (const OutputEquations& output : steps.equations.outputs) {
      const RealVector& entries = output.fields[0].entries;
      entries_[output.request.name] = entries;
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string axis = entries.size() == 1 ? "" : "[" + std::to_string(i + 1) + "]";
        for (std::size_t k = 0; k < leaves_.f.size(); ++k) {
          if (steps.equations.leaves.f[k] != output.request.name + axis) continue;
          components_[leaves_.f[k]] = entries[i];
        }
      }
    }
  }

  /// Empty if the quantity is not listed.
  Reals operator()(const std::string& name) {
    Reals result;
    for (const GiNaC::ex& entry : entries_[name]) {
      const GiNaC::ex number = value(entry).evalf();
      result.push_back(cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(number).to_cl_N()));
    }
    return result;
  }

 private:
  void set(const RealVector& leaves, const Reals& values) {
    for (std::size_t i = 0; i < leaves.size(); ++i) known_[leaves[i]] = GiNaC::numeric(values[i]);
  }

  GiNaC::ex value(const GiNaC::ex& expression) {
    GiNaC::exmap values;
    for (const GiNaC::ex& symbol : symbols_of(definitions_, expression)) {
      if (!known_.contains(symbol)) {
        const SymbolPlace& place = definitions_.places.at(symbol);
        const GiNaC::ex meaning =
            place.is_definition ? definitions_.list[place.index].value : components_.at(symbol);
        const GiNaC::ex number = value(meaning);
        known_[symbol] = number;
      }
      values[symbol] = known_[symbol];
    }
    return expression.subs(values, GiNaC::subs_options::no_pattern).evalf();
  }

  const Definitions& definitions_;
  const Symbols& leaves_;
  GiNaC::exmap known_ = {};
  GiNaC::exmap components_ = {};  ///< leaf -> entry of an earlier quantity
  std::map<std::string, RealVector> entries_ = {};
};

cln::cl_R square(const Reals& x) {
  return std::inner_product(x.begin(), x.end(), x.begin(), cln::cl_R(0));
}

/// The position of a body or point in the world, by its identifier.
const Vector3& position_of(const Model& model, const std::string& identifier) {
  for (const Body& body : model.bodies) {
    if (body.identifier == identifier) return body.com;
  }
  const auto point = std::ranges::find(model.points, identifier, &Point::identifier);
  REQUIRE(point != model.points.end());
  return point->position;
}

/// Compares a position in the world or a speed with the oracle.
void expect_motion(const Model& model, const State& state, FrameQuantity kind,
                   const std::string& name, const Reals& listed) {
  INFO(name);
  const Vector3& position = position_of(model, name.substr(name.find('_') + 1));
  Reals places;
  Reals rates;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    places.push_back(*oracle_expression_value(model, position[i], state));
    rates.push_back(*oracle_expression_rate(model, position[i], state));
  }
  if (kind == FrameQuantity::position) CHECK(nearly_equal(listed, places));
  if (kind == FrameQuantity::velocity) CHECK(nearly_equal({square(listed)}, {square(rates)}));
}

}  // namespace

TEST_CASE("positions, speeds and energies of bodies in frames agree with the oracle", "[frames]") {
  std::size_t in_world = 0;
  std::size_t over_components = 0;
  std::size_t energies = 0;
  for (const auto& [name, text] : frame_systems()) {
    INFO(name);
    const Framed system(text);
    const Model& model = system.checked.model;
    const FrameSteps steps = derive_frame_steps(system.lagrangian, model);
    REQUIRE(steps.quantities.size() == steps.equations.outputs.size());
    const State state = some_state(system.checked);
    ListedValues values(steps, state);
    cln::cl_R kinetic = 0;
    for (std::size_t i = 0; i < steps.quantities.size(); ++i) {
      const FrameQuantity kind = steps.quantities[i];
      const OutputEquations& output = steps.equations.outputs[i];
      const Reals listed = values(output.request.name);
      for (const GiNaC::ex& entry : output.fields[0].entries) {
        const LeafSet leaves = dependence(steps.equations.definitions, entry);
        if (leaves.has_any(Opcode::open_value)) ++over_components;
      }
      const bool is_motion = kind == FrameQuantity::position || kind == FrameQuantity::velocity;
      if (is_motion) expect_motion(model, state, kind, output.request.name, listed);
      if (kind == FrameQuantity::position) ++in_world;
      if (kind == FrameQuantity::energy) kinetic = kinetic + listed[0];
    }
    if (!system.lagrangian.masses.empty() || !system.lagrangian.kinetic.empty()) continue;
    const OracleValues expected = oracle_values(model, {.kind = OutputKind::kinetic_energy}, state);
    CHECK(nearly_equal({kinetic}, *expected));
    ++energies;
  }
  CHECK(in_world > 3);
  CHECK(over_components > 3);
  CHECK(energies > 3);
}

TEST_CASE("a name of the model is not used for a quantity") {
  const Framed system(frame_model("taken", "q1 omega_arm", R"toml(
[[frame]]
name = "arm"
parent = "world"
rotate = [["z", "q1 + omega_arm"]]
[[body]]
name = "arm"
frame = "arm"
mass = "m1"
com = ["l", "0", "0"]
)toml"));
  const FrameSteps steps = derive_frame_steps(system.lagrangian, system.checked.model);
  CHECK(steps.requests.front().name == "omega_arm_");
}
