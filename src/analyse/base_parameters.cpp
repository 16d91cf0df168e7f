// base_parameters: the reduced echelon form of the regressor Y at many states, over residues, else
// in 160 digits.
#include "elgen/base_parameters.hpp"

#include <cln/float.h>

#include <algorithm>

#include "analyse/residues.hpp"
#include "model/requests.hpp"
#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"
#include "program/evaluate/subject.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_MI;
using cln::cl_R;

constexpr std::uint64_t seed_of_states = 1;

/// Digits of floats beyond the 64 of Real. Entries below zero_threshold() count as 0.
constexpr unsigned more_digits = 96;
const cl_R& zero_threshold() {
  static const cl_R value = power_of_ten(-100);
  return value;
}

/// Elimination over residues. The pivot is in the first row with a non-zero entry.
struct ResidueField {
  using Number = cl_MI;
  static constexpr EchelonForm form = EchelonForm::reduced;

  [[nodiscard]] static cl_MI integer(int value) { return residue_field()->canonhom(value); }
  [[nodiscard]] static cl_MI negate(const cl_MI& x) { return -x; }
  [[nodiscard]] static cl_MI multiply(const cl_MI& x, const cl_MI& y) { return x * y; }
  [[nodiscard]] static cl_MI divide(const cl_MI& x, const cl_MI& y) { return x * cln::recip(y); }
  [[nodiscard]] static cl_MI subtract_product(const cl_MI& x, const cl_MI& factor, const cl_MI& y) {
    return x - factor * y;
  }
  [[nodiscard]] static bool is_zero(const cl_MI& x) { return cln::zerop(x); }
  [[nodiscard]] static bool is_defined(const cl_MI&) { return true; }
  [[nodiscard]] static const PivotCandidate<cl_MI>* best_pivot(
      const std::vector<PivotCandidate<cl_MI>>& candidates, std::size_t) {
    return &candidates.front();
  }
};

/// The number of states: enough for twice as many rows as columns, plus 8 states for columns that
/// are 0 in most rows.
std::size_t state_count(std::size_t rows, std::size_t columns) {
  return 2 * (columns + rows - 1) / rows + 8;
}

/// The number of entries of Y, which is the first field of the regressor.
std::size_t matrix_entry_count(const Function& regressor) {
  return regressor.fields.front().entries.size();
}

/// Stores the rows of an echelon form as base parameters. `number` converts a factor to a real
/// number. Returns false if `number` returns none for a factor.
template <class Field, class ToNumber>
bool store_base_parameters(const Echelon<Field>& echelon, const ToNumber& number,
                           BaseParameters& found) {
  std::vector<bool> has_effect(found.parameters.size());
  for (const auto& pivot : echelon.pivots()) {
    BaseParameter& base = found.base.emplace_back();
    base.parameter = static_cast<std::uint32_t>(pivot.column);
    has_effect[pivot.column] = true;
    for (const auto& entry : echelon.row_without_pivot(pivot)) {
      const std::optional<cl_R> factor = number(entry.value);
      if (!factor) return false;
      base.regrouped_terms.push_back({static_cast<std::uint32_t>(entry.column), *factor});
      has_effect[entry.column] = true;
    }
  }
  for (std::uint32_t k = 0; k < has_effect.size(); ++k) {
    if (!has_effect[k]) found.unidentifiable.push_back(k);
  }
  return true;
}

/// Finds exact base parameters. Returns false if an entry of Y has no residue, or if a factor is
/// not rational.
bool find_by_residues(const CheckedModel& checked, const Program& program,
                      const Function& regressor, BaseParameters& found) {
  Sampler draw(seed_of_states);
  std::vector<cl_MI> matrix;
  for (std::size_t i = 0; i < found.states; ++i) {
    const std::vector<Residue> entries = sample_residues(checked.model, program, regressor, draw);
    for (std::size_t k = 0; k < matrix_entry_count(regressor); ++k) {
      if (!entries[k].value) return false;
      matrix.push_back(*entries[k].value);
    }
  }
  ResidueField field;
  const std::size_t columns = found.parameters.size();
  BaseParameters exact = found;
  exact.is_exact = true;
  const bool are_rational = store_base_parameters(
      Echelon<ResidueField>(field, matrix, columns, columns),
      [](const cl_MI& factor) -> std::optional<cl_R> { return reconstruct_rational(factor); },
      exact);
  if (are_rational) found = std::move(exact);
  return are_rational;
}

