// Proves derived outputs equal to the outputs of class Textbook, which writes L out in full and
// differentiates, and proves residuals of forward dynamics equal to 0. Covers every committed model
// with up to three coordinates, or two if the model has constraints.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "derive/textbook.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/lower.hpp"
#include "support/models.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

using Number = ex (Textbook::*)() const;
using Entry = ex (Textbook::*)(std::size_t i) const;
using MatrixEntry = ex (Textbook::*)(std::size_t i, std::size_t j) const;

const std::map<OutputKind, Number> numbers{{OutputKind::kinetic_energy, &Textbook::kinetic},
                                           {OutputKind::potential_energy, &Textbook::potential0},
                                           {OutputKind::total_energy, &Textbook::total},
                                           {OutputKind::energy_function, &Textbook::energy}};
const std::map<OutputKind, Entry> vectors{
    {OutputKind::velocity_force, &Textbook::velocity_force},
    {OutputKind::gravity, &Textbook::gravity},
    {OutputKind::drift, &Textbook::drift},
    {OutputKind::bias, &Textbook::bias},
    {OutputKind::momentum, &Textbook::momentum},
    {OutputKind::position_gradient, &Textbook::position_gradient},
    {OutputKind::inverse_dynamics, &Textbook::inverse_dynamics},
    {OutputKind::applied_force, &Textbook::applied_force}};
const std::map<OutputKind, MatrixEntry> matrices{
    {OutputKind::mass_matrix, &Textbook::mass}, {OutputKind::coriolis_matrix, &Textbook::coriolis}};

/// The entries of the output `kind`; empty if the textbook derivation has no such output.
std::vector<ex> textbook_entries(const Textbook& book, OutputKind kind, std::size_t n) {
  std::vector<ex> entries;
  if (numbers.count(kind) > 0) entries.push_back((book.*numbers.at(kind))());
  for (std::size_t i = 0; vectors.count(kind) > 0 && i < n; ++i) {
    entries.push_back((book.*vectors.at(kind))(i));
  }
  for (std::size_t i = 0; matrices.count(kind) > 0 && i < n * n; ++i) {
    entries.push_back((book.*matrices.at(kind))(i / n, i % n));
  }
  return entries;
}

/// Both derivations in one program, so that their forms share atoms.
struct BothRoutes {
  EquationsOfMotion equations;
  std::vector<OutputRequest> requests;
  std::vector<std::pair<std::size_t, std::size_t>>
      pairs;  ///< indices of functions: derived, textbook

  void add(const std::string& name, std::vector<ex> entries) {
    OutputRequest request;
    request.kind = OutputKind::user_value;
    request.user = static_cast<std::uint32_t>(requests.size());
    request.name = name;
    requests.push_back(request);
    const auto rows = static_cast<std::uint32_t>(entries.size());
    equations.outputs.push_back({request, {{"", rows, 1, std::move(entries)}}});
  }

  void compare(const OutputEquations& derived, std::vector<ex> textbook) {
    pairs.emplace_back(requests.size(), requests.size() + 1);
    add(derived.request.name, derived.fields[0].entries);
    add("textbook_" + derived.request.name, std::move(textbook));
  }
};

/// A^T lambda as derived; 0 without constraints.
std::vector<ex> forces_of_constraints(const EquationsOfMotion& derived, std::size_t n) {
  std::vector<ex> jacobian;
  std::vector<ex> multipliers;
  for (const OutputEquations& output : derived.outputs) {
    for (const auto& field : output.fields) {
      if (output.request.kind == OutputKind::constraint_jacobian) jacobian = field.entries;
      if (field.name == "multipliers") multipliers = field.entries;
    }
  }
  std::vector<ex> result(n, 0);
  for (std::size_t k = 0; k < jacobian.size(); ++k) {
    result[k % n] += jacobian[k] * multipliers.at(k / n);
  }
  return result;
}

/// M a + bias - B u - A^T lambda, which must be 0, for a = `acceleration` and A^T lambda = `held`.
std::vector<ex> residuals(const Textbook& book, const std::vector<ex>& acceleration,
                          const std::vector<ex>& held) {
  std::vector<ex> result;
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    const ex force = book.force(i);
    ex sum = book.bias(i) - force + book.without_inputs(force) - held[i];
    for (std::size_t j = 0; j < acceleration.size(); ++j) sum += book.mass(i, j) * acceleration[j];
    result.push_back(sum);
  }
  return result;
}

BothRoutes both_routes(const Lagrangian& lagrangian, const EquationsOfMotion& derived,
                       const Textbook& book) {
  BothRoutes routes;
  routes.equations.symbols = derived.symbols;
  routes.equations.leaves = derived.leaves;
  routes.equations.definitions = derived.definitions;
  const std::size_t n = lagrangian.symbols.q.size();
  const std::vector<ex> held = forces_of_constraints(derived, n);
  for (const OutputEquations& output : derived.outputs) {
    if (output.request.kind == OutputKind::forward_dynamics) {
      OutputEquations zero = output;
      zero.fields[0].entries.assign(n, 0);
      routes.compare(zero, residuals(book, output.fields[0].entries, held));
      continue;
    }
    std::vector<ex> entries = textbook_entries(book, output.request.kind, n);
    if (!entries.empty()) routes.compare(output, std::move(entries));
  }
  return routes;
}

void prove(const CheckedModel& checked) {
  const Result<UnreducedLagrangian> lagrangian = formulate(checked.model);
  const auto derived = derive(*lagrangian, checked.scene.outputs, {});
  const Textbook book(*lagrangian);
  const BothRoutes routes = both_routes(*lagrangian, *derived, book);
  const Result<Program> program = lower(routes.equations, routes.requests, {});
  REQUIRE(program);
  ClosedForms forms = present(*program, {3'000'000, 30'000'000, 20'000});
  for (const auto& [one, other] : routes.pairs) {
    const ClosedField& left = forms.functions[one].fields[0];
    const ClosedField& right = forms.functions[other].fields[0];
    REQUIRE(left.entries.size() == right.entries.size());
    for (std::size_t i = 0; i < left.entries.size(); ++i) {
      INFO(program->functions[one].name << " " << i);
      REQUIRE(left.entries[i]);
      REQUIRE(right.entries[i]);
      CHECK(is_proved_equal(forms, *left.entries[i], *right.entries[i]));
    }
  }
}

}  // namespace

TEST_CASE("the textbook derivation gives the same canonical sums") {
  std::size_t proved = 0;
  for (const std::filesystem::path& path : model_paths()) {
    const CheckedModel checked = checked_model(read_text(path));
    // Solutions with constraints have more terms, so `most` is smaller.
    const std::size_t most = checked.model.constraints.empty() ? 3 : 2;
    if (checked.model.coordinates.size() > most) continue;
    INFO(checked.model.name);
    prove(checked);
    ++proved;
  }
  CHECK(proved >= 20);
}
