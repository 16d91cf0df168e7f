// E613: an [[equilibrium]], or the point about which a scene expands, is no equilibrium. E614:
// energies or forces have no expansion at this point.
//
// The oracle evaluates the model at rest at the point, at several times and parameter values that
// meet the condition of the point. The residual bias - B u must be 0: in all rows for an
// [[equilibrium]], in the rows of small coordinates for a scene. Coordinates for which the point
// states no value have random values.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/reason.hpp"
#include "elgen/inspect.hpp"
#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"
#include "inspect/readable.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Largest number of exact random samples; the sample with seed 0 has the model's parameter values.
constexpr unsigned equilibrium_samples = 4;

/// Largest number of parameter draws to find samples that meet a condition.
constexpr unsigned condition_draws = 64;

/// A point that is claimed to be an equilibrium.
struct ClaimedEquilibrium {
  const OperatingPoint& point;
  std::vector<std::uint32_t> rows = {};  ///< velocities whose equations must balance
  Span span = {};
  std::string_view remedy = {};  ///< hint if forces balance only at some parameter values
};

/// The residual bias - B u, row by row, and the magnitude of its terms.
struct Residual {
  std::vector<cl_R> values;
  std::vector<cl_R> magnitudes;
  std::vector<cl_R> input_matrix;  ///< row-major
};

/// A sampled state. With seed 0, parameters have their values, including zeros; with other seeds,
/// random values.
State random_parameter_state(const InspectedModel& subject, unsigned seed) {
  Sampler draw(seed);
  return draw_state(subject.model, subject.scene, draw, seed);
}

/// The first seeds (at most equilibrium_samples) whose parameters meet the condition of the point.
std::vector<unsigned> sample_seeds(const InspectedModel& subject, const OperatingPoint& point) {
  std::vector<unsigned> seeds;
  for (unsigned seed = 0; seed < condition_draws && seeds.size() < equilibrium_samples; ++seed) {
    const bool fits = !point.condition || oracle_satisfies(subject.model, *point.condition,
                                                           random_parameter_state(subject, seed));
    if (fits) seeds.push_back(seed);
  }
  return seeds;
}

std::optional<Residual> residual_at(const Model& exact, const State& point,
                                    const State& elsewhere) {
  const OracleValues bias = oracle_values(exact, {.kind = OutputKind::bias}, point);
  const OracleValues typical = oracle_values(exact, {.kind = OutputKind::bias}, elsewhere);
  const OracleValues inputs = oracle_values(exact, {.kind = OutputKind::input_matrix}, point);
  if (!bias || !typical || !inputs) return std::nullopt;
  Residual balance{*bias, {}, *inputs};
  const std::size_t columns = point.u.size();
  for (std::size_t i = 0; i < bias->size(); ++i) {
    cl_R scale = cln::abs((*typical)[i]);
    for (std::size_t k = 0; k < columns; ++k) {
      const cl_R force = (*inputs)[i * columns + k] * point.u[k];
      balance.values[i] = balance.values[i] - force;
      scale = scale + cln::abs(force);
    }
    balance.magnitudes.push_back(scale);
  }
  return balance;
}

/// True if the point states a value for every coordinate.
bool is_complete(const OperatingPoint& point) {
  const auto& values = point.coordinates;
  return std::find(values.begin(), values.end(), std::nullopt) == values.end();
}

// Hints for a numeric input, which balances the forces only at the parameter values of the file.
constexpr std::string_view remedy_of_scene =
    "write values with parameters, such as `m*g`, or fix all parameters: `[parameters] fixed = "
    "\"all\"`";
constexpr std::string_view remedy_of_entry =
    "write values with parameters, such as `m*g`; `when` limits the parameters";

/// The hint "`u = 4.905` balances it" for equation `row`, if the point states all coordinates,
/// exactly one input acts on `row`, and this input acts on no other row. Otherwise "".
std::string input_hint(const InspectedModel& subject, const ClaimedEquilibrium& claim,
                       const Residual& balance, std::size_t row, const State& point) {
  if (!is_complete(claim.point)) return {};
  const std::size_t columns = point.u.size();
  std::optional<std::size_t> acting;
  for (std::size_t k = 0; k < columns; ++k) {
    if (cln::zerop(balance.input_matrix[row * columns + k])) continue;
    if (acting) return {};
    acting = k;
  }
  if (!acting) return {};
  for (std::size_t i = 0; i < balance.values.size(); ++i) {
    if (i != row && !cln::zerop(balance.input_matrix[i * columns + *acting])) return {};
  }
  const cl_R value =
      point.u[*acting] + balance.values[row] / balance.input_matrix[row * columns + *acting];
  const Model& model = subject.model;
  const std::string balanced =
      fmt::format("`{} = {}` balances it", model.inputs[*acting].name, readable_number(value));
  const bool all_fixed = subject.scene.specialisation.fixed.size() == model.parameters.size();
  return all_fixed ? balanced
                   : fmt::format("{} at the values of the parameters; {}", balanced, claim.remedy);
}

