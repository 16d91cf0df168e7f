// The total energy beside the energies that it is the sum of.
#include "choose/energy_sum.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "choose/chosen.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

double value_of(const Program& program, OutputKind kind, const Arguments<double>& at) {
  for (const Function& function : program.functions) {
    if (function.kind == kind) return evaluate(program, function, at).at(0);
  }
  FAIL("no such function");
  return 0;
}

constexpr const char* pendulum = R"toml(format = 1
[model]
name = "pendulum"
[[coordinate]]
name = "theta"
unit = "rad"
[parameters]
k = 3
[energy]
T = "dot(theta)^2/2"
V = "k*(1 - cos(theta))"
)toml";

constexpr const char* magnet = R"toml(format = 1
[model]
name = "magnet"
[[coordinate]]
name = "x"
[parameters]
b = 3
[energy]
T = "dot(x)^2/2"
V = "x^2 + b*x^2*dot(x)"
)toml";

}  // namespace

TEST_CASE("at rest near its lowest point a pendulum's total energy is its potential one") {
  const Chosen model = chosen(pendulum);
  const Program& program = model.choice.program;
  Arguments<double> at = domain_of(model.checked.model, {}, model.recursive).states.front();
  at.v = {0};
  for (const double angle : {1e-2, 1e-5, 1e-8, 1e-12}) {
    at.q = {angle};
    const double potential = value_of(program, OutputKind::potential_energy, at);
    const double total = value_of(program, OutputKind::total_energy, at);
    CHECK(std::abs(total - potential) <= 1e-15 * std::abs(potential));
  }
}

TEST_CASE("no sum is made of energies of which one has a part in the rates, or is not there") {
  const Chosen model = chosen(magnet);
  const Domain domain = domain_of(model.checked.model, {}, model.recursive);
  const Program& chosen_program = model.choice.program;
  for (std::size_t i = 0; i < model.recursive.functions.size(); ++i) {
    INFO(model.recursive.functions[i].name);
    const bool is_total = model.recursive.functions[i].kind == OutputKind::total_energy;
    const auto sum = energy_sum(model.recursive, chosen_program, i, domain);
    if (!is_total) CHECK_FALSE(sum);
  }
  const Chosen alone = chosen(pendulum);
  Program without = alone.choice.program;
  std::erase_if(without.functions,
                [](const Function& f) { return f.kind == OutputKind::kinetic_energy; });
  for (std::size_t i = 0; i < without.functions.size(); ++i) {
    CHECK_FALSE(energy_sum(alone.recursive, without, i, domain));
  }
}
