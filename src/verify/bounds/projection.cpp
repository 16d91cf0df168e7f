// Compares projections with the oracle's contractions. With up to four coordinates, relative pivots
// and accelerations come from the oracle's own solution. With more coordinates, they come from the
// program: from OracleCache::mass_of_program(), and from its accelerations, which other rows of the
// certificate compare. With constraints the oracle solves the equations, because few outputs return
// the multipliers.
#include "verify/bounds/projection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "elgen/certificate.hpp"
#include "elgen/outputs.hpp"
#include "model/elimination.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using RealNumbers = std::vector<cl_R>;

Mismatch make_mismatch(const std::string& what, const Real& value, const cl_R& truth) {
  return {fmt::format("{} is {}, the oracle says {}", what, short_text(value),
                      short_number_text(truth)),
          value, Real(truth)};
}

/// Compares the projected left and right side of an equation, both computed by the oracle.
Mismatch compare_forces(const std::string& what, const cl_R& left, const cl_R& right,
                        OracleCache& oracle) {
  const RunningValue<Real> sum{Real(left), Real(cln::abs(left) + cln::abs(right))};
  if (agrees_with_oracle(sum, right, oracle)) return {};
  return make_mismatch(what, sum.value, right);
}

/// The relative pivots of M = `mass` in the model's order of elimination; none if M is undefined or
/// singular.
OracleValues pivots_of_mass(const Model& model, OracleValues mass) {
  if (!mass) return std::nullopt;
  const bool last_first = eliminates_backward(model);
  if (last_first) std::ranges::reverse(*mass);
  OracleValues pivots = oracle_relative_pivots(std::move(*mass), model.velocities.size());
  if (last_first && pivots) std::ranges::reverse(*pivots);
  return pivots;
}

/// Compares one field at one state.
class ProjectionComparison {
 public:
  ProjectionComparison(const SystemUnderTest& subject, const ComparedField& place,
                       const ExactRun& run, OracleCache& oracle, Sampler& draw)
      : subject_(subject), place_(place), run_(run), oracle_(oracle), sampler_(draw) {}

  std::optional<Mismatch> compare() {
    const OutputRow& output = output_row(place_.request.kind);
    const bool is_motion =
        output.solves_mass_matrix && (output.gives_pivots || output.differentiates);
    if (!is_motion || !subject_.model.constraints.empty()) {
      return compare_contraction(place_.field().rows);
    }
    if (!output.gives_pivots) return compare_response();
    const bool is_acceleration = row().name == "acceleration";
    return is_acceleration ? compare_acceleration() : compare_pivots();
  }

 private:
  [[nodiscard]] const State& state() const { return oracle_.state(); }
  [[nodiscard]] const RunningValue<Real>& entry(std::size_t i) const {
    return run_.entries[place_.first_entry + i];
  }
  [[nodiscard]] const FieldRow& row() const { return place_.row(); }

  /// Compares the contraction of the first `rows` rows of the field.
  std::optional<Mismatch> compare_contraction(std::size_t rows) {
    const Field& field = place_.field();
    if (field.entries.empty()) return Mismatch();
    Contraction by{sampler_.vector(rows), {}, place_.request_field_index};
    by.w.resize(field.rows, cl_R(0));
    const bool is_matrix = is_matrix_field(row()) || field.columns > 1;
    if (is_matrix) by.y = sampler_.vector(field.columns);
    const RunningValue<Real> sum =
        contract(std::span(run_.entries).subspan(place_.first_entry), by);
    const auto truth = oracle_.contraction(place_.request, by);
    if (!truth) return std::nullopt;
    if (agrees_with_oracle(sum, *truth, oracle_)) return Mismatch();
    const std::string of_field = field.name.empty() ? "" : " of " + field.name;
    return make_mismatch((is_matrix ? "w.X y" : "w.x") + of_field, sum.value, *truth);
  }

  /// The mismatch of an undefined entry, called `what`; none if the oracle has no value.
  std::optional<Mismatch> compare_undefined(const std::string& what) {
    const OracleValues& truth = oracle_.values(place_.request);
    if (!truth) return std::nullopt;
    return make_mismatch(what, Real::undefined(), truth->front());
  }

  /// The accelerations, which come first in forward dynamics: the program's, which other rows
  /// compare, or the oracle's.
  OracleValues accelerations() {
    constexpr OutputKind kind = OutputKind::forward_dynamics;
    const Function* const function = find_function(subject_.program, kind);
    if (function == nullptr || is_solved_by_oracle(subject_.model))
      return oracle_.values({.kind = kind});
    return to_oracle_values(evaluate(subject_.program, *function, arguments_at<Real>(state())));
  }

  /// w.B y; 0 if y is empty.
  [[nodiscard]] std::optional<cl_R> input_force(const RealNumbers& w, const RealNumbers& y) const {
    if (y.empty()) return cl_R(0);
    return oracle_.contraction({.kind = OutputKind::input_matrix}, {w, y});
  }

