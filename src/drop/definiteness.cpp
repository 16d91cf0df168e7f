// S = D^-1/2 M D^-1/2 has a diagonal of 1, D that of M; what was dropped changes it by at most
// E_ij/sqrt(d_i d_j), d the least diagonal entries sampled. By Gershgorin no eigenvalue moves by
// more than the largest row sum r of that. S - 2 r I must be positive definite at every state
// sampled: half of the smallest eigenvalue is left for states between them.
#include "drop/definiteness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluate/states.hpp"

namespace elgen {
namespace {

constexpr std::size_t sampled_states = 200;  // with 99 % one in any 2.3 % of the ranges

struct DefiniteMass {
  State state;
  std::vector<cln::cl_R> matrix;
};

std::vector<DefiniteMass> mass_samples(const Subject& subject) {
  std::vector<DefiniteMass> samples;
  const OutputRequest request{.kind = OutputKind::mass_matrix};
  for (const auto& sample : sample_states<double>(subject, {sampled_states, 1, false})) {
    State state = exact_state(subject, sample.values);
    OracleValues matrix = oracle_values(subject.model, request, state);
    if (matrix) samples.push_back({std::move(state), std::move(*matrix)});
  }
  return samples;
}

/// The largest row sum of E_ij/sqrt(d_i d_j); infinite where a d_i is not positive.
double largest_change(const ReducedOutput& dropped, const std::vector<DefiniteMass>& samples,
                      std::size_t n) {
  std::vector<double> least(n, std::numeric_limits<double>::infinity());
  for (const DefiniteMass& sample : samples) {
    for (std::size_t i = 0; i < n; ++i) {
      const double own = ScalarTraits<double>::from_real(sample.matrix[i * n + i]);
      least[i] = std::min(least[i], own);
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double error = ScalarTraits<double>::from_real(dropped.errors[i * n + j].constant);
      if (error > 0)
        sum += least[i] > 0 && least[j] > 0 ? error / std::sqrt(least[i] * least[j])
                                            : std::numeric_limits<double>::infinity();
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Whether S - 2 r I is positive definite.
bool stays_definite(std::vector<cln::cl_R> m, std::size_t n, double change) {
  // In terms of M: M - 2 r D, which has the same signs of pivots.
  if (!(change < 0.5)) return false;
  const cln::cl_R factor = exact_value(1 - 2 * change);
  for (std::size_t i = 0; i < n; ++i) m[i * n + i] = m[i * n + i] * factor;
  const OracleValues pivots = oracle_relative_pivots(std::move(m), n);
  return pivots && std::all_of(pivots->begin(), pivots->end(),
                               [](const cln::cl_R& pivot) { return cln::plusp(pivot); });
}

}  // namespace

Diagnostics check_definiteness(const Model& model, const Scene& scene, const Reduction& reduction) {
  const ReducedOutput* dropped = find_reduced(reduction, OutputKind::mass_matrix);
  if (dropped == nullptr) return {};
  const Program none;
  const Subject subject{model, scene, none};
  const std::size_t n = model.velocities.size();
  const std::vector<DefiniteMass> samples = mass_samples(subject);
  const double change = largest_change(*dropped, samples, n);
  for (const DefiniteMass& sample : samples) {
    if (stays_definite(sample.matrix, n, change)) continue;
    return {{Code::E618, scene.dropping->span,
             fmt::format("what is dropped from `mass_matrix` may be {:.2g} of it, too near to its "
                         "smallest eigenvalue at {}",
                         change, describe(subject, sample.state)),
             "a smaller `drop_below` drops less"}};
  }
  return {};
}

}  // namespace elgen
