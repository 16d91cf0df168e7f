// Scenes that remove cyclic coordinates: the reduced equations are the whole model's equations at
// constant momenta, and the cyclic rates are the whole model's rates.
#include <catch2/catch.hpp>

#include "elgen/simulate.hpp"
#include "numbers/exact_number.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen::test {
namespace {

using cln::cl_R;
using Numbers = std::vector<cl_R>;

struct Reduction {
  const char* model;
  const char* routh;
};

constexpr const char* routh_outputs =
    "[outputs]\ninverse_dynamics = true\ncyclic_rates = true\npotential_energy = true\n"
    "mass_matrix = true\n[routh]\n";

const Reduction reductions[]{
    {"kepler_polar", "phi = \"0.6\"\n"},    {"heavy_top", "psi = true\n"},
    {"heavy_top", "phi = true\n"},          {"heavy_top", "phi = true\npsi = \"2\"\n"},
    {"spherical_pendulum", "phi = true\n"}, {"free_particle", "y = true\nx = \"6\"\n"},
    {"central_force_open", "phi = true\n"},
};

bool is_close(const cl_R& x, const cl_R& y) {
  return cln::abs(x - y) <= power_of_ten(-50) * (1 + cln::abs(x) + cln::abs(y));
}

OracleValues truth_at(const Model& model, OutputKind kind, const State& state) {
  return oracle_values(model, {.kind = kind}, state);
}

/// The whole model's state for a state of the reduced model, with cyclic accelerations that keep
/// the momenta constant.
std::optional<State> whole_state(const Model& reduced, const State& state) {
  const Model& whole = *reduced.reduction.unreduced;
  const OracleValues rates = truth_at(reduced, OutputKind::cyclic_rates, state);
  if (!rates) return std::nullopt;
  State moving = state;
  for (std::size_t i = 0; i < rates->size(); ++i) {
    const CyclicCoordinate& cyclic = whole.reduction.cyclic[i];
    moving.q.insert(moving.q.begin() + cyclic.coordinate, cl_R(cln::cl_RA(1) / 3));
    moving.v.insert(moving.v.begin() + cyclic.velocity, (*rates)[i]);
    moving.a.insert(moving.a.begin() + cyclic.velocity, cl_R(0));
  }
  const OracleValues forces = truth_at(whole, OutputKind::inverse_dynamics, moving);
  const OracleValues mass = truth_at(whole, OutputKind::mass_matrix, moving);
  if (!forces || !mass) return std::nullopt;
  const auto entry = [&](std::size_t i, std::size_t j) {
    return (*mass)[whole.reduction.cyclic[i].velocity * moving.v.size() +
                   whole.reduction.cyclic[j].velocity];
  };
  const auto force = [&](std::size_t i) { return (*forces)[whole.reduction.cyclic[i].velocity]; };
  if (rates->size() == 1) {
    moving.a[whole.reduction.cyclic[0].velocity] = -force(0) / entry(0, 0);
    return moving;
  }
  const cl_R determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
  moving.a[whole.reduction.cyclic[0].velocity] =
      (entry(0, 1) * force(1) - entry(1, 1) * force(0)) / determinant;
  moving.a[whole.reduction.cyclic[1].velocity] =
      (entry(1, 0) * force(0) - entry(0, 0) * force(1)) / determinant;
  return moving;
}

/// tau of the whole model without the rows of the cyclic coordinates, which must be 0.
std::optional<Numbers> forces_left(const Model& reduced, const State& state) {
  const std::optional<State> moving = whole_state(reduced, state);
  if (!moving) return std::nullopt;
  OracleValues forces =
      truth_at(*reduced.reduction.unreduced, OutputKind::inverse_dynamics, *moving);
  if (!forces) return std::nullopt;
  const std::vector<CyclicCoordinate>& cyclic = reduced.reduction.cyclic;
  for (auto each = cyclic.rbegin(); each != cyclic.rend(); ++each) {
    CHECK(is_close((*forces)[each->velocity], 0));
    forces->erase(forces->begin() + each->velocity);
  }
  return forces;
}

void check_program(const Products& products, OutputKind kind, const State& state) {
  const Function* const function = find_function(*products.program, kind);
  REQUIRE(function != nullptr);
  const OracleValues truth = truth_at(products.checked->model, kind, state);
  const OracleValues found =
      to_oracle_values(evaluate(*products.program, *function, arguments_at<Real>(state)));
  REQUIRE(truth);
  REQUIRE(found);
  REQUIRE(found->size() == truth->size());
  for (std::size_t i = 0; i < truth->size(); ++i) CHECK(is_close((*found)[i], (*truth)[i]));
}

Products reduced_products(const Reduction& reduction, const std::string& value = {}) {
  PipelineOptions options;
  options.goals = {Goal::choose};
  if (!value.empty()) options.scene.values = {make_source("--set", value)};
  return derived(
      inputs_of(model_file(reduction.model), routh_outputs + std::string(reduction.routh)),
      options);
}

/// r after ten revolutions about the centre.
double last_distance(const std::string& rest) {
  const PipelineSources inputs = inputs_of(model_file("kepler_polar"), rest);
  const Products checked = products_with(&Products::checked, inputs, {.goals = {Goal::check}});
  const Products products = derived(inputs, outputs_for_run(checked.checked->model));
  const Result<Trajectory> run = simulate(*products.checked, *products.program, nullptr,
                                          {.duration = 150, .tolerance = 1e-11});
  REQUIRE(run);
  return run->last.at(1);
}

const Parameter& last_parameter(const Products& products) {
  return products.checked->model.parameters.back();
}

}  // namespace

