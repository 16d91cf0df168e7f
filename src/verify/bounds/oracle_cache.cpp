// Memoises the oracle's values, because `dynamics` and the outputs that it repeats need the same
// values. Decides by two constants if a value agrees with the oracle's.
#include "verify/bounds/oracle_cache.hpp"

#include "elgen/oracle.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

/// Values have 64 digits. E is a first-order bound for 53 bits: its neglected terms, and the
/// rounding errors of many operations, stay below 1e-50 E.
constexpr int digits_of_error = 50;
/// The oracle guarantees 60 digits. Eight of them allow for the rounding errors of long sums, such
/// as projections and the oracle's own derivatives.
constexpr int digits_of_scale = 52;

}  // namespace

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

const std::vector<cln::cl_R>& OracleCache::diagonal_of_mass() {
  if (diagonal_) return *diagonal_;
  diagonal_.emplace();
  for (std::size_t i = 0; i < state_.v.size(); ++i) {
    std::vector<cln::cl_R> axis(state_.v.size(), cln::cl_R(0));
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
