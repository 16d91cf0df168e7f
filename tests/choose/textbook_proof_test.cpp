// Every entry of every output proved equal to the textbook route's, for every committed model of up
// to three coordinates: L written out in full, differentiated, and compared as canonical sums.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "derive/textbook.hpp"
#include "elgen/closed_forms.hpp"
#include "elgen/lower.hpp"
#include "support/models.hpp"

using namespace elgen;
using namespace elgen::test;
using GiNaC::ex;

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<ex> textbook_entries(const Textbook& book, OutputKind kind, std::size_t n) {
  std::vector<ex> entries;
  const auto each = [&](auto entry) {
    for (std::size_t i = 0; i < n; ++i) entries.push_back(entry(i));
  };
  const auto each_pair = [&](auto entry) {
    for (std::size_t i = 0; i < n * n; ++i) entries.push_back(entry(i / n, i % n));
  };
  switch (kind) {
    case OutputKind::mass_matrix:
      each_pair([&](std::size_t i, std::size_t j) { return book.mass(i, j); });
      break;
    case OutputKind::coriolis_matrix:
      each_pair([&](std::size_t i, std::size_t j) { return book.coriolis(i, j); });
      break;
    case OutputKind::velocity_force:
      each([&](std::size_t i) { return book.velocity_force(i); });
      break;
    case OutputKind::gravity:
      each([&](std::size_t i) { return book.gravity(i); });
      break;
    case OutputKind::drift:
      each([&](std::size_t i) { return book.drift(i); });
      break;
    case OutputKind::bias:
      each([&](std::size_t i) { return book.bias(i); });
      break;
    case OutputKind::momentum:
      each([&](std::size_t i) { return book.momentum(i); });
      break;
    case OutputKind::position_gradient:
      each([&](std::size_t i) { return book.position_gradient(i); });
      break;
    case OutputKind::inverse_dynamics:
      each([&](std::size_t i) { return book.inverse_dynamics(i); });
      break;
    case OutputKind::applied_force:
      each([&](std::size_t i) { return book.without_inputs(book.force(i)); });
      break;
    case OutputKind::kinetic_energy:
      entries.push_back(book.kinetic());
      break;
    case OutputKind::potential_energy:
      entries.push_back(book.potential0());
      break;
    case OutputKind::total_energy:
      entries.push_back(book.kinetic() + book.potential());
      break;
    case OutputKind::energy_function:
      entries.push_back(book.energy());
      break;
    default:
      break;
  }
  return entries;
}

/// Both routes in one program, so that their forms are over the same atoms.
struct BothRoutes {
  EquationsOfMotion equations;
  std::vector<OutputRequest> requests;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  ///< functions: derived, textbook

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

/// M a + bias - B u at the derived acceleration, which is zero on every row.
std::vector<ex> residuals(const Textbook& book, const std::vector<ex>& acceleration) {
  std::vector<ex> result;
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    const ex force = book.force(i);
    ex sum = book.bias(i) - force + book.without_inputs(force);
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
  for (const OutputEquations& output : derived.outputs) {
    if (output.request.kind == OutputKind::forward_dynamics) {
      OutputEquations zero = output;
      zero.fields[0].entries.assign(n, 0);
      routes.compare(zero, residuals(book, output.fields[0].entries));
      continue;
    }
    std::vector<ex> entries = textbook_entries(book, output.request.kind, n);
    if (!entries.empty()) routes.compare(output, std::move(entries));
  }
  return routes;
}

void prove(const CheckedModel& checked) {
  const Result<Lagrangian> lagrangian = formulate(checked.model);
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
      CHECK(proved_equal(forms, *left.entries[i], *right.entries[i]));
    }
  }
}

}  // namespace

TEST_CASE("the textbook route gives the same canonical sums") {
  std::size_t proved = 0;
  for (const auto& file : std::filesystem::directory_iterator(ELGEN_SOURCE_DIR "/models")) {
    if (file.path().extension() != ".toml") continue;
    const CheckedModel checked = checked_model(text_of(file.path()));
    if (checked.model.coordinates.size() > 3) continue;
    INFO(checked.model.name);
    prove(checked);
    ++proved;
  }
  CHECK(proved >= 20);
}
