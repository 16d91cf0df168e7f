// Computes K and R at one state, if needed. Weights of solved columns come from the oracle.
#include "verify/bounds/loss.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "elgen/outputs.hpp"

namespace elgen {
namespace {

/// The entries of D^1/2, D the diagonal of M; empty if an entry of D is not positive.
std::vector<Real> sqrt_of_mass_diagonal(OracleCache& oracle) {
  std::vector<Real> roots;
  for (const cln::cl_R& entry : oracle.diagonal_of_mass()) {
    if (!cln::plusp(entry)) return {};
    roots.push_back(sqrt(Real(entry)));
  }
  return roots;
}

/// The lengths of the rows of A D^-1/2; empty if A is undefined. `roots`: D^1/2.
std::vector<Real> jacobian_row_norms(const std::vector<Real>& roots, OracleCache& oracle) {
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

/// In u of the entry: an error of 2 u, or 0.3 digits, counts as no loss.
constexpr double negligible_loss = 2;
/// Each K costs one sweep over the function. The result limits the groups of a field, and the
/// entries of a group, that have a K: at most 16, in functions of more than 2^13 instructions
/// fewer, at least 4. So the cost stays linear in the length of the function.
std::size_t most_sweeps(const Function& function) {
  constexpr std::size_t most_instructions = 1 << 17;  // of 16 sweeps
  return std::clamp<std::size_t>(most_instructions / (function.instructions.size() + 1), 4, 16);
}

/// The positions in the column of the largest |w_i x_i|, at most `most` of them.
std::vector<std::size_t> largest_entries(const SolvedColumn& column,
                                         const std::vector<Real>& values, std::size_t most) {
  std::vector<Real> sizes;
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < column.entries.size(); ++i) {
    sizes.push_back(abs(values[column.entries[i]] * column.weights[i]));
    positions.push_back(i);
  }
  if (positions.size() <= most) return positions;
  std::ranges::stable_sort(positions,
                           [&](std::size_t i, std::size_t j) { return sizes[j] < sizes[i]; });
  positions.resize(most);
  return positions;
}

/// True for each constant of the program that may depend on parameters fixed by the scene: the
/// rounding of such a constant counts in K. False for literals of the model, powers of two, and
/// irrational constants if no fixed parameter has an irrational value.
std::vector<bool> mark_fixed_constants(const Model& model, const Scene& scene,
                                       const Program& program) {
  const FixedParameters& fixed = scene.specialisation.fixed;
  if (fixed.empty()) return {};
  const bool has_irrational = std::ranges::any_of(
      fixed, [](const auto& x) { return x.second.exact_expression.has_value(); });
  std::set<cln::cl_R> literals;
  for (const Expression& x : model.expressions) {
    if (x.kind == ExpressionKind::number) literals.insert(cln::abs(x.number));
  }
  std::vector<bool> result;
  for (const Constant& constant : program.constants) {
    const cln::cl_R magnitude = cln::abs(constant.value);
    const bool is_literal = literals.contains(magnitude) || is_power_of_two(Real(magnitude));
    result.push_back(!is_literal && (has_irrational || is_rational(constant)));
  }
  return result;
}

}  // namespace

std::vector<SolvedColumn> solved_columns(const ComparedField& place, OracleCache& oracle) {
  const OutputRow& output = output_row(place.request.kind);
  const Field& field = place.field();
  const bool is_multiplier = field.name == "multipliers";
  const bool is_acceleration = place.row().name == "acceleration" || output.differentiates;
  if (!output.solves_mass_matrix || !(is_multiplier || is_acceleration)) return {};
  std::vector<Real> weights = sqrt_of_mass_diagonal(oracle);
  if (is_multiplier && !weights.empty()) weights = jacobian_row_norms(weights, oracle);
  if (weights.empty()) return {};
  // In a linearisation, the rows of dq/dt come first; they are not solved for.
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

Real weighted_norm(const SolvedColumn& column, const std::vector<Real>& values) {
  Real square;
  for (std::size_t i = 0; i < column.entries.size(); ++i) {
    const Real weighted = values[column.entries[i]] * column.weights[i];
    square = square + weighted * weighted;
  }
  return sqrt(square);
}

LossMeter::LossMeter(const SystemUnderTest& subject, OracleCache& oracle,
                     const RoundingConstants<Real>& rounding, double least)
    : subject_(subject),
      oracle_(oracle),
      rounding_(rounding),
      min_loss_(least),
      depends_on_fixed_(mark_fixed_constants(subject.model, subject.scene, subject.program)) {}

/// K = sum |z dx/dz| over the inputs z of the function, for one entry x of the field.
Real LossMeter::conditioning(const ComparedField& place, const ExactRun& run, std::size_t entry) {
  std::unique_ptr<Conditioning>& known = conditioning_[place.function];
  if (known == nullptr) {
    known = std::make_unique<Conditioning>(subject_.program, *place.function, values_of(run.values),
                                           depends_on_fixed_);
  }
  return known->absolute_condition(place.field().entries[entry]);
}

bool LossMeter::has_accurate_angles() const {
  static const Real known(cln::cl_RA(1) / 1000);
  const State& state = oracle_.state();
  for (std::size_t i = 0; i < state.q.size(); ++i) {
    const bool turns = is_angle(subject_.model.coordinates[i]);
    if (turns && abs(Real(state.q[i])) * rounding_.roundoff > known) return false;
  }
  return true;
}

/// The groups of a field: single entries, and solved columns if a loss may exceed negligible_loss
/// and min_loss_.
auto LossMeter::group_entries(const ComparedField& place, const std::vector<Real>& errors,
                              const std::vector<Real>& exact) -> std::vector<LossGroup> {
  std::vector<double> most;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    most.push_back(error_in_roundoffs(errors[i], abs(exact[i]), rounding_));
  }
  std::vector<SolvedColumn> columns;
  const double counted = std::max(negligible_loss, min_loss_);
  if (std::ranges::any_of(most, [=](double figure) { return figure > counted; })) {
    columns = solved_columns(place, oracle_);
  }
  std::vector<bool> is_solved(errors.size());
  for (const SolvedColumn& column : columns) {
    for (const std::size_t entry : column.entries) is_solved[entry] = true;
  }
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!is_solved[i]) columns.push_back({{i}, {Real(1)}});
  }
  std::vector<LossGroup> result;
  for (SolvedColumn& column : columns) {
    const std::size_t entry = *std::ranges::max_element(column.entries, std::less(),
                                                        [&most](std::size_t i) { return most[i]; });
    result.push_back({std::move(column), most[entry], entry});
  }
  return result;
}

