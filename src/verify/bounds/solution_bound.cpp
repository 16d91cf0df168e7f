// Solution bounds from the bounds of M, A, b and db/d(q, v, u).
#include "verify/bounds/solution_bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

#include "elgen/certificate.hpp"
#include "elgen/outputs.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

long double narrowed(const Real& x) { return ScalarTraits<long double>::from_real(x.value()); }

Real norm(const std::vector<Real>& values) {
  Real square;
  for (const Real& value : values) square = square + value * value;
  return sqrt(square);
}

using Spectrum = Eigen::Array<long double, Eigen::Dynamic, 1>;

/// The eigenvalues of a symmetric matrix whose rows and columns are divided by the weights; 0 where
/// they are not found.
Spectrum spectrum(const std::vector<Bound>& m, const std::vector<Real>& weights) {
  const auto n = static_cast<Eigen::Index>(weights.size());
  Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> scaled(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const Real weight =
          weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)];
      scaled(i, j) = narrowed(m[static_cast<std::size_t>(i * n + j)].value / weight);
    }
  }
  const Eigen::SelfAdjointEigenSolver<decltype(scaled)> solver(scaled, Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success) return Spectrum::Zero(n);
  return solver.eigenvalues().array();
}

/// The largest over the least; none where one of them is not above 0.
std::optional<Real> condition(const Spectrum& values) {
  const long double least = values.minCoeff();
  if (!(least > 0)) return std::nullopt;
  return Real(exact_value(static_cast<double>(values.maxCoeff() / least)));
}

/// [M A^T; A 0] for n x n M.
std::vector<Bound> with_constraints(const std::vector<Bound>& m, const std::vector<Bound>& a,
                                    std::size_t n) {
  const std::size_t rows = n + a.size() / n;
  std::vector<Bound> whole(rows * rows);
  for (std::size_t k = 0; k < m.size(); ++k) whole[k / n * rows + k % n] = m[k];
  for (std::size_t k = 0; k < a.size(); ++k) {
    whole[(n + k / n) * rows + k % n] = whole[k % n * rows + n + k / n] = a[k];
  }
  return whole;
}

bool is_known(const BoundedRun& run) { return run.regime == Regime::regular; }

/// Whether x is known to be below a tenth.
bool is_small(const Real& x) { return x.is_defined() && x.value() < cln::cl_RA(1) / 10; }

bool depends_on_position(const Function& function) {
  return std::any_of(function.instructions.begin(), function.instructions.end(),
                     [](const Instruction& i) { return i.opcode == Opcode::coordinate; });
}

}  // namespace

std::vector<OutputRequest> needed_parts(const Model& model, const Scene& scene) {
  bool solves = false;
  bool differentiates = false;
  for (const OutputRequest& output : scene.outputs) {
    const OutputRow& row = output_row(output.kind);
    solves = solves || row.solves;
    differentiates = differentiates || (row.solves && row.differentiates);
  }
  if (!solves || model.approximation) return {};
  std::vector<OutputKind> kinds{OutputKind::mass_matrix, OutputKind::bias};
  if (!model.inputs.empty()) kinds.push_back(OutputKind::input_matrix);
  if (!model.constraints.empty()) {
    kinds.insert(kinds.end(), {OutputKind::constraint_residual, OutputKind::constraint_jacobian,
                               OutputKind::constraint_bias});
  } else if (differentiates) {
    kinds.push_back(OutputKind::forward_dynamics);
    kinds.push_back(OutputKind::inverse_dynamics_derivatives);
  }
  std::vector<OutputRequest> needed;
  for (const OutputKind kind : kinds) needed.push_back(request_of(model, kind, 0));
  return needed;
}

const BoundedRun* SolutionBounds::run(OutputKind kind) {
  const Function* function = parts_ == nullptr ? nullptr : find_function(*parts_, kind);
  if (function == nullptr) return nullptr;
  auto& known = runs_[kind];
  if (!known) known = bounded_run(*parts_, *function, state_, rounding_);
  return &*known;
}

const BoundedRun* SolutionBounds::known_run(OutputKind kind) {
  const BoundedRun* found = run(kind);
  return found != nullptr && is_known(*found) ? found : nullptr;
}

/// Makes K of M; false where K is not known or singular.
bool SolutionBounds::add_constraints(Matrix& matrix, std::vector<Bound>& entries) {
  const BoundedRun* jacobian = known_run(OutputKind::constraint_jacobian);
  if (jacobian == nullptr) return false;
  const std::size_t n = matrix.weights.size();
  for (std::size_t first = 0; first < jacobian->entries.size(); first += n) {
    std::vector<Real> row;
    for (std::size_t j = 0; j < n; ++j) {
      row.push_back(jacobian->entries[first + j].value / matrix.weights[j]);
    }
    const Real length = norm(row);
    if (cln::zerop(length.value())) return false;
    matrix.weights.push_back(length);
  }
  entries = with_constraints(entries, jacobian->entries, n);
  const auto condition_of_whole = condition(spectrum(entries, matrix.weights).abs());
  if (!condition_of_whole) return false;
  matrix.condition = matrix.condition * *condition_of_whole;
  return true;
}