/// Errors for the rows of the claim that are not balanced. `has_model_values`: the parameters have
/// the values of the model, so the messages contain the residuals.
Diagnostics balance_errors(const InspectedModel& subject, const ClaimedEquilibrium& claim,
                           const Residual& balance, const State& point, bool has_model_values) {
  // The oracle has 60 digits; 20 may be lost to cancellation.
  static const cl_R tolerance = power_of_ten(-40);
  Diagnostics found;
  for (const std::uint32_t row : claim.rows) {
    if (cln::abs(balance.values[row]) <= balance.magnitudes[row] * tolerance) continue;
    const std::string figure = has_model_values ? readable_number(balance.values[row])
                                                : "not 0 at other values of the parameters";
    found.push_back({Code::E613, claim.span,
                     fmt::format("`{}` does not stay at rest there: bias - B u is {}",
                                 subject.model.velocities[row].name, figure),
                     has_model_values ? input_hint(subject, claim, balance, row, point)
                                      : std::string(claim.remedy)});
  }
  return found;
}

Diagnostic no_expansion_error(const Model& model) {
  return {Reason::no_derivatives, model.approximation->span,
          fmt::format("energies and forces have no derivatives of order {} there",
                      model.approximation->order + 1)};
}

ClaimedEquilibrium make_claim(const Model& model, const Approximation& approximation) {
  ClaimedEquilibrium claim{approximation, {}, approximation.span, remedy_of_scene};
  for (std::size_t q = 0; q < model.coordinates.size(); ++q) {
    if (approximation.small[q]) claim.rows.push_back(model.coordinates[q].velocity);
  }
  return claim;
}

ClaimedEquilibrium make_claim(const Model& model, const Equilibrium& equilibrium) {
  ClaimedEquilibrium claim{equilibrium, {}, equilibrium.span, remedy_of_entry};
  claim.rows.resize(model.velocities.size());
  std::iota(claim.rows.begin(), claim.rows.end(), 0);
  return claim;
}

/// The errors of the first sample that does not balance; none if all samples balance or no drawn
/// parameters meet the condition.
Diagnostics inspect_stated_equilibrium(const InspectedModel& subject,
                                       const Equilibrium& equilibrium) {
  const ClaimedEquilibrium claim = make_claim(subject.model, equilibrium);
  for (const unsigned seed : sample_seeds(subject, equilibrium)) {
    const State elsewhere = random_parameter_state(subject, seed);
    const std::optional<State> point = oracle_rest_state(subject.model, equilibrium, elsewhere);
    if (!point) {
      return {{Code::E613, claim.span,
               fmt::format("a value of `{}` does not exist for some values of the parameters",
                           equilibrium.name),
               "`when` limits the parameters"}};
    }
    const auto balance = residual_at(subject.model, *point, elsewhere);
    if (!balance) continue;
    Diagnostics found = balance_errors(subject, claim, *balance, *point, seed == 0);
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

std::vector<State> sample_equilibrium(const CheckedModel& checked, const Equilibrium& equilibrium) {
  const InspectedModel subject{checked.model, checked.scene};
  std::vector<State> points;
  for (const unsigned seed : sample_seeds(subject, equilibrium)) {
    const State elsewhere = random_parameter_state(subject, seed);
    std::optional<State> point = oracle_rest_state(subject.model, equilibrium, elsewhere);
    if (point && residual_at(subject.model, *point, elsewhere)) points.push_back(std::move(*point));
  }
  return points;
}

Diagnostics inspect_equilibria(const InspectedModel& subject) {
  Diagnostics all;
  for (const Equilibrium& equilibrium : subject.model.equilibria) {
    const Diagnostics found = inspect_stated_equilibrium(subject, equilibrium);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

Diagnostics inspect_expansion_point(const InspectedModel& subject) {
  const Model& model = subject.model;
  if (!model.approximation) return {};
  const ClaimedEquilibrium claim = make_claim(model, *model.approximation);
  const std::vector<unsigned> seeds = sample_seeds(subject, claim.point);
  if (seeds.empty()) {
    return {{Code::E613, claim.span,
             fmt::format("it is no equilibrium: `{}` does not hold", claim.point.condition->text)}};
  }
  Model exact = model;
  exact.approximation.reset();
  bool was_seen = false;
  for (const unsigned seed : seeds) {
    const State elsewhere = random_parameter_state(subject, seed);
    const std::optional<State> point = oracle_rest_state(model, claim.point, elsewhere);
    const auto balance = point ? residual_at(exact, *point, elsewhere) : std::nullopt;
    if (!balance) continue;
    Diagnostics found = balance_errors(subject, claim, *balance, *point, seed == 0);
    if (!found.empty()) return found;
    if (!oracle_values(model, {.kind = OutputKind::inverse_dynamics}, elsewhere)) {
      return {no_expansion_error(model)};
    }
    was_seen = true;
  }
  return was_seen ? Diagnostics() : Diagnostics{no_expansion_error(model)};
}

}  // namespace elgen
