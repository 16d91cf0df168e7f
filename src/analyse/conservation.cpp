// D is taken for dissipative where its second derivatives at v = 0 are constants and make a
// positive semidefinite matrix.
#include "analyse/conservation.hpp"

#include <algorithm>
#include <array>

#include "analyse/chart_breaks.hpp"
#include "analyse/rest.hpp"
#include "numbers/dual.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;

bool is_absent(const Program& moving, OutputKind kind) {
  const Function* const function = find_function(moving, kind);
  return function == nullptr || is_zero(moving, *function);
}

template <class Holds>
bool none_holds(const Program& moving, OutputKind kind, const Holds& holds) {
  return std::ranges::none_of(occurrences(moving, *find_function(moving, kind)), holds);
}

bool holds_coordinates(const Occurrence& entry) { return !entry.coordinates.empty(); }

/// By elimination in 64 digits: a pivot that is 0 has to stand alone.
bool is_positive_semidefinite(std::vector<cl_R> a, std::size_t n) {
  const cl_R noise = largest_of(a) * power_of_ten(-40);
  for (std::size_t k = 0; k < n; ++k) {
    const cl_R pivot = a[k * n + k];
    if (pivot < -noise) return false;
    const bool is_flat = pivot <= noise;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (is_flat && cln::abs(a[i * n + k]) > noise) return false;
      if (is_flat) continue;
      const cl_R factor = a[i * n + k] / pivot;
      for (std::size_t j = k; j < n; ++j) a[i * n + j] = a[i * n + j] - factor * a[k * n + j];
    }
  }
  return true;
}

bool dissipates(const Program& moving, const State& state) {
  if (is_absent(moving, OutputKind::dissipation)) return true;
  if (!none_holds(moving, OutputKind::dissipation, holds_coordinates)) return false;
  const std::vector<Real> slopes =
      velocity_slopes(moving, OutputKind::dissipation, arguments_at<Real>(state));
  return is_positive_semidefinite(numbers_of(slopes), state.v.size());
}

}  // namespace

std::vector<Real> velocity_slopes(const Program& moving, OutputKind kind,
                                  const Arguments<Real>& at) {
  const Function& function = *find_function(moving, kind);
  const std::size_t n = at.v.size();
  std::vector<Real> slopes(entry_count(function) * n);
  for (std::size_t k = 0; k < n; ++k) {
    Arguments<Real> direction = map_leaves([](const Real&) { return Real(); }, at);
    direction.v[k] = Real(cl_R(1));
    const auto entries = evaluate(moving, function, elgen::moving(at, direction));
    for (std::size_t i = 0; i < entries.size(); ++i) slopes[i * n + k] = entries[i].slope;
  }
  return slopes;
}

bool is_conservative(const Program& moving, const State& state) {
  // A point that moves with t may have an energy that does not.
  const bool is_free_of_time = std::ranges::all_of(
      std::array{OutputKind::bias, OutputKind::mass_matrix, OutputKind::energy_function},
      [&](OutputKind kind) {
        return none_holds(moving, kind, [](const Occurrence& entry) { return entry.has_time; });
      });
  const bool is_driven =
      std::ranges::any_of(state.u, [](const cl_R& u) { return !cln::zerop(u); }) &&
      !none_holds(moving, OutputKind::input_matrix, holds_coordinates);
  return is_free_of_time && !is_driven && is_absent(moving, OutputKind::applied_force) &&
         dissipates(moving, state);
}

}  // namespace elgen
