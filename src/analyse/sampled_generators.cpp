// Gauss and Jordan with the largest pivot of each column; of 64 digits 40 decide between 0 and
// another number.
#include "analyse/sampled_generators.hpp"

#include <cln/float.h>

#include <algorithm>
#include <array>

#include "base/exact_number.hpp"
#include "base/random.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr std::uint64_t seed = 1;

/// R = M a + bias - dD/dv + Q: forces and dissipation taken off.
constexpr std::array<std::pair<OutputKind, int>, 3> parts{{{OutputKind::inverse_dynamics, 1},
                                                           {OutputKind::dissipation, -1},
                                                           {OutputKind::applied_force, 1}}};

/// A quantity of every velocity, summed over those of the parts that the program has.
template <class Part>
std::vector<Real> sum_of_parts(const Program& program, std::size_t n, const Part& part) {
  std::vector<Real> sum(n);
  for (const auto& [kind, sign] : parts) {
    if (find_function(program, kind) == nullptr) continue;
    const std::vector<Real> terms = part(kind);
    for (std::size_t i = 0; i < n; ++i) sum[i] = sum[i] + Real(sign) * terms[i];
  }
  return sum;
}

ResidualSlopes<Real> slopes_at(const ExactValues& values) {
  const std::size_t n = values.size();
  const Program& program = values.subject().program;
  const auto along = [&](const Arguments<Real>& direction, std::vector<Real>& slopes,
                         std::size_t column, std::size_t columns) {
    slopes.resize(n * columns);
    const std::vector<Real> sum =
        sum_of_parts(program, n, [&](OutputKind kind) { return values.slopes(kind, direction); });
    for (std::size_t i = 0; i < n; ++i) slopes[i * columns + column] = sum[i];
  };
  ResidualSlopes<Real> slopes;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Real> unit(n);
    unit[k] = Real(1);
    Arguments<Real> by_position = values.at_rest();
    Arguments<Real> by_velocity = by_position;
    Arguments<Real> by_acceleration = by_position;
    by_position.q = values.coordinate_rates(unit);
    by_velocity.v = unit;
    by_acceleration.a = unit;
    along(by_position, slopes.by_position, k, n);
    along(by_velocity, slopes.by_velocity, k, n);
    along(by_acceleration, slopes.by_acceleration, k, n);
  }
  Arguments<Real> by_time = values.at_rest();
  by_time.t = Real(1);
  along(by_time, slopes.by_time, 0, 1);
  return slopes;
}

/// The numbers of a row in 64 digits, of which exact ones would grow by elimination; the largest of
/// which becomes 1; none where one is undefined.
std::optional<std::vector<cl_R>> scaled_row(const std::vector<Real>& row) {
  static const cln::float_format_t digits = cln::float_format(64);
  std::vector<cl_R> numbers;
  for (const Real& entry : row) {
    if (!entry.is_defined()) return std::nullopt;
    numbers.push_back(cln::cl_float(entry.value(), digits));
  }
  const cl_R scale = largest_of(numbers);
  if (cln::zerop(scale)) return numbers;
  for (cl_R& entry : numbers) entry = entry / scale;
  return numbers;
}

Echelon<cl_R> eliminated(std::vector<std::vector<cl_R>> rows, std::size_t unknowns) {
  static const cl_R noise = power_of_ten(-40);
  Echelon<cl_R> result;
  std::size_t done = 0;
  for (std::size_t u = 0; u < unknowns && done < rows.size(); ++u) {
    std::size_t pivot = done;
    for (std::size_t i = done; i < rows.size(); ++i) {
      if (cln::abs(rows[i][u]) > cln::abs(rows[pivot][u])) pivot = i;
    }
    if (cln::abs(rows[pivot][u]) < noise) continue;
    std::swap(rows[pivot], rows[done]);
    const cl_R lead = rows[done][u];
    for (cl_R& entry : rows[done]) entry = entry / lead;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == done || cln::abs(rows[i][u]) < noise) continue;
      const cl_R factor = rows[i][u];
      for (std::size_t k = u; k < unknowns; ++k) {
        rows[i][k] = rows[i][k] - factor * rows[done][k];
      }
    }
    result.pivots.push_back(u);
    ++done;
  }
  rows.resize(done);
  result.rows = std::move(rows);
  return result;
}

/// Negation for solutions().
struct NumberField {
  using Number = cl_R;
  [[nodiscard]] static cl_R integer(int value) { return value; }
  [[nodiscard]] static cl_R negate(const cl_R& x) { return -x; }
};

}  // namespace

MotionPoint<Real> sampled_point(ExactValues& values) {
  const Arguments<Real>& at = values.arguments();
  return {at.q, at.v, at.a, at.t,
          sum_of_parts(values.subject().program, values.size(),
                       [&](OutputKind kind) { return values.value(kind); })};
}

std::optional<cln::cl_RA> small_fraction(const cl_R& value) {
  static const cl_R near = power_of_ten(-30);
  for (int q = 1; q <= 1000; ++q) {
    const cln::cl_I p = cln::round1(value * q);
    if (cln::abs(value - p / cln::cl_RA(q)) < near) return p / cln::cl_RA(q);
  }
  return std::nullopt;
}

bool is_generic(const CheckedModel& checked, const Program& moving,
                const std::vector<cl_R>& generator) {
  static const cl_R noise = power_of_ten(-40);
  constexpr std::size_t states = 4;
  const GeneratorClass all(checked.model);
  Random random(seed);
  RealField field;
  for (std::size_t k = 0; k < states; ++k) {
    State state = nominal_state(checked.model, checked.scene);
    draw_parameters(checked.model, checked.scene.specialisation.fixed, random, 0, state);
    draw_motion(checked.model, random, 0, state);
    ExactValues values({checked.model, checked.scene, moving}, state);
    for (const auto& row : conditions(field, all, sampled_point(values), slopes_at(values))) {
      const auto numbers = scaled_row(row);
      if (!numbers) continue;
      cl_R sum = 0;
      for (std::size_t u = 0; u < generator.size(); ++u) {
        sum = sum + (*numbers)[u] * generator[u];
      }
      if (cln::abs(sum) > noise * largest_of(generator)) return false;
    }
  }
  return true;
}

std::optional<SampledGenerators> sampled_generators(const CheckedModel& checked,
                                                    const Program& moving) {
  const Model& model = checked.model;
  const GeneratorClass all(model);
  const std::size_t n = all.velocity_count;
  const std::size_t wanted = all.size() / n + 4;
  Random random(seed);
  SampledGenerators result;
  std::vector<std::vector<cl_R>> rows;
  RealField field;
  for (std::size_t turn = 0; turn < 4 * wanted && result.states.size() < wanted; ++turn) {
    State state = nominal_state(model, checked.scene);
    draw_motion(model, random, 0, state);
    ExactValues values({model, checked.scene, moving}, state);
    std::vector<std::vector<cl_R>> own;
    for (const auto& row : conditions(field, all, sampled_point(values), slopes_at(values))) {
      if (const auto numbers = scaled_row(row)) own.push_back(*numbers);
    }
    if (own.size() < n) continue;
    rows.insert(rows.end(), own.begin(), own.end());
    result.states.push_back(std::move(state));
  }
  if (result.states.size() < wanted) return std::nullopt;
  NumberField numbers;
  result.basis = solutions(numbers, eliminated(std::move(rows), all.size()), all.size());
  return result;
}

}  // namespace elgen
