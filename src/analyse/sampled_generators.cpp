// Scales rows and columns before elimination. Scaled entries below 1e-100 count as 0.
#include "analyse/sampled_generators.hpp"

#include <cln/float.h>

#include <algorithm>
#include <array>
#include <utility>

#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr std::uint64_t seed = 1;
/// The limit of draws per state: states outside the domain of a function have no value.
constexpr std::size_t draws_per_state = 20;

/// Elimination scales rows and columns to largest entries of 1; numbers below this count as 0.
const cl_R& noise_threshold() {
  static const cl_R value = power_of_ten(-100);
  return value;
}

/// In a row with largest entry 1, entries below this are rounding errors of the samples.
const cl_R& rounding_threshold() {
  static const cl_R value = power_of_ten(-125);
  return value;
}

/// R = M a + bias - dD/dv + Q; bias contains dD/dv and -Q, so dD/dv and Q cancel.
constexpr std::array<std::pair<OutputKind, int>, 3> residual_outputs{
    {{OutputKind::inverse_dynamics, 1},
     {OutputKind::dissipation, -1},
     {OutputKind::applied_force, 1}}};

/// The signed sum of part(kind) over the outputs of `residual_outputs` that the program has; one
/// entry per velocity.
template <class Part>
std::vector<Real> sum_residual_terms(const Program& program, std::size_t n, const Part& part) {
  std::vector<Real> sum(n);
  for (const auto& [kind, sign] : residual_outputs) {
    if (find_function(program, kind) == nullptr) continue;
    const std::vector<Real> terms = part(kind);
    for (std::size_t i = 0; i < n; ++i) sum[i] = sum[i] + Real(sign) * terms[i];
  }
  return sum;
}

ResidualSlopes<Real> residual_slopes(const ExactValues& values) {
  const std::size_t n = values.size();
  const Program& program = values.subject().program;
  const auto along = [&](const Arguments<Real>& direction, std::vector<Real>& slopes,
                         std::size_t column, std::size_t columns) {
    slopes.resize(n * columns);
    const std::vector<Real> sum = sum_residual_terms(program, n, [&](OutputKind kind) {
      return values.directional_derivatives(kind, direction);
    });
    for (std::size_t i = 0; i < n; ++i) slopes[i * columns + column] = sum[i];
  };
  ResidualSlopes<Real> slopes;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Real> unit(n);
    unit[k] = Real(1);
    Arguments<Real> by_position = values.zero_direction();
    Arguments<Real> by_velocity = by_position;
    Arguments<Real> by_acceleration = by_position;
    by_position.q = values.coordinate_rates(unit);
    by_velocity.v = unit;
    by_acceleration.a = unit;
    along(by_position, slopes.by_position, k, n);
    along(by_velocity, slopes.by_velocity, k, n);
    along(by_acceleration, slopes.by_acceleration, k, n);
  }
  Arguments<Real> by_time = values.zero_direction();
  by_time.t = Real(1);
  along(by_time, slopes.by_time, 0, 1);
  return slopes;
}

/// A row in floats of 160 digits with largest entry 1; exact numbers would grow in elimination.
/// None if an entry is undefined.
std::optional<std::vector<cl_R>> scaled_row(const std::vector<Real>& row) {
  static const cln::float_format_t digits = cln::float_format(64 + sampling_digits);
  std::vector<cl_R> numbers;
  for (const Real& entry : row) {
    if (!entry.is_defined()) return std::nullopt;
    numbers.push_back(cln::cl_float(entry.value(), digits));
  }
  const cl_R scale = max_magnitude(numbers);
  if (cln::zerop(scale)) return numbers;
  for (cl_R& entry : numbers) entry = entry / scale;
  return numbers;
}

/// The largest magnitude in each column; 1 if this magnitude is a rounding error.
std::vector<cl_R> column_scales(const std::vector<std::vector<cl_R>>& rows, std::size_t unknowns) {
  std::vector<cl_R> scales(unknowns, cl_R(0));
  for (const std::vector<cl_R>& row : rows) {
    for (std::size_t u = 0; u < unknowns; ++u) scales[u] = cln::max(scales[u], cln::abs(row[u]));
  }
  for (cl_R& scale : scales) {
    if (scale < rounding_threshold()) scale = 1;
  }
  return scales;
}

