// Fixed parameters become numbers, terms with zeros vanish, and locked variables disappear from all
// parts of a Lagrangian.
#include "elgen/specialise.hpp"

#include <catch2/catch.hpp>

#include "derive/specialise/passes.hpp"
#include "support/systems.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

SceneOptions fixing(const std::vector<std::string>& settings) {
  SceneOptions options;
  for (const std::string& setting : settings) {
    options.fixed.push_back(make_source("command line", setting));
  }
  return options;
}

Lagrangian specialised(const std::string& text, const std::vector<std::string>& settings) {
  const CheckedModel checked = checked_model(text, fixing(settings));
  return *specialise(*formulate(checked.model), checked);
}

/// Prints definitions, masses, energies and forces.
std::string text_of(const Lagrangian& lagrangian) {
  const auto print = [&](const GiNaC::ex& value) {
    return expression_text(lagrangian.definitions, value);
  };
  std::string text = dump(lagrangian.definitions);
  for (const PointMass& mass : lagrangian.masses) {
    text += print(mass.mass);
    for (const GiNaC::ex& component : mass.position) text += " " + print(component);
    text += "\n";
  }
  for (const auto& terms : {values_of(lagrangian.kinetic), values_of(lagrangian.potential),
                            values_of(lagrangian.dissipation), lagrangian.forces}) {
    for (const GiNaC::ex& term : terms) text += print(term) + "\n";
  }
  return text;
}

std::string refused(const std::string& parameters, const std::string& potential,
                    const std::vector<std::string>& settings) {
  const CheckedModel checked = checked_model(model_text("one", R"toml(
[[coordinate]]
name = "x"
[parameters]
)toml" + parameters + R"toml([energy]
T = "dot(x)^2/2"
V = ")toml" + potential + "\"\n"),
                                             fixing(settings));
  const Result<Lagrangian> result = specialise(*formulate(checked.model), checked);
  REQUIRE_FALSE(result);
  const Diagnostic& error = result.diagnostics.at(0);
  return std::string(code_row(error.code).name) + " " + std::string(covered_text(error.span)) +
         ": " + error.message;
}

Lagrangian locked(const std::string& text, const std::string& scene) {
  const CheckedModel checked = checked_scene(text, scene);
  return *specialise(*formulate(checked.model), checked);
}

}  // namespace

TEST_CASE("without fixed parameters nothing changes") {
  CHECK(text_of(specialised(read_model("cart_pole"), {})) ==
        text_of(*formulate(checked_model(read_model("cart_pole")).model)));
}

TEST_CASE("a fixed parameter is an exact number everywhere") {
  const Lagrangian lagrangian = specialised(read_model("cart_pole"), {"l=1/3", "M=4"});
  CHECK(lagrangian.masses[0].mass.is_equal(4));
  const GiNaC::ex& x = lagrangian.masses[1].position[0];
  const Definition& bob = lagrangian.definitions.list[lagrangian.definitions.places.at(x).index];
  const GiNaC::ex& q = lagrangian.symbols.q[0];
  const GiNaC::ex& theta = lagrangian.symbols.q[1];
  CHECK(bob.value.is_equal(q + GiNaC::numeric(1, 3) * sin(theta)));
}

TEST_CASE("every part of a Lagrangian is specialised") {
  const Lagrangian lagrangian = specialised(
      read_model("everything"), {"m", "J", "k", "b", "c", "Omega", "A", "nu", "g", "e"});
  LeafSet depends;
  const auto look = [&](const std::vector<GiNaC::ex>& values) {
    for (const GiNaC::ex& value : values) depends |= dependence(lagrangian.definitions, value);
  };
  for (const PointMass& mass : lagrangian.masses) {
    look({mass.mass, mass.position[0], mass.position[1], mass.position[2]});
  }
  look({(*lagrangian.gravity)[0], (*lagrangian.gravity)[1]});
  look(values_of(lagrangian.kinetic));
  look(values_of(lagrangian.potential));
  look(values_of(lagrangian.dissipation));
  look(lagrangian.forces);
  for (const PointForce& force : lagrangian.point_forces) {
    look({force.position[0], force.position[1], force.force[0], force.force[1]});
  }
  for (const NamedOutput& output : lagrangian.outputs) look(output.values);
  CHECK_FALSE(depends.has_any(Opcode::parameter));
  CHECK(depends.has_any(Opcode::coordinate));
}

