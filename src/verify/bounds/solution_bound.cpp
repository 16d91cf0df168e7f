// Solution bounds from the bounds of M, b and db/d(q, v, u).
#include "verify/bounds/solution_bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "check/names/requests.hpp"
#include "elgen/certificate.hpp"
#include "elgen/outputs.hpp"

namespace elgen {
namespace {

long double narrowed(const Real& x) { return ScalarTraits<long double>::from_real(x.value()); }

Real norm(const std::vector<Real>& values) {
  Real square;
  for (const Real& value : values) square = square + value * value;
  return sqrt(square);
}

/// cond of D^-1/2 M D^-1/2 in the 2-norm; none where it is not positive definite.
std::optional<Real> condition(const std::vector<Bound>& m, const std::vector<Real>& weights) {
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
  const long double least = solver.eigenvalues()(0);
  if (solver.info() != Eigen::Success || !(least > 0)) return std::nullopt;
  return Real(exact_value(static_cast<double>(solver.eigenvalues()(n - 1) / least)));
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
  if (differentiates) {
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

std::optional<SolutionBounds::Mass> SolutionBounds::measured_mass() {
  const BoundedRun* m = run(OutputKind::mass_matrix);
  if (m == nullptr || !is_known(*m)) return std::nullopt;
  const std::size_t n = state_.v.size();
  Mass mass;
  for (std::size_t i = 0; i < n; ++i) {
    const Real& diagonal = m->entries[i * n + i].value;
    if (!cln::plusp(diagonal.value())) return std::nullopt;
    mass.weights.push_back(sqrt(diagonal));
  }
  std::vector<Real> scaled;
  for (std::size_t k = 0; k < n * n; ++k) {
    scaled.push_back(covering_bound(m->entries[k]) / (mass.weights[k / n] * mass.weights[k % n]));
  }
  mass.uncertainty = norm(scaled);
  const auto condition_of_mass = condition(m->entries, mass.weights);
  if (!condition_of_mass) return std::nullopt;
  mass.condition = *condition_of_mass;
  const Real error = rounding_.roundoff * mass.condition;
  if (!is_small(error) || !is_small(error * Real(8) * mass.uncertainty)) return std::nullopt;
  return mass;
}

const SolutionBounds::Mass* SolutionBounds::mass() {
  if (!mass_) mass_ = measured_mass();
  return *mass_ ? &**mass_ : nullptr;
}

Real SolutionBounds::bound(const std::vector<Real>& x, const std::vector<Real>& right_side) const {
  const Mass& m = **mass_;
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
SolvedColumn SolutionBounds::pivot(std::size_t entry, const Bound& value) const {
  const Mass& m = **mass_;
  const Real n(cln::cl_I(static_cast<unsigned long>(m.weights.size())));
  return {{entry}, {Real(1)}, m.condition * (n + m.uncertainty) * abs(value.value)};
}

std::vector<Real> SolutionBounds::driven_bias() {
  const BoundedRun* bias = run(OutputKind::bias);
  const BoundedRun* input = run(OutputKind::input_matrix);
  const std::size_t inputs = state_.u.size();
  if (bias == nullptr || !is_known(*bias)) return {};
  if (inputs > 0 && (input == nullptr || !is_known(*input))) return {};
  std::vector<Real> bounds;
  for (std::size_t i = 0; i < bias->entries.size(); ++i) {
    Real sum = covering_bound(bias->entries[i]);
    for (std::size_t k = 0; k < inputs; ++k) {
      sum = sum + covering_bound(input->entries[i * inputs + k]) * abs(Real(state_.u[k]));
    }
    bounds.push_back(sum);
  }
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
  const BoundedRun* matrix = run(OutputKind::input_matrix);
  if (matrix == nullptr || !is_known(*matrix)) return {};
  return bounds_of(*matrix, input, state_.u.size());
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
    accelerations[i].bound = max(abs(values[i]), error / mass()->weights[i]);
  }
  BoundedRun derivatives = bounded_run(*parts_, *function, state_, rounding_, accelerations);
  if (!is_known(derivatives)) return nullptr;
  *inverse_derivatives_ = std::move(derivatives);
  return &**inverse_derivatives_;
}

bool SolutionBounds::inputs_act_everywhere_alike() const {
  const Function* matrix = find_function(*parts_, OutputKind::input_matrix);
  return matrix == nullptr || !depends_on_position(*matrix);
}

std::vector<Real> SolutionBounds::state_column(std::size_t first, std::size_t column) {
  const BoundedRun* derivatives = inverse_derivatives();
  if (derivatives == nullptr || (first == 0 && !inputs_act_everywhere_alike())) return {};
  const std::size_t n = state_.v.size();
  return bounds_of(*derivatives, first * n * n + column, n);
}

std::vector<Real> SolutionBounds::right_side(const FieldPlace& place, std::size_t column) {
  const std::size_t n = state_.v.size();
  const OutputRow& output = output_row(place.request.kind);
  if (!output.differentiates) return driven_bias();
  const FieldRow& field = output.fields[place.request_field];
  if (field.columns == Extent::inputs) return input_column(column);
  // A field has a column of every state, or of every position, or of every velocity.
  const bool is_of_state = field.columns == Extent::states;
  return is_of_state ? state_column(column / n, column % n)
                     : state_column(place.request_field, column);
}

std::vector<SolvedColumn> SolutionBounds::columns(const FieldPlace& place,
                                                  const std::vector<Bound>& entries) {
  if (!output_row(place.request.kind).solves || mass() == nullptr) return {};
  const std::size_t n = state_.v.size();
  std::vector<SolvedColumn> columns;
  if (output_row(place.request.kind).gives_pivots && place.request_field == 1) {
    for (std::size_t i = 0; i < n; ++i) columns.push_back(pivot(i, entries[i]));
    return columns;
  }
  const std::size_t width = place.field().columns;
  // Of a linearization the rates of positions come first, which nothing is solved for.
  const std::size_t above = place.field().rows - n;
  for (std::size_t k = 0; k < width; ++k) {
    const std::vector<Real> side = right_side(place, k);
    if (side.empty()) return {};
    SolvedColumn column{{}, mass()->weights, {}};
    std::vector<Real> x;
    for (std::size_t i = 0; i < n; ++i) {
      column.entries.push_back((above + i) * width + k);
      x.push_back(entries[column.entries.back()].value);
    }
    column.bound = bound(x, side);
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace elgen
