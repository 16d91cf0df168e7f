// The total energy as the sum of the kinetic and the potential energy.
#include "choose/energy_sum.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "choose/chosen.hpp"
#include "elgen/evaluate.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

double value_of(const Program& program, OutputKind kind, const Arguments<double>& at) {
  return evaluate(program, *find_function(program, kind), at).at(0);
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

std::string magnet(const std::string& b) {
  return R"toml(format = 1
[model]
name = "magnet"
[[coordinate]]
name = "x"
[[coordinate]]
name = "y"
[parameters]
b = )toml" +
         b + R"toml(
[energy]
T = "dot(x)^2/2 + dot(y)^2/2"
V = "x^2 + b*x*dot(y)"
)toml";
}

}  // namespace

TEST_CASE(
    "near its lowest point a pendulum at rest has a total energy equal to its potential energy") {
  const ChosenForms model = chosen(pendulum);
  const Program& program = model.choice.program;
  Arguments<double> at =
      domain_of({model.checked.model, {}, model.recursive.leaves}).states.front();
  at.v = {0};
  for (const double angle : {1e-2, 1e-5, 1e-8, 1e-12}) {
    at.q = {angle};
    const double potential = value_of(program, OutputKind::potential_energy, at);
    const double total = value_of(program, OutputKind::total_energy, at);
    CHECK(std::abs(total - potential) <= 1e-15 * std::abs(potential));
  }
}

TEST_CASE(
    "energies with terms linear in the rates are not summed, whatever the value of the terms") {
  for (const char* b : {"3", "0", "1e-8"}) {
    INFO(b);
    const ChosenForms model = chosen(magnet(b));
    for (std::size_t i = 0; i < model.recursive.functions.size(); ++i) {
      INFO(model.recursive.functions[i].name);
      CHECK_FALSE(energy_sum(model.recursive, model.choice.program, i));
    }
    Arguments<double> at =
        domain_of({model.checked.model, {}, model.recursive.leaves}).states.front();
    at.q = {1, 0};
    at.v = {0, 3};
    at.parameters = {2};
    CHECK(value_of(model.choice.program, OutputKind::total_energy, at) == Approx(4.5 + 1 + 6));
  }
}

TEST_CASE("a sum needs both energies") {
  const ChosenForms model = chosen(pendulum);
  Program without = model.choice.program;
  std::erase_if(without.functions,
                [](const Function& f) { return f.kind == OutputKind::kinetic_energy; });
  for (std::size_t i = 0; i < without.functions.size(); ++i) {
    CHECK_FALSE(energy_sum(model.recursive, without, i));
  }
}
