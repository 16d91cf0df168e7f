// Memoises the oracle's values, because `dynamics` and the outputs that it repeats need the same
// values. Decides by two constants if a value agrees with the oracle's.
#include "verify/bounds/oracle_cache.hpp"

#include <cmath>
#include <limits>

#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "elgen/outputs.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

/// Values have 64 digits. E is a first-order bound for 53 bits: its neglected terms, and the
/// rounding errors of many operations, stay below 1e-50 E.
constexpr int digits_of_error = 50;
/// The oracle guarantees 60 digits. Eight of them allow for the rounding errors of long sums, such
/// as projections and the oracle's own derivatives.
constexpr int digits_of_scale = 52;

/// A function of the program, or an unrequested function, that gives M.
struct MassSource {
  const Program& program;
  const Function& function;
};

/// Prefers the mass matrix to inverse dynamics. None if the oracle solves the equations itself.
std::optional<MassSource> find_mass_source(const SystemUnderTest& subject) {
  if (is_solved_by_oracle(subject.model)) return std::nullopt;
  for (const OutputKind kind : {OutputKind::mass_matrix, OutputKind::inverse_dynamics}) {
    for (const Program* const program : {&subject.program, subject.unrequested}) {
      const Function* const found = program == nullptr ? nullptr : find_function(*program, kind);
      if (found != nullptr) return MassSource{*program, *found};
    }
  }
  return std::nullopt;
}

/// M, n x n row-major. From inverse dynamics tau as a function of a: M e_j = tau(e_j) - tau(0).
template <class Number>
std::vector<Number> evaluate_mass(const MassSource& source, const Model& model,
                                  const State& state) {
  const std::size_t n = state.v.size();
  Arguments<Number> at = arguments_at<Number>(state);
  if (!output_row(source.function.kind).argument_kinds.has_any(Opcode::acceleration))
    return evaluate(source.program, source.function, at);
  at.a.assign(n, Number());
  if (model.is_quadratic) at.v = at.a;  // fewer digits cancel
  const std::vector<Number> rest = evaluate(source.program, source.function, at);
  std::vector<Number> mass(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    at.a[j] = Number(1);
    const std::vector<Number> forces = evaluate(source.program, source.function, at);
    for (std::size_t i = 0; i < n; ++i) mass[i * n + j] = forces[i] - rest[i];
    at.a[j] = Number();
  }
  return mass;
}

}  // namespace

bool is_solved_by_oracle(const Model& model) {
  // M of four velocities takes three expansions of the energies.
  constexpr std::size_t most_velocities = 4;
  return !model.constraints.empty() || model.velocities.size() <= most_velocities;
}

RunningValue<Real> contract(std::span<const RunningValue<Real>> entries, const Contraction& by) {
  RunningValue<Real> sum;
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  for (std::size_t i = 0; i < by.w.size() * columns; ++i) {
    const cln::cl_R factor = by.y.empty() ? by.w[i] : by.w[i / columns] * by.y[i % columns];
    sum.value = sum.value + entries[i].value * Real(factor);
    sum.error = sum.error + entries[i].error * Real(cln::abs(factor));
  }
  return sum;
}

const OracleValues& OracleCache::values(const OutputRequest& request) {
  const auto key = std::make_pair(request.kind, request.user);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_[key] = oracle_values(subject_.model, request, state_);
}

std::optional<cln::cl_R> OracleCache::contraction(const OutputRequest& request,
                                                  const Contraction& by) {
  if (!oracle_needs_entries(request))
    return oracle_contraction(subject_.model, request, state_, by);
  const OracleValues& entries = values(request);
  if (!entries) return std::nullopt;
  return contract_entries(subject_.model, request, *entries, by);
}

const OracleValues& OracleCache::mass_of_program() {
  if (mass_of_program_) return *mass_of_program_;
  OracleValues& values = mass_of_program_.emplace();
  const std::optional<MassSource> source = find_mass_source(subject_);
  if (!source) return values;
  const std::vector<Real> mass = evaluate_mass<Real>(*source, subject_.model, state_);
  const std::size_t n = state_.v.size();
  Sampler draw(1);
  const Contraction by{draw.vector(n), draw.vector(n)};
  std::vector<RunningValue<Real>> entries;
  for (const Real& x : mass) entries.push_back({x, abs(x)});
  const auto truth = contraction({.kind = OutputKind::mass_matrix}, by);
  if (truth && agrees_with_oracle(contract(entries, by), *truth, *this))
    values = to_oracle_values(mass);
  return values;
}