/// The loss of a group in u R, or group.max_loss if this bound is negligible; 0 if R is undefined.
/// In long columns, only the largest entries have a K, so the result is an upper bound. None if R
/// is at most 1e-45 of E, because such an R may be a rounding error of the exact values.
std::optional<double> LossMeter::group_loss(const ComparedField& place, const ExactRun& run,
                                            const LossGroup& group, const std::vector<Real>& errors,
                                            const std::vector<Real>& exact) {
  static const Real negligible(power_of_ten(-45));
  if (group.max_loss <= negligible_loss) return group.max_loss;
  std::vector<Real> references(errors.size());
  std::vector<Real> roundings(errors.size());
  for (const std::size_t i : largest_entries(group.column, exact, most_sweeps(*place.function))) {
    const std::size_t entry = group.column.entries[i];
    references[entry] = conditioning(place, run, entry);
  }
  for (const std::size_t entry : group.column.entries) {
    references[entry] = references[entry] + abs(exact[entry]);
    roundings[entry] = run.entries[place.first_entry + entry].error;
  }
  const Real reference = weighted_norm(group.column, references);
  if (!reference.is_defined()) return 0;
  if (reference <= weighted_norm(group.column, roundings) * negligible) return std::nullopt;
  return error_in_roundoffs(weighted_norm(group.column, errors), reference, rounding_);
}

LostEntry LossMeter::loss_of_largest_entry(const std::vector<Real>& errors,
                                           const std::vector<Real>& exact) const {
  const auto largest = std::ranges::max_element(errors, std::less());
  Real value;
  for (const Real& x : exact) value = max(value, abs(x));
  if (largest == errors.end() || !(value > Real())) return {};
  return {error_in_roundoffs(*largest, value, rounding_),
          static_cast<std::size_t>(largest - errors.begin())};
}

Loss LossMeter::field_loss(const ComparedField& place, const ExactRun& run,
                           const std::vector<Real>& errors, const std::vector<Real>& exact) {
  Loss loss{{}, loss_of_largest_entry(errors, exact), 0};
  std::vector<LossGroup> all = group_entries(place, errors, exact);
  std::ranges::sort(all, std::ranges::greater(), &LossGroup::max_loss);
  std::size_t sweeps = 0;
  for (const LossGroup& group : all) {
    if (group.max_loss <= std::max(loss.relative_to_entry.loss, min_loss_)) break;
    // Without K, R is |x*|, so the figure is an upper bound of the loss.
    if (std::isfinite(group.max_loss) && sweeps++ >= most_sweeps(*place.function)) {
      loss.relative_to_entry = {group.max_loss, group.entry};
      break;
    }
    const std::optional<double> figure = group_loss(place, run, group, errors, exact);
    if (!figure) ++loss.entries_without_reference;
    if (figure.value_or(0) > loss.relative_to_entry.loss)
      loss.relative_to_entry = {*figure, group.entry};
  }
  return loss;
}

}  // namespace elgen