  std::optional<Mismatch> compare_acceleration() {
    const std::size_t n = state().v.size();
    State moving = state();
    for (std::size_t i = 0; i < n; ++i) {
      if (!entry(i).value.is_defined()) return compare_undefined("an acceleration");
      moving.a[i] = entry(i).value.value();
    }
    const RealNumbers w = sampler_.vector(n);
    const auto force =
        oracle_contraction(subject_.model, {.kind = OutputKind::inverse_dynamics}, moving, {w});
    const auto driven = input_force(w, state().u);
    if (!force || !driven) return std::nullopt;
    return compare_forces("w.(M a + bias)", *force, *driven, oracle_);
  }

  std::optional<Mismatch> compare_pivots() {
    const OracleValues& mass = oracle_.mass_of_program();
    const OracleValues pivots = pivots_of_mass(
        subject_.model, mass ? mass : oracle_.values({.kind = OutputKind::mass_matrix}));
    if (!pivots) return std::nullopt;
    for (std::size_t i = 0; i < pivots->size(); ++i) {
      const Real truth((*pivots)[i]);
      // The scale of rounding errors is 1, because a pivot is relative to a diagonal entry. The
      // running error is set to |truth|, because pivots of an indefinite M may have any magnitude.
      if (agrees({entry(i).value, abs(truth)}, truth, Real(1))) continue;
      return make_mismatch("a relative pivot", entry(i).value, (*pivots)[i]);
    }
    return Mismatch();
  }

  /// X y, without the rows above the accelerations; none if an entry is undefined.
  [[nodiscard]] OracleValues contracted_response(const RealNumbers& y) const {
    const std::size_t n = state().v.size();
    const std::size_t above = place_.field().rows - n;
    std::vector<Real> z(n);
    for (std::size_t i = 0; i < n; ++i) {
      Real& sum = z[i];
      for (std::size_t k = 0; k < y.size(); ++k) {
        sum = sum + entry((above + i) * y.size() + k).value * Real(y[k]);
      }
    }
    return to_oracle_values(z);
  }

  /// The right side of w.M z = ..., in which z = X y is the response to changes y of the columns'
  /// variables.
  std::optional<cl_R> response_force(const RealNumbers& w, const RealNumbers& y) {
    const std::optional<FieldLine> column = line_at(subject_.model, row().columns, 0);
    if (column && column->leaf == Opcode::input) return input_force(w, y);
    const OracleValues solution = accelerations();
    if (!solution) return std::nullopt;
    State moving = state();
    std::copy_n(solution->begin(), w.size(), moving.a.begin());
    const auto n = static_cast<std::ptrdiff_t>(w.size());
    const RealNumbers rest(w.size(), cl_R(0));
    const bool by_velocity = row().name == "by_velocity";
    const bool by_rates = by_velocity || y.size() > w.size();  // y changes velocities
    const RealNumbers x = by_velocity ? rest : RealNumbers(y.begin(), y.begin() + n);
    const RealNumbers rates = by_rates ? RealNumbers(y.end() - n, y.end()) : rest;
    const auto slope = oracle_residual_slope(subject_.model, moving, w, x, rates);
    return slope ? std::optional<cl_R>(-*slope) : std::nullopt;
  }

  std::optional<Mismatch> compare_response() {
    const Field& field = place_.field();
    if (field.entries.empty()) return Mismatch();
    const std::size_t n = state().v.size();
    const RealNumbers w = sampler_.vector(n);
    const RealNumbers y = sampler_.vector(field.columns);
    const auto z = contracted_response(y);
    if (!z) return compare_undefined("a derivative");
    const OutputRequest mass{.kind = OutputKind::mass_matrix};
    const auto left = oracle_.contraction(mass, {w, *z});
    const auto right = response_force(w, y);
    if (!left || !right) return std::nullopt;
    const Mismatch wrong = compare_forces("w.M (X y) of " + field.name, *left, *right, oracle_);
    // The rows above the accelerations are not solved for, so they are compared directly.
    if (wrong.text.empty() && field.rows > n) return compare_contraction(n);
    return wrong;
  }

  const SystemUnderTest& subject_;
  const ComparedField& place_;
  const ExactRun& run_;
  OracleCache& oracle_;
  Sampler& sampler_;
};

}  // namespace

std::optional<Mismatch> compare_projection(const SystemUnderTest& subject,
                                           const ComparedField& place, const ExactRun& run,
                                           OracleCache& oracle, Sampler& draw) {
  return ProjectionComparison(subject, place, run, oracle, draw).compare();
}

bool is_projected_once(const ComparedField& place, const Model& model) {
  // M takes n evaluations of inverse dynamics, or n^2/18 expansions of the energies.
  constexpr std::size_t most_velocities = 20;
  return model.velocities.size() > most_velocities && place.row().name == "relative_pivots";
}

}  // namespace elgen
