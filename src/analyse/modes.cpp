// Modes by Eigen's self-adjoint solver in doubles; of each w^2 the Rayleigh quotient in 64 digits,
// whose error is the square of that of the shape.
#include "analyse/modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>

#include "analyse/linear_equations.hpp"
#include "analyse/stability.hpp"
#include "elgen/evaluate.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Matrix = Eigen::MatrixXd;

/// Values of w^2 that differ by this share of the largest are one; smaller ones are 0.
constexpr double equal_share = 1e-9;

std::vector<double> numbers_of(const Matrix& matrix) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows = matrix;
  return {rows.data(), rows.data() + rows.size()};
}

bool is_zero_matrix(const std::vector<cl_R>& values) {
  return std::ranges::all_of(values, [](const cl_R& value) { return cln::zerop(value); });
}

bool is_symmetric(const std::vector<cl_R>& matrix, std::size_t n) {
  static const cl_R noise = power_of_ten(-30);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const cl_R& x = matrix[i * n + k];
      const cl_R& y = matrix[k * n + i];
      if (cln::abs(x - y) > noise * (cln::abs(x) + cln::abs(y))) return false;
    }
  }
  return true;
}

/// x.A x
cl_R quadratic_form(const std::vector<cl_R>& matrix, const std::vector<cl_R>& x) {
  cl_R sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) sum = sum + x[i] * matrix[i * x.size() + k] * x[k];
  }
  return sum;
}

/// The largest component becomes 1, the first of those that are as large.
void scale_shape(std::vector<double>& shape) {
  double largest = 0;
  for (const double x : shape) largest = std::max(largest, std::abs(x));
  const auto first = std::ranges::find_if(
      shape, [&](double x) { return std::abs(x) > largest * (1 - equal_share); });
  const double scale = *first;
  for (double& x : shape) {
    x /= scale;
    if (std::abs(x) < equal_share) x = 0;
  }
}

/// Shapes of one w^2 are a basis of a space: the one in which every shape has a component that no
/// other has.
void reduce_shapes(std::vector<NormalMode>& modes, std::size_t first, std::size_t count) {
  const std::size_t n = modes[first].shape.size();
  std::vector<double> shapes;
  for (std::size_t i = first; i < first + count; ++i) {
    shapes.insert(shapes.end(), modes[i].shape.begin(), modes[i].shape.end());
  }
  using Shapes = LargestPivot<double, EchelonForm::reduced>;
  Shapes field(1e-6);  // what the rounding of the solver leaves of 0 is smaller by far
  const Echelon<Shapes> echelon(field, shapes, n, n);
  for (std::size_t i = 0; i < echelon.rank(); ++i) {
    std::vector<double>& shape = modes[first + i].shape;
    shape.assign(n, 0.0);
    shape[echelon.pivots()[i].column] = 1;
    for (const auto& entry : echelon.rest(echelon.pivots()[i])) shape[entry.column] = entry.value;
  }
}

/// +-sqrt(-w^2) of every mode.
std::vector<std::complex<double>> poles_of(const std::vector<NormalMode>& modes) {
  std::vector<std::complex<double>> poles;
  for (const NormalMode& mode : modes) {
    const double square = ScalarTraits<double>::from_real(mode.omega_squared);
    const std::complex<double> pole = std::sqrt(std::complex<double>(-square, 0));
    poles.push_back(pole);
    poles.push_back(-pole);
  }
  std::ranges::stable_sort(poles, std::greater{}, [](const auto& pole) { return std::abs(pole); });
  return poles;
}

/// The least rank of [A - pole 1, B] over all poles (Popov, Belevitch, Hautus).
std::size_t controllable_rank(const Matrix& a, const Matrix& b,
                              const std::vector<std::complex<double>>& poles) {
  std::size_t least = static_cast<std::size_t>(a.rows());
  for (const std::complex<double>& pole : poles) {
    Eigen::MatrixXcd both(a.rows(), a.cols() + b.cols());
    both << a - pole * Eigen::MatrixXcd::Identity(a.rows(), a.cols()),
        b.cast<std::complex<double>>();
    Eigen::JacobiSVD<Eigen::MatrixXcd> parts(both);
    parts.setThreshold(equal_share);
    least = std::min(least, static_cast<std::size_t>(parts.rank()));
  }
  return least;
}

LinearMotions motions_about(const RestPoint& point) {
  LinearMotions result{point};
  const std::size_t n = point.state.v.size();
  const Matrix a = state_matrix(point);
  result.a = numbers_of(a);
  if (is_natural(point)) {
    result.modes = normal_modes(point);
    result.poles = poles_of(result.modes);
  } else {
    result.poles = poles_of(point);
  }
  if (!point.input_matrix.empty()) {
    const Matrix forces = matrix_of(point.input_matrix, n);
    Matrix b = Matrix::Zero(a.rows(), forces.cols());
    b.bottomRows(forces.rows()) = matrix_of(point.mass, n).partialPivLu().solve(forces);
    result.b = numbers_of(b);
    result.controllable = controllable_rank(a, b, result.poles);
  }
  return result;
}

}  // namespace

bool is_natural(const RestPoint& point) {
  return is_zero_matrix(point.damping) && is_symmetric(point.stiffness, point.state.v.size());
}

std::vector<NormalMode> normal_modes(const RestPoint& point) {
  const std::size_t n = point.state.v.size();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(matrix_of(point.stiffness, n),
                                                                matrix_of(point.mass, n));
  std::vector<NormalMode> modes;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::VectorXd x = solver.eigenvectors().col(static_cast<Eigen::Index>(i));
    NormalMode& mode = modes.emplace_back();
    mode.shape.assign(x.data(), x.data() + x.size());
    std::vector<cl_R> exact;
    for (const double component : mode.shape) exact.emplace_back(exact_value(component));
    mode.omega_squared = quadratic_form(point.stiffness, exact) / quadratic_form(point.mass, exact);
  }
  cl_R largest = 0;
  for (const NormalMode& mode : modes) largest = cln::max(largest, cln::abs(mode.omega_squared));
  const cl_R noise = largest * exact_value(equal_share);
  for (NormalMode& mode : modes) {
    if (cln::abs(mode.omega_squared) < largest * power_of_ten(-20)) mode.omega_squared = 0;
  }
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first + 1;
    while (end < n && cln::abs(modes[end].omega_squared - modes[first].omega_squared) <= noise) {
      ++end;
    }
    if (end - first > 1) reduce_shapes(modes, first, end - first);
    for (std::size_t i = first; i < end; ++i) {
      modes[i].multiplicity = end - first;
      scale_shape(modes[i].shape);
    }
    first = end;
  }
  return modes;
}

Result<std::vector<LinearMotions>> linear_motions(const CheckedModel& checked,
                                                  const Equilibria& equilibria, bool stable) {
  std::vector<LinearMotions> result;
  for (const RestPoint& point : equilibria.points) {
    if (stable && !is_stable(point.stability.kind)) continue;
    if (!is_positive_definite(point.mass)) {
      return Diagnostic{Code::E533, checked.model.name_span,
                        "the mass matrix is singular at this equilibrium"};
    }
    result.push_back(motions_about(point));
  }
  if (result.empty()) {
    return Diagnostic{
        Code::E532, {}, "no equilibrium is known to be stable", "say at which one: `--at theta=0`"};
  }
  return result;
}

}  // namespace elgen