const std::vector<cln::cl_R>& OracleCache::diagonal_of_mass() {
  if (diagonal_) return *diagonal_;
  diagonal_.emplace();
  const std::size_t n = state_.v.size();
  std::vector<double> mass(n * n, std::numeric_limits<double>::quiet_NaN());
  if (const auto source = find_mass_source(subject_))
    mass = evaluate_mass<double>(*source, subject_.model, state_);
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(mass[i * n + i]) && mass[i * n + i] > 0) {
      diagonal_->push_back(exact_value(mass[i * n + i]));
      continue;
    }
    std::vector<cln::cl_R> axis(n, cln::cl_R(0));
    axis[i] = 1;
    const auto entry = contraction({.kind = OutputKind::mass_matrix}, {axis, axis});
    diagonal_->push_back(entry.value_or(0));
  }
  return *diagonal_;
}

const cln::cl_R& OracleCache::energy_magnitude() {
  if (!energy_) energy_ = oracle_energy_magnitude(subject_.model, state_).value_or(0);
  return *energy_;
}

const cln::cl_R& OracleCache::rounding_scale() {
  if (!rounding_scale_) {
    rounding_scale_ = energy_magnitude() + largest_force() + largest_inertial_force() +
                      cln::square(max_magnitude(state_.v)) + max_magnitude(state_.a);
  }
  return *rounding_scale_;
}

cln::cl_R OracleCache::used_scale() const {
  return rounding_scale_ ? *rounding_scale_ : energy_.value_or(cln::cl_R(0));
}

cln::cl_R OracleCache::largest_force() {
  cln::cl_R largest = 0;
  for (const OutputKind kind :
       {OutputKind::velocity_force, OutputKind::gravity, OutputKind::bias}) {
    // The oracle has each output of the model, even if the scene does not request the output.
    const OutputRequest request = make_request(subject_.model, kind, 0);
    if (!is_available(subject_.model, request)) continue;
    const OracleValues& entries = values(request);
    if (entries) largest = cln::max(largest, max_magnitude(*entries));
  }
  return largest;
}

cln::cl_R OracleCache::largest_inertial_force() {
  const OracleValues& mass = values({.kind = OutputKind::mass_matrix});
  if (!mass) return 0;
  return max_magnitude(*mass) * (max_magnitude(state_.v) + max_magnitude(state_.a));
}

bool agrees(const RunningValue<Real>& number, const Real& truth, const Real& scale) {
  static const Real of_error(power_of_ten(-digits_of_error));
  static const Real scale_tolerance(power_of_ten(-digits_of_scale));
  const Real error = number.error.is_defined() ? number.error : Real();
  const Real allowed = (error + abs(truth)) * of_error + scale * scale_tolerance;
  return abs(number.value - truth) <= allowed;
}

bool agrees_with_oracle(const RunningValue<Real>& number, const cln::cl_R& truth,
                        OracleCache& oracle) {
  return agrees(number, Real(truth), Real()) ||
         agrees(number, Real(truth), Real(oracle.energy_magnitude())) ||
         agrees(number, Real(truth), Real(oracle.rounding_scale()));
}

bool is_stable_mismatch(const Mismatch& before, const Mismatch& now) {
  static const Real share(power_of_ten(-digits_of_error));
  const auto size = [](const Real& x) { return x.is_defined() ? abs(x) : Real(); };
  const Real allowed = share * (size(now.value) + size(now.truth));
  const auto stays = [&allowed](const Real& x, const Real& y) {
    if (!x.is_defined() || !y.is_defined()) return x.is_defined() == y.is_defined();
    return abs(x - y).value() <= allowed.value();
  };
  return stays(before.value, now.value) && stays(before.truth, now.truth);
}

std::string short_text(const Real& value) {
  return value.is_defined() ? short_number_text(value.value()) : "undefined";
}

}  // namespace elgen