/// The rows of Y at `state` in floats of 160 digits, each scaled to a largest entry of 1. None if Y
/// has no value at the state.
std::optional<std::vector<cl_R>> regressor_rows(const CheckedModel& checked, const Program& program,
                                                const Function& regressor, const State& state) {
  static const cln::float_format_t digits = cln::float_format(64 + more_digits);
  const OracleValues values =
      to_oracle_values(evaluate(program, regressor, arguments_at<Real>(state)));
  if (!values) return std::nullopt;
  const std::size_t columns = matrix_entry_count(regressor) / checked.model.velocities.size();
  std::vector<cl_R> rows(values->begin(), values->begin() + static_cast<std::ptrdiff_t>(
                                                                matrix_entry_count(regressor)));
  for (std::size_t first = 0; first < rows.size(); first += columns) {
    cl_R largest = 0;
    for (std::size_t k = 0; k < columns; ++k)
      largest = cln::max(largest, cln::abs(rows[first + k]));
    for (std::size_t k = 0; k < columns; ++k) {
      cl_R& entry = rows[first + k];
      if (!cln::zerop(largest)) entry = cln::cl_float(entry, digits) / largest;
    }
  }
  return rows;
}

bool find_by_samples(const CheckedModel& checked, const Program& program, const Function& regressor,
                     BaseParameters& found) {
  constexpr std::size_t draws_per_state = 20;
  Sampler draw(seed_of_states);
  std::vector<cl_R> matrix;
  const std::size_t columns = found.parameters.size();
  const std::size_t wanted = found.states * matrix_entry_count(regressor);
  for (std::size_t i = 0; i < draws_per_state * found.states && matrix.size() < wanted; ++i) {
    State state = nominal_state(checked.model, checked.scene);
    draw_motion(checked.model, draw, 0, state);
    const auto rows = regressor_rows(checked, program, regressor, state);
    if (rows) matrix.insert(matrix.end(), rows->begin(), rows->end());
  }
  if (matrix.size() < wanted) return false;
  LargestPivot<cl_R, EchelonForm::reduced> field(zero_threshold(), zero_threshold());
  return store_base_parameters(
      Echelon<LargestPivot<cl_R, EchelonForm::reduced>>(field, matrix, columns, columns),
      [](const cl_R& factor) { return std::optional(factor); }, found);
}

/// Sets the value pi_k + sum factor pi_j of each base parameter, if all parameters have values.
void add_values(const CheckedModel& checked, BaseParameters& found) {
  const OracleValues values =
      oracle_values(checked.model, {.kind = OutputKind::regressor_parameters},
                    nominal_state(checked.model, checked.scene));
  if (!values) return;
  for (BaseParameter& base : found.base) {
    base.value = (*values)[base.parameter];
    for (const WeightedParameter& other : base.regrouped_terms) {
      base.value = base.value + other.factor * (*values)[other.parameter];
    }
  }
}

}  // namespace

std::vector<OutputRequest> outputs_for_base_parameters(const Model& model) {
  return available_requests(model, {OutputKind::regressor});
}

Result<BaseParameters> find_base_parameters(const AnalysisInput& input) {
  const CheckedModel& checked = input.checked;
  const Function* const regressor = find_function(input.recursive, OutputKind::regressor);
  if (regressor == nullptr) {
    Report report;
    (void)require_request(checked.model, "regressor", checked.model.name_span, report);
    return report.sorted_diagnostics();
  }
  BaseParameters found{inertial_parameters(checked.model)};
  found.states = state_count(checked.model.velocities.size(), found.parameters.size());
  const bool is_found = find_by_residues(checked, input.recursive, *regressor, found) ||
                        with_digits(more_digits, [&] {
                          return find_by_samples(checked, input.recursive, *regressor, found);
                        });
  if (!is_found) {
    return Diagnostic{
        Code::E521, checked.model.name_span,
        "the regressor has no value at states that are drawn in the ranges of the model"};
  }
  add_values(checked, found);
  return {std::move(found), {}};
}

}  // namespace elgen