TEST_CASE("fixed values with undefined results are refused, naming the parameter") {
  CHECK(refused("j = 1\nk = 1\n", "x^2/k", {"j", "k=0"}) ==
        "E312 k: `k` at its fixed value makes a denominator 0, whatever the state is");
  CHECK(refused("j = 1\nk = 1\n", "x^2*log(k)", {"j", "k=0"}) ==
        "E313 k: `k` at its fixed value makes a value undefined, whatever the state is");
  CHECK(refused("j = 1\nk = 1\n", "x^2*sqrt(k)", {"j", "k=-1"}) ==
        "E314 k: `k` at its fixed value makes a value complex, whatever the state is");
  CHECK(refused("j = 2\nk = 1\n", "x^2/(j - k)", {"j=1", "k=1"}) ==
        "E312 j: `j`, `k` at their fixed values make a denominator 0, whatever the state is");
}

TEST_CASE("a locked coordinate disappears with its velocity and force") {
  const Lagrangian l = locked(read_model("cart_pole"), "[lock]\nx = { value = \"2*t\" }\n");
  REQUIRE(l.symbols.q.size() == 1);
  CHECK(l.symbols.v.size() == 1);
  CHECK(l.symbols.a.size() == 1);
  CHECK(l.symbols.q_rates.size() == 1);
  CHECK(l.forces.size() == 1);
  CHECK(l.leaves.q == std::vector<std::string>{"theta"});
  CHECK(l.leaves.uses_time);
  CHECK_FALSE(l.reaction_source.has_value());
}

TEST_CASE("positions are evaluated at the locked function of time") {
  const Lagrangian l = locked(read_model("cart_pole"), "[lock]\nx = { value = \"2*t\" }\n");
  const GiNaC::ex& x = l.masses[1].position[0];
  const Definition& bob = l.definitions.list[l.definitions.places.at(x).index];
  CHECK(bob.leaf_dependence.has_any(Opcode::time));
  CHECK(bob.leaf_dependence.has_any(Opcode::coordinate));
}

TEST_CASE("for a requested reaction the whole Lagrangian is kept") {
  const Lagrangian l =
      locked(read_model("cart_pole"), "[lock]\ntheta = { value = 0, reaction = true }\n");
  REQUIRE(l.reaction_source.has_value());
  CHECK(l.reaction_source->velocities == std::vector<std::uint32_t>{1});
  CHECK(l.reaction_source->unreduced->symbols.q.size() == 2);
  CHECK(l.reaction_source->unreduced->definitions.list.empty());
  CHECK(l.reaction_source->values.at(l.reaction_source->unreduced->symbols.v[1]).is_zero());
}

TEST_CASE("a scene may fix parameters and lock coordinates") {
  const Lagrangian l = locked(read_model("cart_pole"),
                              "[parameters]\nfixed = { l = \"1/3\" }\n"
                              "[lock]\ntheta = { value = \"l*t\" }\n");
  LeafSet depends;
  for (const PointMass& mass : l.masses) {
    for (const GiNaC::ex& x : mass.position) depends |= dependence(l.definitions, x);
  }
  CHECK_FALSE(depends.has_any(Opcode::parameter));
  CHECK(depends.has_any(Opcode::time));
}

TEST_CASE("a leaf is replaced through definitions, and equal values share a definition") {
  UnreducedLagrangian lagrangian = *formulate(checked_model(read_model("cart_pole")).model);
  const std::vector<Definition> old = lagrangian.definitions.list;
  substitute_leaves(lagrangian, {{lagrangian.symbols.q[1], 0}});
  // With theta = 0 the bob is above the cart, so the bob and the cart have the same x.
  CHECK(lagrangian.masses[1].position[0].is_equal(lagrangian.masses[0].position[0]));
  // The old definitions remain, although nothing refers to them.
  REQUIRE(lagrangian.definitions.list.size() >= old.size());
  for (std::size_t i = 0; i < old.size(); ++i) {
    CHECK(lagrangian.definitions.list[i].symbol.is_equal(old[i].symbol));
    CHECK(lagrangian.definitions.list[i].value.is_equal(old[i].value));
  }
  CHECK_FALSE(dependence(lagrangian.definitions, lagrangian.masses[1].position[1])
                  .has_any(Opcode::coordinate));
}
