// E613: the point a scene expands about is no equilibrium. E614: something has no expansion there.
//
// Oracle at rest at the point, at several times and parameter values: the rows of small coordinates
// of bias - B u must vanish. Coordinates that `about` leaves open are anywhere.
#include <fmt/format.h>

#include <algorithm>

#include "base/exact_number.hpp"
#include "base/random.hpp"
#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"
#include "inspect/readable.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr unsigned equilibrium_samples =
    4;  // exact and random; the first has the model's own values

/// The remainder bias - B u, row by row, and how large the terms are.
struct Residual {
  std::vector<cl_R> rest;
  std::vector<cl_R> scale;
  std::vector<cl_R> input_matrix;  ///< row-major
};

/// The first at the parameters' own values, zeros too, the others elsewhere.
State varied_state(const Inspected& subject, unsigned seed) {
  Random random(seed);
  State state = nominal_state(subject.model, subject.scene);
  if (seed > 0) {
    draw_parameters(subject.model, subject.scene.specialisation.fixed, random, seed, state);
  }
  draw_motion(subject.model, random, seed, state);
  return state;
}

/// The state at rest at the point; nothing where a value of `about` does not exist.
std::optional<State> at_point(const Model& model, State state) {
  const Approximation& approximation = *model.approximation;
  const State given = state;
  const auto place = [&](const std::vector<std::optional<ExpressionId>>& values,
                         std::vector<cl_R>& entries) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i]) continue;
      const std::optional<cl_R> value = oracle_expression(model, *values[i], given);
      if (!value) return false;
      entries[i] = *value;
    }
    return true;
  };
  state.v.assign(state.v.size(), cl_R(0));
  state.a = state.v;
  state.u.assign(state.u.size(), cl_R(0));
  const bool exists =
      place(approximation.coordinates, state.q) && place(approximation.inputs, state.u);
  return exists ? std::optional(std::move(state)) : std::nullopt;
}

std::optional<Residual> balance_at(const Model& exact, const State& point, const State& elsewhere) {
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
      balance.rest[i] = balance.rest[i] - force;
      scale = scale + cln::abs(force);
    }
    balance.scale.push_back(scale);
  }
  return balance;
}

/// Whether `about` gives every coordinate, so that there is one point.
bool is_complete(const Approximation& approximation) {
  const auto& values = approximation.coordinates;
  return std::find(values.begin(), values.end(), std::nullopt) == values.end();
}

/// A number holds at one value of the parameters only.
const std::string for_all_values =
    "write values by parameters, like `m*g`, or make these numbers: `[parameters] fixed = \"all\"`";

/// "`u = 4.905` balances it" where one input acts on this row, and on no other.
std::string suggestion(const Model& model, const Residual& balance, std::size_t row,
                       const State& point, bool all_fixed) {
  if (!is_complete(*model.approximation)) return {};
  const std::size_t columns = point.u.size();
  std::optional<std::size_t> acting;
  for (std::size_t k = 0; k < columns; ++k) {
    if (cln::zerop(balance.input_matrix[row * columns + k])) continue;
    if (acting) return {};
    acting = k;
  }
  if (!acting) return {};
  for (std::size_t i = 0; i < balance.rest.size(); ++i) {
    if (i != row && !cln::zerop(balance.input_matrix[i * columns + *acting])) return {};
  }
  const cl_R value =
      point.u[*acting] + balance.rest[row] / balance.input_matrix[row * columns + *acting];
  const std::string balanced =
      fmt::format("`{} = {}` balances it", model.inputs[*acting].name, readable(value));
  return all_fixed ? balanced : balanced + " at the parameters' values; " + for_all_values;
}

/// `own_values`: whether the parameters have theirs, so that the figures mean something.
Diagnostics unbalanced(const Inspected& subject, const Residual& balance, const State& point,
                       bool own_values) {
  const Model& model = subject.model;
  const bool all_fixed = subject.scene.specialisation.fixed.size() == model.parameters.size();
  // The oracle's 64 digits less 24 for what cancels, as in verify.
  static const cl_R tolerance = power_of_ten(-40);
  Diagnostics found;
  for (std::size_t q = 0; q < model.coordinates.size(); ++q) {
    if (!model.approximation->small[q]) continue;
    const std::size_t row = model.coordinates[q].velocity;
    if (cln::abs(balance.rest[row]) <= balance.scale[row] * tolerance) continue;
    const std::string figure =
        own_values ? readable(balance.rest[row]) : "not 0 at other values of the parameters";
    found.push_back(
        {Code::E613, model.approximation->span,
         fmt::format("`{}` does not stay at rest there: bias - B u is {}",
                     model.coordinates[q].name, figure),
         own_values ? suggestion(model, balance, row, point, all_fixed) : for_all_values});
  }
  return found;
}

bool has_expansion(const Model& model, const State& state) {
  return oracle_values(model, {.kind = OutputKind::inverse_dynamics}, state).has_value();
}

Diagnostic no_expansion(const Model& model) {
  return {Code::E614, model.approximation->span,
          fmt::format("energies and forces have no derivatives of order {} there",
                      model.approximation->order + 1)};
}

}  // namespace

Diagnostics inspect_equilibrium(const Inspected& subject) {
  const Model& model = subject.model;
  if (!model.approximation) return {};
  Model exact = model;
  exact.approximation.reset();
  bool was_seen = false;
  for (unsigned seed = 0; seed < equilibrium_samples; ++seed) {
    const State elsewhere = varied_state(subject, seed);
    const std::optional<State> point = at_point(model, elsewhere);
    const auto balance = point ? balance_at(exact, *point, elsewhere) : std::nullopt;
    if (!balance) continue;
    Diagnostics found = unbalanced(subject, *balance, *point, seed == 0);
    if (!found.empty()) return found;
    if (!has_expansion(model, elsewhere)) return {no_expansion(model)};
    was_seen = true;
  }
  return was_seen ? Diagnostics() : Diagnostics{no_expansion(model)};
}

}  // namespace elgen
