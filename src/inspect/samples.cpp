// Sampled states: fractions of a Mersenne twister, whose raw numbers the C++ standard fixes.
#include "samples.hpp"

#include <random>

namespace elgen::inspection {
namespace {

using cln::cl_R;

constexpr unsigned attempts = 8;  // a model undefined at all of them has no domain worth the name

/// low + (high - low) k/1009, k = 1 to 1008: never an end of the range, where charts like to break.
cl_R fraction_between(std::mt19937& random, const cl_R& low, const cl_R& high) {
  const cl_R share = cln::cl_RA(static_cast<int>(random() % 1008) + 1) / cln::cl_RA(1009);
  return low + (high - low) * share;
}

cl_R in_range(std::mt19937& random, const std::optional<Interval>& range, int otherwise) {
  return range ? fraction_between(random, range->low, range->high)
               : fraction_between(random, cl_R(-otherwise), cl_R(otherwise));
}

}  // namespace

State sampled_state(const Subject& subject, unsigned seed) {
  std::mt19937 random(seed);
  State state = nominal_state(subject.model, subject.scene);
  for (std::uint32_t i = 0; i < state.parameters.size(); ++i) {
    const bool fixed = subject.scene.specialisation.fixed.count(i) > 0;
    if (!fixed && cln::zerop(state.parameters[i])) {
      state.parameters[i] = fraction_between(random, 0, 1);
    }
  }
  for (std::size_t i = 0; i < state.v.size(); ++i) {
    const Velocity& velocity = subject.model.velocities[i];
    // Three velocities of a rotation go with the three components that make its quaternion.
    const std::uint32_t first = velocity.coordinate;
    const auto axis = velocity.rotation
                          ? static_cast<std::uint32_t>(
                                i + 1 - subject.model.rotations[*velocity.rotation].first_velocity)
                          : 0;
    state.q[first + axis] = in_range(random, subject.model.coordinates[first].range, 2);
    state.v[i] = in_range(random, velocity.rate_range, 1);
  }
  make_unit_quaternions(subject.model, state);
  state.t = fraction_between(random, 0, 1);
  return state;
}

OracleValues mass_matrix(const Model& model, const State& state) {
  return oracle_values(model, {.kind = OutputKind::mass_matrix}, state);
}

std::optional<MassSample> sampled_mass_matrix(const Subject& subject, unsigned seed) {
  for (unsigned attempt = 0; attempt < attempts; ++attempt) {
    State state = sampled_state(subject, seed * attempts + attempt);
    OracleValues matrix = mass_matrix(subject.model, state);
    if (matrix) return MassSample{std::move(state), std::move(*matrix)};
  }
  return std::nullopt;
}

}  // namespace elgen::inspection