std::optional<SolutionBounds::Matrix> SolutionBounds::measured_matrix() {
  const BoundedRun* m = known_run(OutputKind::mass_matrix);
  if (m == nullptr) return std::nullopt;
  const std::size_t n = state_.v.size();
  Matrix matrix;
  for (std::size_t i = 0; i < n; ++i) {
    const Real& diagonal = m->entries[i * n + i].value;
    if (!cln::plusp(diagonal.value())) return std::nullopt;
    matrix.weights.push_back(sqrt(diagonal));
  }
  std::vector<Bound> entries = m->entries;
  const auto condition_of_mass = condition(spectrum(entries, matrix.weights));
  if (!condition_of_mass) return std::nullopt;
  matrix.condition = *condition_of_mass;
  if (!model_.constraints.empty() && !add_constraints(matrix, entries)) return std::nullopt;
  const std::size_t rows = matrix.weights.size();
  std::vector<Real> scaled;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    scaled.push_back(covering_bound(entries[k]) /
                     (matrix.weights[k / rows] * matrix.weights[k % rows]));
  }
  matrix.uncertainty = norm(scaled);
  const Real error = rounding_.roundoff * matrix.condition;
  if (!is_small(error) || !is_small(error * Real(8) * matrix.uncertainty)) return std::nullopt;
  return matrix;
}

const SolutionBounds::Matrix* SolutionBounds::matrix() {
  if (!matrix_) matrix_ = measured_matrix();
  return *matrix_ ? &**matrix_ : nullptr;
}

Real SolutionBounds::bound(const std::vector<Real>& x, const std::vector<Real>& right_side) const {
  const Matrix& m = **matrix_;
  std::vector<Real> scaled_x;
  std::vector<Real> scaled_side;
  for (std::size_t i = 0; i < x.size(); ++i) {
    scaled_x.push_back(x[i] * m.weights[i]);
    scaled_side.push_back(right_side[i] / m.weights[i]);
  }
  const Real n(cln::cl_I(static_cast<unsigned long>(x.size())));
  return m.condition * ((n + m.uncertainty) * norm(scaled_x) + norm(scaled_side));
}

/// d = D_i/M_ii is z.S z for a z with |z|^2 <= d/least eigenvalue, and the largest is at least 1.
/// The relative change of a D of A M^-1 A^T is D (x.dM x + 2 y.dA x) with M x = A^T y, x.M x = 1/D.
SolvedColumn SolutionBounds::pivot(std::size_t entry, const Bound& value) const {
  const Matrix& m = **matrix_;
  const Real n(cln::cl_I(static_cast<unsigned long>(m.weights.size())));
  return {{entry}, {Real(1)}, m.condition * (n + m.uncertainty) * abs(value.value)};
}

/// Bounds of gamma + 2 zeta omega r + omega^2 f, by constraint.
std::vector<Real> SolutionBounds::stabilised_bias() {
  const BoundedRun* bias = known_run(OutputKind::constraint_bias);
  const BoundedRun* residual = known_run(OutputKind::constraint_residual);
  if (bias == nullptr || residual == nullptr) return {};
  std::vector<Real> of_residual;
  for (const Bound& entry : residual->entries) of_residual.push_back(covering_bound(entry));
  std::vector<Real> bounds = stabilising_terms(model_, state_, of_residual);
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    bounds[k] = abs(bounds[k]) + covering_bound(bias->entries[k]);
  }
  return bounds;
}

/// Bounds of B u - bias, then of what A a has to be.
std::vector<Real> SolutionBounds::driven_bias() {
  const BoundedRun* bias = known_run(OutputKind::bias);
  const BoundedRun* input = known_run(OutputKind::input_matrix);
  const std::size_t inputs = state_.u.size();
  if (bias == nullptr || (inputs > 0 && input == nullptr)) return {};
  std::vector<Real> bounds;
  for (std::size_t i = 0; i < bias->entries.size(); ++i) {
    Real sum = covering_bound(bias->entries[i]);
    for (std::size_t k = 0; k < inputs; ++k) {
      sum = sum + covering_bound(input->entries[i * inputs + k]) * abs(Real(state_.u[k]));
    }
    bounds.push_back(sum);
  }
  if (model_.constraints.empty()) return bounds;
  const std::vector<Real> of_constraints = stabilised_bias();
  if (of_constraints.empty()) return {};
  bounds.insert(bounds.end(), of_constraints.begin(), of_constraints.end());
  return bounds;
}

/// Of one column: an entry of each row, `width` apart.
std::vector<Real> SolutionBounds::bounds_of(const BoundedRun& matrix, std::size_t first,
                                            std::size_t width) const {
  std::vector<Real> bounds;
  for (std::size_t i = 0; i < state_.v.size(); ++i) {
    bounds.push_back(covering_bound(matrix.entries[first + i * width]));
  }
  return bounds;
}

std::vector<Real> SolutionBounds::input_column(std::size_t input) {
  const BoundedRun* found = known_run(OutputKind::input_matrix);
  if (found == nullptr) return {};
  return bounds_of(*found, input, state_.u.size());
}

