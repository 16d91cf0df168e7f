// Sampled states: parameters have the values of the model; coordinates, rates and inputs are
// random.
#include "inspect/samples.hpp"

#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

/// Number of states that are tried. If M has a value at none of these states, the model has
/// practically no domain.
constexpr unsigned most_attempts = 8;

/// True if an evaluation with 64 more digits gives the same matrix. With large terms, as in
/// cosh(x)^2 - sinh(x)^2 - 1, an entry that is exactly 0 may be evaluated as pure rounding error.
bool has_stable_digits(const InspectedModel& subject, const State& state,
                       const std::vector<cln::cl_R>& matrix) {
  static const cln::cl_R share = power_of_ten(-20);
  const auto again = with_digits(
      64, [&] { return oracle_values(subject.model, {.kind = OutputKind::mass_matrix}, state); });
  if (!again) return false;
  const cln::cl_R allowed = max_magnitude(matrix) * share;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    if (cln::abs((*again)[i] - matrix[i]) > allowed) return false;
  }
  return true;
}

}  // namespace

State sample_state(const InspectedModel& subject, unsigned seed) {
  Sampler draw(seed);
  State state = nominal_state(subject.model, subject.scene);
  for (std::uint32_t i = 0; i < state.parameters.size(); ++i) {
    const bool fixed = subject.scene.specialisation.fixed.count(i) > 0;
    if (!fixed && cln::zerop(state.parameters[i])) state.parameters[i] = cln::abs(draw.number());
  }
  draw_motion(subject.model, draw, seed, state);
  return state;
}

std::optional<MassSample> sample_mass_matrix(const InspectedModel& subject, unsigned seed) {
  for (unsigned attempt = 0; attempt < most_attempts; ++attempt) {
    State state = sample_state(subject, seed * most_attempts + attempt);
    OracleValues matrix = oracle_values(subject.model, {.kind = OutputKind::mass_matrix}, state);
    if (matrix && has_stable_digits(subject, state, *matrix))
      return MassSample{std::move(state), std::move(*matrix)};
  }
  return std::nullopt;
}

}  // namespace elgen
