// Growth rates of natural systems are those of their modes, known to 64 digits.
#include "analyse/stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "analyse/linear_equations.hpp"
#include "analyse/modes.hpp"
#include "elgen/evaluate.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Real parts below this share of the largest pole may be rounding of doubles: a triple pole is
/// known to the third root of their spacing.
constexpr double pole_noise = 1e-5;

/// By the signs of real parts; growth rates are those of conjugate poles once.
void judge_by_poles(const std::vector<std::complex<double>>& poles, StabilityVerdict& verdict) {
  double largest = 0;
  for (const auto& pole : poles) largest = std::max(largest, std::abs(pole));
  const double noise = pole_noise * largest;
  bool all_decay = !poles.empty();
  for (const auto& pole : poles) {
    const bool is_first_of_pair = pole.imag() >= 0;
    if (is_first_of_pair && pole.real() > noise) verdict.growth_rates.push_back(pole.real());
    all_decay = all_decay && pole.real() < -noise;
  }
  if (all_decay) verdict.kind = Stability::decaying;
}

}  // namespace

bool is_positive_definite(const std::vector<cl_R>& matrix,
                          const std::vector<std::uint32_t>& left_out,
                          const std::vector<cl_R>& usual) {
  static const cl_R noise = power_of_ten(-25);
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(matrix.size())));
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < n; ++k) {
    if (std::ranges::find(left_out, k) == left_out.end()) kept.push_back(k);
  }
  std::vector<cl_R> block;
  for (const std::size_t i : kept) {
    for (const std::size_t k : kept) block.push_back(matrix[i * n + k]);
  }
  DiagonalPivot<cl_R> field;
  const Echelon<DiagonalPivot<cl_R>> echelon(field, block, kept.size(), kept.size());
  const std::vector<cl_R>& sizes = usual.empty() ? matrix : usual;
  return echelon.rank() == kept.size() &&
         std::ranges::all_of(echelon.pivots(), [&](const auto& pivot) {
           return pivot.value > noise * cln::abs(sizes[kept[pivot.column] * (n + 1)]);
         });
}

std::vector<std::complex<double>> poles_of(const RestPoint& point) {
  const Eigen::MatrixXd a = state_matrix(point);
  if (!a.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a, false);
  std::vector<std::complex<double>> poles;
  for (Eigen::Index i = 0; i < a.rows(); ++i) poles.push_back(solver.eigenvalues()[i]);
  std::ranges::sort(poles, [](const auto& x, const auto& y) {
    return std::tuple(std::abs(x), x.real(), x.imag()) >
           std::tuple(std::abs(y), y.real(), y.imag());
  });
  return poles;
}

StabilityVerdict stability_of(const RestPoint& point, const RestConditions& conditions) {
  StabilityVerdict verdict;
  verdict.is_degenerate = !conditions.degenerate.empty();
  if (verdict.is_degenerate) verdict.leading = conditions.degenerate.front();
  std::vector<std::uint32_t> flat;
  for (const LeadingTerm& term : conditions.degenerate) flat.push_back(term.coordinate);
  if (conditions.is_conservative && conditions.free_count == 0 &&
      is_positive_definite(point.stiffness, flat)) {
    if (flat.empty()) {
      verdict.kind = Stability::minimum;
      return verdict;
    }
    const bool is_minimum = std::ranges::all_of(conditions.is_positive, std::identity{}) &&
                            std::ranges::all_of(conditions.degenerate, [](const LeadingTerm& t) {
                              return t.order % 2 == 0;
                            });
    if (is_minimum) {
      verdict.kind = Stability::degenerate_minimum;
      return verdict;
    }
  }
  if (is_natural(point) && is_positive_definite(point.mass)) {
    for (const NormalMode& mode : normal_modes(point)) {
      const double square = ScalarTraits<double>::from_real(mode.omega_squared);
      if (square < 0) verdict.growth_rates.push_back(std::sqrt(-square));
    }
  } else {
    judge_by_poles(poles_of(point), verdict);
  }
  if (!verdict.growth_rates.empty()) verdict.kind = Stability::unstable;
  return verdict;
}

}  // namespace elgen
