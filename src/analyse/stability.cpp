// Natural systems have normal modes. Eigen's self-adjoint solver gives the shapes in doubles. w^2
// is the Rayleigh quotient in 64 digits. The error of w^2 is the squared error of the shape. All
// other systems are judged by their poles. D counts as dissipative if dD/dv does not depend on q,
// and d2D/dv2 at v = 0 is positive semidefinite.
#include "analyse/stability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <tuple>

#include "analyse/chart_breaks.hpp"
#include "analyse/newton_refinement.hpp"
#include "analyse/rest.hpp"
#include "elgen/evaluate.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Matrix = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Poles = std::vector<std::complex<double>>;

/// Values of w^2 are equal if they differ by at most this fraction of the largest w^2. A component
/// of a shape is 0 if its magnitude is below this fraction of the largest component.
constexpr double equal_share = 1e-9;

/// Real parts below this fraction of the largest pole may be rounding errors: the relative error of
/// a triple pole is the cube root of the machine epsilon.
constexpr double pole_noise = 1e-5;

// Linear equations in doubles.

/// The matrix with `rows` rows and the row-major entries `values`, rounded to doubles.
Matrix matrix_of(const std::vector<cl_R>& values, std::size_t rows) {
  std::vector<double> numbers;
  for (const cl_R& value : values) numbers.push_back(to_double(value));
  const auto r = static_cast<Eigen::Index>(rows);
  const Eigen::Index c = rows == 0 ? 0 : static_cast<Eigen::Index>(numbers.size() / rows);
  return Eigen::Map<const RowMajor>(numbers.data(), r, c);
}

std::vector<double> row_major_values(const Matrix& matrix) {
  const RowMajor rows = matrix;
  return {rows.data(), rows.data() + rows.size()};
}

/// [0, 1; -M^-1 K, -M^-1 D] with D = `damping`; some entries are not finite if M is singular.
Matrix state_matrix(const RestPoint& point) {
  const std::size_t n = point.state.v.size();
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::PartialPivLU<Matrix> mass(matrix_of(point.mass, n));
  Matrix a = Matrix::Zero(2 * size, 2 * size);
  a.topRightCorner(size, size).setIdentity();
  a.bottomLeftCorner(size, size) = -mass.solve(matrix_of(point.stiffness, n));
  a.bottomRightCorner(size, size) = -mass.solve(matrix_of(point.damping, n));
  return a;
}

// Normal modes.

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

/// Scales a shape so that its largest component (the first, if several are equal) is 1.
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

/// Reduces the shapes of a multiple w^2 to echelon form: each shape has a component that is 0 in
/// all other shapes.
void reduce_shapes(std::vector<NormalMode>& modes, std::size_t first, std::size_t count) {
  const std::size_t n = modes[first].shape.size();
  std::vector<double> shapes;
  for (std::size_t i = first; i < first + count; ++i) {
    shapes.insert(shapes.end(), modes[i].shape.begin(), modes[i].shape.end());
  }
  using Shapes = LargestPivot<double, EchelonForm::reduced>;
  Shapes field(1e-6);  // far above the rounding errors of the solver
  const Echelon<Shapes> echelon(field, shapes, n, n);
  for (std::size_t i = 0; i < echelon.rank(); ++i) {
    std::vector<double>& shape = modes[first + i].shape;
    shape.assign(n, 0.0);
    shape[echelon.pivots()[i].column] = 1;
    for (const auto& entry : echelon.row_without_pivot(echelon.pivots()[i]))
      shape[entry.column] = entry.value;
  }
}

/// True if the linear equations have no terms in x', and K is symmetric.
bool is_natural(const RestPoint& point) {
  return is_zero_matrix(point.damping) && is_symmetric(point.stiffness, point.state.v.size());
}

/// The modes of a natural system with positive definite M, by ascending w^2. The error of w^2 is
/// the squared error of its shape in doubles. Values of w^2 below 1e-20 of the largest are set to
/// 0.
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

// Poles.

/// The poles +-sqrt(-w^2) of all modes.
Poles poles_of(const std::vector<NormalMode>& modes) {
  Poles poles;
  for (const NormalMode& mode : modes) {
    const double square = to_double(mode.omega_squared);
    const std::complex<double> pole = std::sqrt(std::complex<double>(-square, 0));
    poles.push_back(pole);
    poles.push_back(-pole);
  }
  std::ranges::stable_sort(poles, std::greater{}, [](const auto& pole) { return std::abs(pole); });
  return poles;
}

/// The eigenvalues of the state matrix, by descending magnitude; empty if M is singular.
Poles poles_of(const RestPoint& point) {
  const Matrix a = state_matrix(point);
  if (!a.allFinite()) return {};
  const Eigen::EigenSolver<Matrix> solver(a, false);
  Poles poles;
  for (Eigen::Index i = 0; i < a.rows(); ++i) poles.push_back(solver.eigenvalues()[i]);
  std::ranges::sort(poles, [](const auto& x, const auto& y) {
    return std::tuple(std::abs(x), x.real(), x.imag()) >
           std::tuple(std::abs(y), y.real(), y.imag());
  });
  return poles;
}