/// A basis of the null space of the rows. The last non-zero entry of each vector is 1. Columns are
/// scaled, so that the test for 0 does not depend on units.
std::vector<std::vector<cl_R>> null_vectors(const std::vector<std::vector<cl_R>>& rows,
                                            std::size_t unknowns) {
  const std::vector<cl_R> scales = column_scales(rows, unknowns);
  std::vector<cl_R> matrix;
  for (const std::vector<cl_R>& row : rows) {
    for (std::size_t u = 0; u < unknowns; ++u) matrix.push_back(row[u] / scales[u]);
  }
  using Sampled = LargestPivot<cl_R, EchelonForm::reduced>;
  Sampled field(noise_threshold(), noise_threshold());
  std::vector<std::vector<cl_R>> basis =
      Echelon<Sampled>(field, matrix, unknowns, unknowns).kernel();
  for (std::vector<cl_R>& x : basis) {
    std::size_t last = 0;
    for (std::size_t u = 0; u < unknowns; ++u) {
      if (!cln::zerop(x[u])) last = u;
    }
    for (std::size_t u = 0; u < last; ++u) x[u] = x[u] * scales[last] / scales[u];
  }
  return basis;
}

/// The scaled conditions at a state, without undefined conditions.
std::vector<std::vector<cl_R>> sample_conditions(const CheckedModel& checked, const Program& moving,
                                                 const GeneratorLayout& all, const State& state) {
  ExactValues values({checked.model, checked.scene, moving}, state);
  RealField field;
  std::vector<std::vector<cl_R>> rows;
  for (const auto& row :
       symmetry_conditions(field, all, motion_point_at(values), residual_slopes(values))) {
    if (auto numbers = scaled_row(row)) rows.push_back(std::move(*numbers));
  }
  return rows;
}

std::optional<SampledGenerators> null_space_generators(const CheckedModel& checked,
                                                       const Program& moving,
                                                       const State& resting) {
  const GeneratorLayout all(checked.model);
  const std::size_t n = all.velocity_count;
  const std::size_t wanted = all.size() / n + 4;
  Sampler draw(seed);
  SampledGenerators result;
  for (std::size_t k = 0; k < draws_per_state * wanted && result.states.size() < wanted; ++k) {
    State state = resting;
    draw_motion(checked.model, draw, 0, state);
    const std::vector<std::vector<cl_R>> own = sample_conditions(checked, moving, all, state);
    if (own.size() < n) continue;
    result.rows.insert(result.rows.end(), own.begin(), own.end());
    result.states.push_back(std::move(state));
  }
  if (result.states.size() < wanted) return std::nullopt;
  result.basis = null_vectors(result.rows, all.size());
  return result;
}

}  // namespace

MotionPoint<Real> motion_point_at(ExactValues& values) {
  const Arguments<Real>& at = values.arguments();
  return {at.q, at.v, at.a, at.t,
          sum_residual_terms(values.subject().program, values.size(),
                             [&](OutputKind kind) { return values.entries(kind); })};
}

bool satisfies_conditions(const SampledGenerators& sampled, const std::vector<cl_R>& generator) {
  const cl_R largest = max_magnitude(generator);
  return std::ranges::all_of(sampled.rows, [&](const std::vector<cl_R>& row) {
    cl_R sum = 0;
    cl_R size = 0;
    for (std::size_t u = 0; u < generator.size(); ++u) {
      const cl_R term = row[u] * generator[u];
      sum = sum + term;
      size = size + cln::abs(term);
    }
    return cln::abs(sum) <= noise_threshold() * size || size <= rounding_threshold() * largest;
  });
}

std::optional<SampledGenerators> sample_generators(const CheckedModel& checked,
                                                   const Program& motion_program,
                                                   const State& rest_state) {
  return with_digits(sampling_digits,
                     [&] { return null_space_generators(checked, motion_program, rest_state); });
}

std::vector<SampledGenerators> sample_other_parameters(const CheckedModel& checked,
                                                       const Program& moving) {
  constexpr std::size_t sets = 3;
  std::vector<SampledGenerators> found;
  for (std::size_t turn = 0; turn < draws_per_state && found.size() < sets; ++turn) {
    Sampler draw(seed + turn);
    // For an odd last argument, draw_state() draws parameters from their whole declared ranges.
    const State state = draw_state(checked.model, checked.scene, draw, 2 * turn + 1);
    auto here = sample_generators(checked, moving, state);
    if (here) found.push_back(std::move(*here));
  }
  return found;
}

}  // namespace elgen
