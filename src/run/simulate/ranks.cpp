// RankWatch: computes pivots at each state of a run, and compares them with earlier pivots.
#include "run/simulate/ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "numbers/echelon.hpp"

namespace elgen {
namespace {

/// A pivot below 1e-8 of its largest value has lost half of the 16 digits of a double. Then
/// rounding errors dominate the projection onto the constraints, and the projection changes the
/// energy. At a ratio of 1e-11, the change is about 1e-9 of the energy.
constexpr double min_pivot_ratio = 1e-8;

/// The cosine of 120 degrees. If a row turns by more in one step, the step has no correct digit,
/// unless the row passed through 0.
constexpr double reversal_cosine = -0.5;

/// The pivots of X Y^T, eliminated without row interchanges; X and Y have n columns.
Numbers pivots_of_product(const Numbers& x, const Numbers& y, std::size_t n) {
  const std::size_t m = x.size() / n;
  Numbers product(m * m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m * n; ++k) product[i * m + k / n] += x[i * n + k % n] * y[k];
  }
  DiagonalPivot<double> field;
  const Echelon<DiagonalPivot<double>> echelon(field, product, m, m);
  Numbers pivots;
  for (const auto& pivot : echelon.pivots()) pivots.push_back(pivot.value);
  return pivots;
}

}  // namespace

Diagnostics RankWatch::check_ranks(const Numbers& state, double t) {
  const Numbers pivots = pivots_;
  const Numbers rows = scaled_rows_;
  measure_pivots(state, t);
  const std::string what =
      rank_loss_text(pivots.empty() ? pivots_ : pivots, pivots.empty() ? scaled_rows_ : rows);
  if (what.empty()) return {};
  return {{Code::E624,
           {},
           fmt::format("rank is {} t = {:.6g}, where {}", what, t, system_.state_text(state)),
           hint_}};
}

std::string RankWatch::weakest_pivot_text() const {
  std::size_t least = 0;
  for (std::size_t i = 1; i < largest_.size(); ++i) {
    if (pivot_ratio(i) < pivot_ratio(least)) least = i;
  }
  // A pivot that fell by less than four digits is not the reason for a short step.
  if (largest_.empty() || pivot_ratio(least) > 1e-4) return "";
  return fmt::format(": the pivot of {} is {:.1e} of its largest value", pivot_name(least),
                     pivot_ratio(least));
}

void RankWatch::measure_pivots(const Numbers& state, double t) {
  const double* const q = state.data();
  const double* const v = system_.v_of(state);
  const std::size_t n = system_.velocity_count();
  Numbers diagonal(n);
  system_.find_acceleration(q, v, t, diagonal.data());
  const std::span<const double> relative = system_.relative_pivots().first(n);
  pivots_.assign(relative.begin(), relative.end());
  const Numbers& mass = system_.mass_matrix(q, v, t);
  for (std::size_t i = 0; i < n; ++i) diagonal[i] = mass[i * n + i];
  scaled_rows_ = system_.constraint_jacobian(q, v, t);
  for (std::size_t k = 0; k < scaled_rows_.size(); ++k)
    scaled_rows_[k] /= std::sqrt(std::abs(diagonal[k % n]));
  const Numbers of_rows = pivots_of_product(scaled_rows_, scaled_rows_, n);
  pivots_.insert(pivots_.end(), of_rows.begin(), of_rows.end());
  for (std::size_t i = 0; i < n; ++i) pivots_.push_back(pivots_[i] * diagonal[i]);
  largest_.resize(pivots_.size());
  for (std::size_t i = 0; i < pivots_.size(); ++i) {
    largest_[i] = std::max(largest_[i], std::abs(pivots_[i]));
  }
}

/// The ratio of a pivot to its largest value so far; 1 if all values were 0.
double RankWatch::pivot_ratio(std::size_t i) const {
  return largest_[i] > 0 ? std::abs(pivots_[i]) / largest_[i] : 1;
}

std::string RankWatch::pivot_name(std::size_t i) const {
  const std::size_t n = system_.velocity_count();
  const std::size_t both = pivots_.size() - n;
  if (n <= i && i < both) return fmt::format("`{}` in A", system_.model().constraints[i - n].name);
  const auto velocity = static_cast<std::uint32_t>(i < n ? i : i - both);
  return fmt::format("`{}` in M", leaf_text(system_.leaves(), Opcode::velocity, velocity));
}

/// Describes the loss of rank; "" if both ranks are full. D_i is checked only for a change of sign,
/// because D_i may be small without loss of rank. Example: D_i = m r^2 near the centre of an orbit.
std::string RankWatch::rank_loss_text(const Numbers& pivots_before,
                                      const Numbers& rows_before) const {
  const std::size_t n = system_.velocity_count();
  const std::size_t both = pivots_.size() - n;
  for (std::size_t i = 0; i < both; ++i) {
    if (pivot_ratio(i) >= min_pivot_ratio) continue;
    return fmt::format("nearly lost, because the pivot of {} is {:.1e} of its largest value, at",
                       pivot_name(i), pivot_ratio(i));
  }
  for (std::size_t i = both; i < pivots_.size(); ++i) {
    if (!(pivots_[i] * pivots_before[i] < 0)) continue;
    return fmt::format("lost, because the pivot of {} changes its sign, before", pivot_name(i));
  }
  const Numbers turns = pivots_of_product(rows_before, scaled_rows_, n);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const double size = std::sqrt(std::abs(pivots_before[n + k] * pivots_[n + k]));
    if (!(turns[k] < reversal_cosine * size)) continue;
    return fmt::format("lost, because the row of {} reverses, before", pivot_name(n + k));
  }
  return "";
}

}  // namespace elgen
