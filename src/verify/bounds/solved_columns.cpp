// Solved columns, weighed by the oracle's M and A.
#include "verify/bounds/solved_columns.hpp"

#include "elgen/outputs.hpp"

namespace elgen {
namespace {

/// D^1/2; empty where an entry is not positive.
std::vector<Real> roots_of_diagonal(OracleCache& oracle) {
  std::vector<Real> roots;
  for (const cln::cl_R& entry : oracle.diagonal_of_mass()) {
    if (!cln::plusp(entry)) return {};
    roots.push_back(sqrt(Real(entry)));
  }
  return roots;
}

/// The lengths of the rows of A D^-1/2; empty where A has no value.
std::vector<Real> lengths_of_rows(const std::vector<Real>& roots, OracleCache& oracle) {
  const OracleValues& jacobian = oracle.values({.kind = OutputKind::constraint_jacobian});
  if (!jacobian) return {};
  const std::size_t n = roots.size();
  std::vector<Real> lengths(jacobian->size() / n);
  for (std::size_t k = 0; k < jacobian->size(); ++k) {
    const Real scaled = Real((*jacobian)[k]) / roots[k % n];
    lengths[k / n] = lengths[k / n] + scaled * scaled;
  }
  for (Real& length : lengths) length = sqrt(length);
  return lengths;
}

}  // namespace

std::vector<SolvedColumn> solved_columns(const FieldPlace& place, OracleCache& oracle) {
  const OutputRow& output = output_row(place.request.kind);
  const Field& field = place.field();
  const bool is_multiplier = field.name == "multipliers";
  const bool is_acceleration = place.row().name == "acceleration" || output.differentiates;
  if (!output.solves || !(is_multiplier || is_acceleration)) return {};
  std::vector<Real> weights = roots_of_diagonal(oracle);
  if (is_multiplier && !weights.empty()) weights = lengths_of_rows(weights, oracle);
  if (weights.empty()) return {};
  // A linearization begins with the rates of positions, which are not solved for.
  const std::size_t above = field.rows - weights.size();
  std::vector<SolvedColumn> columns(field.columns);
  for (std::size_t k = 0; k < field.columns; ++k) {
    columns[k].weights = weights;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      columns[k].entries.push_back((above + i) * field.columns + k);
    }
  }
  return columns;
}

Real norm(const SolvedColumn& column, const std::vector<Real>& values) {
  Real square;
  for (std::size_t i = 0; i < column.entries.size(); ++i) {
    const Real weighted = values[column.entries[i]] * column.weights[i];
    square = square + weighted * weighted;
  }
  return sqrt(square);
}

}  // namespace elgen
