// Values of the oracle, kept per output: `dynamics` and the functions it repeats ask for the same
// ones.
#include "oracle_cache.hpp"

#include "check/requests.hpp"

namespace elgen {

const OracleValues& OracleCache::values(const OutputRequest& request) {
  const auto key = std::make_pair(request.kind, request.user);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  return known_[key] = oracle_values(subject_.model, request, state_);
}

const cln::cl_R& OracleCache::energy() {
  if (!energy_) {
    const OracleValues& e = values(standard_request(OutputKind::energy_function));
    energy_ = e ? cln::abs(e->front()) : cln::cl_R(0);
  }
  return *energy_;
}

cln::cl_R OracleCache::force() {
  cln::cl_R largest = 0;
  for (const OutputKind kind :
       {OutputKind::velocity_force, OutputKind::gravity, OutputKind::bias}) {
    // Whatever the scene asks for and calls it: the model decides what there is.
    const OutputRequest request = checking::request_of(subject_.model, kind, 0);
    if (!checking::is_available(subject_.model, request)) continue;
    const OracleValues& entries = values(request);
    if (!entries) continue;
    for (const cln::cl_R& entry : *entries) largest = cln::max(largest, cln::abs(entry));
  }
  return largest;
}

}  // namespace elgen