/// Sets `verdict` from the signs of the real parts of `poles`. A conjugate pair adds at most one
/// growth rate.
void set_verdict_from_poles(const Poles& poles, StabilityVerdict& verdict) {
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

/// The least rank of [A - p I, B] over all poles p (Popov, Belevitch, Hautus).
std::size_t controllable_rank(const Matrix& a, const Matrix& b, const Poles& poles) {
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

LinearMotions linear_motions(const RestPoint& point) {
  LinearMotions result{point};
  const std::size_t n = point.state.v.size();
  const Matrix a = state_matrix(point);
  result.a = row_major_values(a);
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
    result.b = row_major_values(b);
    result.controllable_rank = controllable_rank(a, b, result.poles);
  }
  return result;
}

// Energy.

bool is_absent_or_zero(const Program& moving, OutputKind kind) {
  const Function* const function = find_function(moving, kind);
  return function == nullptr || is_zero(moving, *function);
}

template <class Holds>
bool no_entry_satisfies(const Program& moving, OutputKind kind, const Holds& holds) {
  return std::ranges::none_of(coordinate_occurrences(moving, *find_function(moving, kind)), holds);
}

bool has_coordinates(const CoordinateOccurrence& entry) { return !entry.coordinates.empty(); }

/// True if a symmetric matrix is positive semidefinite, by symmetric elimination in 64 digits. If a
/// pivot is 0, its row and column must be 0.
bool is_positive_semidefinite(std::vector<cl_R> a, std::size_t n) {
  const cl_R noise = max_magnitude(a) * power_of_ten(-40);
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

bool is_dissipative(const Program& moving, const State& state) {
  if (is_absent_or_zero(moving, OutputKind::dissipation)) return true;
  if (!no_entry_satisfies(moving, OutputKind::dissipation, has_coordinates)) return false;
  const std::vector<Real> slopes =
      velocity_slopes(moving, OutputKind::dissipation, arguments_at<Real>(state));
  return is_positive_semidefinite(values_or_zero(slopes), state.v.size());
}

}  // namespace

bool is_positive_definite(const std::vector<cl_R>& matrix,
                          const std::vector<std::uint32_t>& excluded,
                          const std::vector<cl_R>& reference) {
  static const cl_R noise = power_of_ten(-25);
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(matrix.size())));
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < n; ++k) {
    if (std::ranges::find(excluded, k) == excluded.end()) kept.push_back(k);
  }
  std::vector<cl_R> block;
  for (const std::size_t i : kept) {
    for (const std::size_t k : kept) block.push_back(matrix[i * n + k]);
  }
  DiagonalPivot<cl_R> field;
  const Echelon<DiagonalPivot<cl_R>> echelon(field, block, kept.size(), kept.size());
  const std::vector<cl_R>& sizes = reference.empty() ? matrix : reference;
  return echelon.rank() == kept.size() &&
         std::ranges::all_of(echelon.pivots(), [&](const auto& pivot) {
           return pivot.value > noise * cln::abs(sizes[kept[pivot.column] * (n + 1)]);
         });
}

bool is_conservative(const Program& motion_program, const State& state) {
  // A test of E is not enough: for a point with a prescribed motion, E may be free of t.
  const bool is_free_of_time = std::ranges::all_of(
      std::array{OutputKind::bias, OutputKind::mass_matrix, OutputKind::energy_function},
      [&](OutputKind kind) {
        return no_entry_satisfies(motion_program, kind,
                                  [](const CoordinateOccurrence& entry) { return entry.has_time; });
      });
  const bool is_driven =
      std::ranges::any_of(state.u, [](const cl_R& u) { return !cln::zerop(u); }) &&
      !no_entry_satisfies(motion_program, OutputKind::input_matrix, has_coordinates);
  return is_free_of_time && !is_driven &&
         is_absent_or_zero(motion_program, OutputKind::applied_force) &&
         is_dissipative(motion_program, state);
}

StabilityVerdict stability_of(const RestPoint& point, const LagrangeDirichletPremises& conditions) {
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
      const double square = to_double(mode.omega_squared);
      if (square < 0) verdict.growth_rates.push_back(std::sqrt(-square));
    }
  } else {
    set_verdict_from_poles(poles_of(point), verdict);
  }
  if (!verdict.growth_rates.empty()) verdict.kind = Stability::unstable;
  return verdict;
}

Result<Modes> find_modes(const CheckedModel& checked, const Equilibria& equilibria) {
  Modes result{equilibria.forms, equilibria.inputs};
  for (const RestPoint& point : equilibria.points) {
    if (!equilibria.has_given_point && !is_stable(point.stability.kind)) continue;
    if (!is_positive_definite(point.mass)) {
      return Diagnostic{Code::E533, checked.model.name_span,
                        "the mass matrix is singular at this equilibrium"};
    }
    result.motions.push_back(linear_motions(point));
  }
  if (result.motions.empty()) {
    return Diagnostic{
        Code::E532, {}, "no equilibrium is known to be stable", "give a point: `--at theta=0`"};
  }
  return result;
}

}  // namespace elgen