/// The derivatives of M a + bias, at accelerations that are known as well as their bound says.
const BoundedRun* SolutionBounds::inverse_derivatives() {
  if (inverse_derivatives_) return *inverse_derivatives_ ? &**inverse_derivatives_ : nullptr;
  inverse_derivatives_.emplace();
  const BoundedRun* forward = run(OutputKind::forward_dynamics);
  const auto kind = OutputKind::inverse_dynamics_derivatives;
  const Function* function = parts_ == nullptr ? nullptr : find_function(*parts_, kind);
  const std::vector<Real> side = driven_bias();
  if (forward == nullptr || function == nullptr || side.empty()) return nullptr;
  std::vector<Bound> accelerations(
      forward->entries.begin(),
      forward->entries.begin() + static_cast<std::ptrdiff_t>(side.size()));
  std::vector<Real> values;
  for (const Bound& a : accelerations) {
    if (!a.value.is_defined()) return nullptr;
    values.push_back(a.value);
  }
  const Real error = bound(values, side);
  for (std::size_t i = 0; i < accelerations.size(); ++i) {
    accelerations[i] = leaf_bound(values[i], false);
    accelerations[i].bound = max(abs(values[i]), error / matrix()->weights[i]);
  }
  BoundedRun derivatives = bounded_run(*parts_, *function, state_, rounding_, accelerations);
  if (!is_known(derivatives)) return nullptr;
  *inverse_derivatives_ = std::move(derivatives);
  return &**inverse_derivatives_;
}

bool SolutionBounds::inputs_act_everywhere_alike() const {
  const Function* function = find_function(*parts_, OutputKind::input_matrix);
  return function == nullptr || !depends_on_position(*function);
}

std::vector<Real> SolutionBounds::state_column(bool by_velocity, std::size_t column) {
  const BoundedRun* derivatives = inverse_derivatives();
  if (derivatives == nullptr || (!by_velocity && !inputs_act_everywhere_alike())) return {};
  const std::size_t n = state_.v.size();
  return bounds_of(*derivatives, (by_velocity ? n * n : 0) + column, n);
}

std::vector<Real> SolutionBounds::right_side(const FieldPlace& place, std::size_t column) {
  const std::size_t n = state_.v.size();
  const FieldRow& row = place.row();
  if (row.columns == Extent::inputs) return input_column(column);
  // A field has a column of every state, or of every position, or of every velocity.
  const bool is_of_state = row.columns == Extent::states;
  return state_column(is_of_state ? column >= n : row.name == "by_velocity", column % n);
}

/// Accelerations and multipliers have one bound.
std::vector<SolvedColumn> SolutionBounds::motion_columns(const FieldPlace& place,
                                                         const std::vector<Bound>& entries) {
  const std::size_t count = place.field().entries.size();
  const std::size_t n = state_.v.size();
  std::vector<SolvedColumn> columns;
  if (place.field().name == "relative_pivots") {
    for (std::size_t i = 0; i < count; ++i) columns.push_back(pivot(i, entries[place.first + i]));
    return columns;
  }
  const std::vector<Real> side = driven_bias();
  if (side.empty()) return {};
  std::vector<Real> x;
  for (const auto& [name, size] :
       {std::pair("acceleration", n), std::pair("multipliers", side.size() - n)}) {
    const std::size_t first = first_entry_of(*place.function, name);
    for (std::size_t i = 0; i < size; ++i) x.push_back(entries[first + i].value);
  }
  SolvedColumn& column = columns.emplace_back(SolvedColumn{{}, {}, bound(x, side)});
  const std::size_t first = place.field().name == "multipliers" ? n : 0;
  for (std::size_t i = 0; i < count; ++i) {
    column.entries.push_back(i);
    column.weights.push_back(matrix()->weights[first + i]);
  }
  return columns;
}

std::vector<SolvedColumn> SolutionBounds::derivative_columns(const FieldPlace& place,
                                                             const std::vector<Bound>& entries) {
  const std::size_t n = state_.v.size();
  const std::size_t width = place.field().columns;
  // Of a linearization the rates of positions come first, which nothing is solved for.
  const std::size_t above = place.field().rows - n;
  std::vector<SolvedColumn> columns;
  for (std::size_t k = 0; k < width; ++k) {
    const std::vector<Real> side = right_side(place, k);
    if (side.empty()) return {};
    SolvedColumn column{{}, matrix()->weights, {}};
    std::vector<Real> x;
    for (std::size_t i = 0; i < n; ++i) {
      column.entries.push_back((above + i) * width + k);
      x.push_back(entries[place.first + column.entries.back()].value);
    }
    column.bound = bound(x, side);
    columns.push_back(std::move(column));
  }
  return columns;
}

std::vector<SolvedColumn> SolutionBounds::columns(const FieldPlace& place,
                                                  const std::vector<Bound>& entries) {
  const OutputRow& output = output_row(place.request.kind);
  const bool is_told = output.gives_pivots || model_.constraints.empty();
  if (!output.solves || !is_told || matrix() == nullptr) return {};
  return output.gives_pivots ? motion_columns(place, entries) : derivative_columns(place, entries);
}

}  // namespace elgen
