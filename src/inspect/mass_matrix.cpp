// E524 where M is regular, but not positive definite. E501: a direction x with M x = 0 at every
// sampled state is a motion without kinetic energy.
//
// One non-singular sample acquits, but for outputs that solve a diagonal entry that is zero at
// every sample is an error, too. Otherwise the null space is named: by its vectors where they are
// the same at every sample, by its dimension where they turn with the configuration.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elgen/outputs.hpp"
#include "inspect/checks.hpp"
#include "inspect/null_space.hpp"
#include "inspect/readable.hpp"
#include "inspect/samples.hpp"
#include "inspect/singular_mass.hpp"

namespace elgen {
namespace {

using Basis = std::vector<Vector>;

/// Entry by entry, as they are read.
bool agree(const Basis& x, const Basis& y) {
  return std::ranges::equal(x, y, [](const Vector& a, const Vector& b) {
    return std::ranges::equal(a, b, {}, readable, readable);
  });
}

std::vector<std::size_t> moving(const Vector& x) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (readable(x[i]) != "0") indices.push_back(i);
  }
  return indices;
}

/// "x1 : x2 = 1 : -1"
std::string proportion(const Model& model, const Vector& x, const std::vector<std::size_t>& part) {
  std::string names;
  std::string shares;
  for (const std::size_t i : part) {
    const char* separator = names.empty() ? "" : " : ";
    names += separator + model.velocities[i].name;
    shares += separator + readable(x[i] / x[part.front()]);
  }
  return names + " = " + shares;
}

Diagnostic motion_without_energy(const Model& model, const Vector& x) {
  const std::vector<std::size_t> part = moving(x);
  const Velocity& first = model.velocities[part.front()];
  if (part.size() == 1) {
    return {Code::E501, first.span,
            fmt::format("the rate of `{}` has no kinetic energy", first.name),
            "give it a mass, or remove the coordinate"};
  }
  return {Code::E501, first.span,
          fmt::format("the motion `{}` has no kinetic energy", proportion(model, x, part)),
          "too many coordinates, or a mass is missing"};
}

/// The dimension, and one direction at one configuration.
Diagnostic rank_deficit(const Model& model, const Basis& basis, const State& state) {
  const std::size_t n = model.velocities.size();
  std::string at;
  for (const cln::cl_R& q : state.q) at += (at.empty() ? "" : ", ") + readable(q);
  return {
      Code::E501, model.velocities.front().span,
      fmt::format("rank {} of {} at every sampled configuration: the motion `{}` has no kinetic "
                  "energy at q = ({})",
                  n - basis.size(), n, proportion(model, basis[0], moving(basis[0])), at),
      "too many coordinates, or a mass is missing"};
}

/// The `candidates` whose diagonal entry is rounding beside its row: M is not positive definite,
/// and its elimination fails.
std::vector<std::size_t> without_energy(const MassSample& sample,
                                        const std::vector<std::size_t>& candidates) {
  const std::size_t n = sample.state.v.size();
  const Vector scales = row_scales(sample.matrix, n);
  std::vector<std::size_t> result;
  for (const std::size_t i : candidates) {
    if (cln::abs(sample.matrix[i * n + i]) <= rounding_share() * scales[i]) result.push_back(i);
  }
  return result;
}

/// Only outputs that divide by M need a positive definite M. Where nothing
/// asks for an output by name, the mistake is in the model: in T, where it is written.
Diagnostics not_definite(const Inspected& subject, const std::vector<std::size_t>& rates) {
  const Model& model = subject.model;
  for (const OutputRequest& output : subject.scene.outputs) {
    if (!divides_by_mass(output_row(output.kind)) || rates.empty()) continue;
    const Velocity& velocity = model.velocities[rates.front()];
    Diagnostic error = no_kinetic_energy(output, velocity.name);
    if (error.span.source == nullptr) {
      const auto& written = model.energies.L ? model.energies.L : model.energies.T;
      error.span = written ? model.expressions[*written].span : velocity.span;
      error.hint = fmt::format(
          "no term has the square of `dot({})`, as 1/2*m*v^2 of a mass would; else do not ask for "
          "this output",
          velocity.name);
    }
    return {error};
  }
  return {};
}

Diagnostics without_rank(const Model& model, const std::vector<Basis>& found, const State& last) {
  for (const Basis& basis : found) {
    if (!agree(basis, found.front())) return {rank_deficit(model, found.back(), last)};
  }
  Diagnostics diagnostics;
  for (const Vector& x : found.front()) diagnostics.push_back(motion_without_energy(model, x));
  return diagnostics;
}

}  // namespace

Diagnostics inspect_mass_matrix(const Inspected& subject) {
  const std::size_t n = subject.model.velocities.size();
  if (n > most_coordinates_sampled) return {};
  std::vector<Basis> found;
  std::vector<std::size_t> rates(n);
  std::iota(rates.begin(), rates.end(), std::size_t{0});
  bool is_regular = false;
  State last;
  for (unsigned seed = 0; seed < zero_samples; ++seed) {
    const auto sample = sampled_mass_matrix(subject, seed);
    if (!sample) return {};
    found.push_back(null_space(sample->matrix, row_scales(sample->matrix, n)));
    rates = without_energy(*sample, rates);
    is_regular = is_regular || found.back().empty();
    if (is_regular && rates.empty()) return negative_kinetic_energy(subject, *sample);
    last = sample->state;
  }
  return is_regular ? not_definite(subject, rates) : without_rank(subject.model, found, last);
}

}  // namespace elgen
