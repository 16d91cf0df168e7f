// The backward error of an LDL^T solve, times the condition number, as an error bound of
// accelerations. Norms are taken in long double, whose range holds the squares of rates of 1e300.
#include "forward_accuracy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <eigen3/Eigen/Eigenvalues>
#include <type_traits>

#include "own_bound.hpp"
#include "tally.hpp"

namespace elgen {
namespace {

/// Beyond cond u = 0.1 not one digit is promised.
constexpr double largest_condition_error = 0.1;

using Number = long double;
using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;

Number number(const Real& x) { return ScalarTraits<long double>::from_real(x.value()); }

Vector vector_of(const std::vector<Real>& values, Eigen::Index size) {
  Vector result(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    result(i) = number(values[static_cast<std::size_t>(i)]);
  }
  return result;
}

Matrix matrix_of(const std::vector<Real>& values, Eigen::Index size) {
  Matrix result(size, size);
  for (Eigen::Index i = 0; i < size * size; ++i) {
    result(i / size, i % size) = number(values[static_cast<std::size_t>(i)]);
  }
  return result;
}

std::vector<Real> values_of(const BoundedRun& run) {
  std::vector<Real> result;
  for (const Bound& entry : run.entries) result.push_back(entry.value);
  return result;
}

std::vector<Real> bounds_of(const BoundedRun& run) {
  std::vector<Real> result;
  for (const Bound& entry : run.entries) result.push_back(entry.bound);
  return result;
}

/// What the formula is made of, at one state.
struct Terms {
  Matrix mass;
  Matrix mass_bound;
  Vector right_bound;
  Vector exact;  ///< a*
};

/// B_r = B_bias + B_B |u|
void add_input_bound(Vector& bound, const BoundedRun& matrix, const State& state) {
  const std::size_t inputs = state.u.size();
  for (std::size_t i = 0; i < matrix.entries.size(); ++i) {
    const Real u(cln::abs(state.u[i % inputs]));
    bound(static_cast<Eigen::Index>(i / inputs)) += number(matrix.entries[i].bound * u);
  }
}

/// None where a part is undefined or overflows, or M has a diagonal entry that is not positive.
template <class Scalar>
std::optional<Terms> terms_at(const Program& program, const State& state) {
  const auto run = [&](OutputKind kind) {
    return bounded_run<Scalar>(program, *find_function(program, kind), state);
  };
  const BoundedRun mass = run(OutputKind::mass_matrix);
  const BoundedRun bias = run(OutputKind::bias);
  const BoundedRun solution = run(OutputKind::forward_dynamics);
  const bool solved =
      solution.regime == Regime::regular || solution.regime == Regime::ill_conditioned;
  if (mass.regime != Regime::regular || bias.regime != Regime::regular || !solved) return {};
  const auto n = static_cast<Eigen::Index>(state.q.size());
  Terms terms{matrix_of(values_of(mass), n), matrix_of(bounds_of(mass), n),
              vector_of(bounds_of(bias), n), vector_of(values_of(solution), n)};
  if (terms.mass.diagonal().minCoeff() <= 0) return {};
  if (!state.u.empty()) add_input_bound(terms.right_bound, run(OutputKind::input_matrix), state);
  return terms;
}

/// The ratio of both sides; none where the condition promises nothing.
template <class Scalar>
std::optional<double> figure_at(const Terms& terms, const std::vector<Scalar>& computed) {
  const Eigen::Index n = terms.exact.size();
  const Vector root = terms.mass.diagonal().cwiseSqrt();
  const Vector inverse = root.cwiseInverse();
  const Matrix scaled = inverse.asDiagonal() * terms.mass * inverse.asDiagonal();
  const Vector eigenvalues =
      Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  const Number u = std::numeric_limits<Scalar>::epsilon() / Number(2);
  const Number condition = eigenvalues(n - 1) / eigenvalues(0);
  if (!(eigenvalues(0) > 0) || condition * u > largest_condition_error) return std::nullopt;
  Vector error(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    error(i) = static_cast<Number>(computed[static_cast<std::size_t>(i)]) - terms.exact(i);
  }
  const Matrix scaled_bound = inverse.asDiagonal() * terms.mass_bound * inverse.asDiagonal();
  const Number factor = static_cast<Number>(64 * n) + 8 * scaled_bound.norm();
  const Number allowed = u * condition *
                         (factor * root.cwiseProduct(terms.exact).norm() +
                          8 * inverse.cwiseProduct(terms.right_bound).norm());
  const Number actual = root.cwiseProduct(error).norm();
  return actual == 0 ? 0.0 : static_cast<double>(actual / allowed);
}

bool is_available(const Subject& subject) {
  const auto has = [&](OutputKind kind) { return find_function(subject.program, kind) != nullptr; };
  return has(OutputKind::forward_dynamics) && has(OutputKind::mass_matrix) &&
         has(OutputKind::bias) && (subject.model.inputs.empty() || has(OutputKind::input_matrix));
}

CertificateRow row_of(const Subject& subject, const Tally& tally, const char* scalar) {
  CertificateRow row;
  row.check = "acceleration by condition";
  row.subject = fmt::format(
      "{} ({})", find_function(subject.program, OutputKind::forward_dynamics)->name, scalar);
  row.formula =
      "|D^1/2 (a - a*)| / (u cond ((64 n + 8 |D^-1/2 B_M D^-1/2|) |D^1/2 a*| + "
      "8 |D^-1/2 B_r|))";
  row.samples = tally.samples();
  row.worst = fmt::format("{:.2g} of the bound; {} without one", tally.worst(), tally.skipped());
  row.where = tally.where(subject);
  row.tolerance = "1: backward error of L D L^T times cond; skipped where cond u > 0.1";
  row.verdict = tally.verdict(1);
  return row;
}

}  // namespace

template <class Scalar>
std::optional<CertificateRow> check_forward_accuracy(
    const Subject& subject, const std::vector<SampledState<Scalar>>& states) {
  if (!is_available(subject)) return std::nullopt;
  const Function& function = *find_function(subject.program, OutputKind::forward_dynamics);
  Tally tally;
  for (const SampledState<Scalar>& sample : states) {
    const State state = exact_state(subject, sample.values);
    const std::optional<Terms> terms = terms_at<Scalar>(subject.program, state);
    const auto figure = terms
                            ? figure_at(*terms, evaluate(subject.program, function, sample.values))
                            : std::nullopt;
    if (figure) {
      tally.add(*figure, state);
    } else {
      tally.skip();
    }
  }
  return row_of(subject, tally, std::is_same_v<Scalar, float> ? "float" : "double");
}

template std::optional<CertificateRow> check_forward_accuracy(
    const Subject&, const std::vector<SampledState<double>>&);
template std::optional<CertificateRow> check_forward_accuracy(
    const Subject&, const std::vector<SampledState<float>>&);

}  // namespace elgen