TEST_CASE("the reduced model moves like the whole model at its momenta") {
  for (const Reduction& reduction : reductions) {
    INFO(reduction.model << ": " << reduction.routh);
    const Products products = reduced_products(reduction);
    const Model& model = products.checked->model;
    Sampler draw(5);
    for (std::size_t turn = 0; turn < 4; ++turn) {
      State state = nominal_state(model, products.checked->scene);
      draw_motion(model, draw, turn, state);
      const OracleValues left = truth_at(model, OutputKind::inverse_dynamics, state);
      const std::optional<Numbers> whole = forces_left(model, state);
      REQUIRE(left);
      REQUIRE(whole);
      REQUIRE(left->size() == whole->size());
      for (std::size_t i = 0; i < left->size(); ++i) CHECK(is_close((*left)[i], (*whole)[i]));
      for (const OutputKind kind : {OutputKind::inverse_dynamics, OutputKind::cyclic_rates,
                                    OutputKind::potential_energy, OutputKind::mass_matrix}) {
        check_program(products, kind, state);
      }
    }
  }
}

TEST_CASE("a run of the reduced model agrees with the whole model over ten revolutions") {
  CHECK(last_distance("[routh]\nphi = true\n") == Approx(last_distance("")).epsilon(1e-7));
}

TEST_CASE("a momentum has its start value, the value in the scene, or the option's value") {
  CHECK(last_parameter(reduced_products({"kepler_polar", "phi = true\n"})).name == "p_phi");
  CHECK(last_parameter(reduced_products({"kepler_polar", "phi = true\n"})).value ==
        cln::cl_RA(3) / 5);
  CHECK(last_parameter(reduced_products({"kepler_polar", "phi = \"0.7\"\n"})).value ==
        cln::cl_RA(7) / 10);
  // p_phi doubles to 6/5, because m = 1 is twice the value in the file.
  CHECK(last_parameter(reduced_products({"kepler_polar", "phi = true\n"}, "m=1")).value ==
        cln::cl_RA(6) / 5);
  CHECK(last_parameter(reduced_products({"kepler_polar", "phi = true\n"}, "p_phi=2")).value == 2);
  const auto known = [](const std::string& value) {
    const Products products = reduced_products({"kepler_polar", "phi = true\n"}, value);
    return products.checked->model.reduction.cyclic.front().momentum;
  };
  CHECK(known("") == cln::cl_RA(3) / 5);
  CHECK(known("p_phi=2") == 2);
}

TEST_CASE("a momentum may be fixed, and remaining coordinates may be locked or expanded") {
  const auto checked = [](const std::string& rest) {
    const Products products = run_pipeline(
        inputs_of(model_file("heavy_top"), "[outputs]\nbias = true\ncyclic_rates = true\n" + rest),
        {.goals = {Goal::self_check}});
    INFO(format(products.diagnostics));
    return products.self_check.has_value();
  };
  CHECK(checked("[routh]\nphi = true\n[parameters]\nfixed = { p_phi = 2 }\n"));
  CHECK(checked("[routh]\nphi = true\n[parameters]\nfixed = \"all\"\n"));
  CHECK(checked("[routh]\nphi = true\n[lock]\ntheta = { value = \"pi/3\" }\n"));
}

TEST_CASE("outputs that contain a removed coordinate are unavailable") {
  const std::string text = model_file("kepler_polar") +
                           "\n[[output]]\nname = \"place\"\nvalue = [\"x(body)\", \"r\"]\n"
                           "[[output]]\nname = \"height\"\nvalue = \"2*r\"\n";
  PipelineOptions options;
  options.goals = {Goal::check};
  const Products all =
      products_with(&Products::checked, inputs_of(text, "[routh]\nphi = true\n"), options);
  CHECK(find_request(all.checked->scene, "height") != nullptr);
  CHECK(find_request(all.checked->scene, "place") == nullptr);
  CHECK(find_request(all.checked->scene, "cyclic_rates") != nullptr);
  CHECK(find_request(all.checked->scene, "kinetic_energy") == nullptr);
  const Products refused =
      run_pipeline(inputs_of(text, "[outputs]\nplace = true\n[routh]\nphi = true\n"), options);
  REQUIRE(refused.diagnostics.size() == 1);
  CHECK(refused.diagnostics[0].code == Code::E603);
  CHECK(refused.diagnostics[0].message == "`place` contains `phi`, which `[routh]` removes");
}

}  // namespace elgen::test
