// Program against oracle: what the visits to all states say of each field, tallied.
#include "verify/bounds/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "elgen/outputs.hpp"
#include "elgen/scalars.hpp"
#include "verify/states/tally.hpp"

namespace elgen {
namespace {

constexpr const char* own_reason =
    "8 u B + N eta (own bound): B run along the program; n u B for n > 8 roundings in an entry";
constexpr const char* step_reason =
    "8 u B + N eta (own bound): B, every rounding of first order, run along the program";
constexpr const char* closed_reason =
    "8 u B + N eta: B of the closed form, own bound where the code underflows; n u B for n > 8 "
    "roundings in an entry";
constexpr const char* solution_reason =
    "8 u B + N eta in the norm of D^1/2 x, D = diag M: B = cond ((n + |D^-1/2 B_M D^-1/2|) |D^1/2 "
    "x*| + |D^-1/2 B_b|) of M x = b, cond of D^-1/2 M D^-1/2; beyond the ranges the code's own "
    "bound does too, where it is below a tenth of x; skipped where neither does, u cond or "
    "8 u cond |D^-1/2 B_M D^-1/2| > 0.1";
constexpr const char* constrained_reason =
    "8 u B + N eta in the norm of W (a, lambda), W = D^1/2, D = diag M, then the lengths of the "
    "rows "
    "of A D^-1/2: B = cond ((n + |W^-1 B_K W^-1|) |W x*| + |W^-1 B_b|) of K x = b, K = [M A^T; A "
    "0], cond of W^-1 K W^-1 times that of D^-1/2 M D^-1/2; beyond the ranges the code's own bound "
    "does too, where it is below a tenth of x; skipped where neither does, u cond or 8 u cond "
    "|W^-1 B_K W^-1| > 0.1";

/// One field of a function, and what was found of it so far.
struct FieldRecord {
  FieldPlace place = {};
  Tally errors = {};              ///< in u B
  Tally cancellation = {};        ///< B/|x|: how badly the physics cancels
  std::vector<double> ulps = {};  ///< at nominal states
  std::size_t compared = 0;       ///< states
  std::size_t in_norm = 0;        ///< of them, judged as solutions
  std::map<Regime, std::size_t> states = {};
  std::string mistake = {};  ///< the first that is wrong, and where
  std::string mistake_at = {};
};

void add(FieldRecord& record, const Finding& finding, const Subject& subject, const State& state) {
  ++record.states[finding.regime];
  if (record.mistake.empty() && !finding.mistake.empty()) {
    record.mistake = finding.mistake;
    record.mistake_at = describe(subject, state);
  }
  if (!finding.error) return;
  ++record.compared;
  record.in_norm += finding.in_norm ? 1 : 0;
  record.errors.add(*finding.error, state);
  record.cancellation.add(finding.cancellation, state);
  record.ulps.insert(record.ulps.end(), finding.ulps.begin(), finding.ulps.end());
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string figures(const FieldRecord& record) {
  if (record.compared == 0) return "no state to compare at";
  return fmt::format("{:.2g} u B; median {:.2g} ulp; cancellation {:.2g}", record.errors.worst(),
                     median(record.ulps), record.cancellation.worst());
}

std::vector<SkippedStates> skipped(const FieldRecord& record) {
  std::vector<SkippedStates> result;
  for (const auto& [regime, obstacle] :
       {std::pair(Regime::overflow, Obstacle::overflow),
        std::pair(Regime::undefined, Obstacle::undefined),
        std::pair(Regime::ill_conditioned, Obstacle::ill_conditioned),
        std::pair(Regime::unsettled, Obstacle::unsettled)}) {
    const auto found = record.states.find(regime);
    if (found != record.states.end()) result.push_back({obstacle, found->second});
  }
  return result;
}

/// By what judged, not by what was to.
std::string reason_of(const FieldRecord& record, const Model& model) {
  if (record.place.judge.is_closed_form) return closed_reason;
  if (output_row(record.place.request.kind).steps) return step_reason;
  if (record.in_norm == 0) return own_reason;
  const char* const by_norm = model.constraints.empty() ? solution_reason : constrained_reason;
  const std::size_t others = record.compared - record.in_norm;
  if (others == 0) return by_norm;
  return fmt::format("{}; at {} of the states {}", by_norm, others, own_reason);
}

constexpr const char* beyond_bounds =
    "; noted beyond, as a form that rounds badly is no wrong equation; NaN and infinity fail";

/// Rounding is noted, however far off a finite number is.
Verdict verdict_of_rounding(const Tally& errors) {
  const Verdict verdict = errors.verdict(promised_bounds);
  const bool is_rounding = verdict == Verdict::fails && std::isfinite(errors.worst());
  return is_rounding ? Verdict::noted : verdict;
}

/// The subject of a comparison, in words: the field, and the scalar.
std::string subject_of(const FieldPlace& place, std::string_view scalar) {
  const std::string& field = place.field().name;
  return fmt::format("{}{}{} ({})", place.function->name, field.empty() ? "" : ".", field, scalar);
}

CertificateRow row_of(const Subject& subject, const FieldRecord& record, std::string_view scalar,
                      const AccuracyOptions& options) {
  CertificateRow row;
  row.check = "program vs oracle";
  row.output = record.place.function->name;
  row.subject = subject_of(record.place, scalar);
  row.formula = options.visit.comparison == Comparison::entries
                    ? "|x - x*| / (u B); x* each entry"
                    : "|x - x*| / (u B); x* by one random projection";
  row.samples = record.compared;
  row.skipped = skipped(record);
  row.tolerance = reason_of(record, subject.model) + beyond_bounds;
  if (record.compared > 0) row.error = record.errors.worst();
  row.worst = figures(record);
  row.where = record.errors.where(subject);
  row.verdict = verdict_of_rounding(record.errors);
  if (!record.mistake.empty()) {
    row.worst = record.mistake;
    row.where = record.mistake_at;
    row.verdict = Verdict::fails;
  }
  return row;
}

/// As users compile: the code with optimisation, the machine's own instructions and contraction,
/// which rounds otherwise than what is written, measured by the same bounds. Of all fields, the
/// largest error, and whose it is.
class AsUsersRecord {
 public:
  /// `field`: "forward_dynamics.acceleration (double)"; `at` is the number of the state. Fields of
  /// one state come one after another.
  void add(const std::string& field, const Finding& finding, const State& state, std::size_t at);

  /// One row for all fields of a scalar.
  [[nodiscard]] CertificateRow row(const Subject& subject, std::string_view scalar) const;

 private:
  Tally errors_ = {};  ///< in u B
  std::set<std::string> fields_ = {};
  std::size_t states_ = 0;
  std::optional<std::size_t> last_ = {};  ///< of the states
  std::string worst_ = {};                ///< the field of the largest
  std::string imprecision_ = {};
};

void AsUsersRecord::add(const std::string& field, const Finding& finding, const State& state,
                        std::size_t at) {
  if (!finding.users_error) return;
  if (last_ != at) ++states_;
  last_ = at;
  fields_.insert(field);
  const double before = errors_.worst();
  const bool is_first = errors_.samples() == 0;
  errors_.add(*finding.users_error, state);
  if (!is_first && errors_.worst() <= before) return;
  worst_ = field;
  imprecision_ = finding.users_imprecision;
}

CertificateRow AsUsersRecord::row(const Subject& subject, std::string_view scalar) const {
  CertificateRow row;
  row.check = "as users compile";
  row.output = row.check;
  row.subject = fmt::format("all outputs ({})", scalar);
  row.formula = "|x - x*| / (u B); x of -O3 -march=native, contraction on";
  errors_.tell(row, subject, promised_bounds);
  row.verdict = verdict_of_rounding(errors_);
  row.samples = states_;
  row.tolerance = "8 u B + N eta, B as above";
  row.tolerance += beyond_bounds;
  if (row.samples == 0) {
    row.worst = "no state to compare at";
    return row;
  }
  row.error = errors_.worst();
  row.worst = row.verdict != Verdict::holds
                  ? fmt::format("{}: {}", worst_, imprecision_)
                  : fmt::format("{} outputs within {:.2g} u B; most in {}", fields_.size(),
                                errors_.worst(), worst_);
  return row;
}

/// How many of its digits one output loses, over all states in one scalar: a figure and never a
/// failure.
class LostDigits {
 public:
  /// `at` is the number of the state. Fields of one state come one after another.
  void add(const FieldPlace& place, const Finding& finding, const Subject& subject,
           const State& state, std::size_t at);

  [[nodiscard]] bool is_empty() const { return states_ == 0; }

  /// The entry that loses most and its state, both of what one rounding of the inputs would cost,
  /// and of the largest entry of its field. Noted where that is more than half of all digits.
  [[nodiscard]] CertificateRow row(ScalarKind scalar) const;

 private:
  struct Worst {
    double figure = 0;
    std::string entry = {};  ///< "mass_matrix[7,7]"
    std::string where = {};
  };

  std::size_t states_ = 0;
  std::optional<std::size_t> last_ = {};  ///< of the states
  Worst of_entry_ = {};
  Worst of_field_ = {};
};

std::string name_of_entry(const FieldPlace& place, std::size_t entry) {
  const Field& field = place.field();
  const std::string name = place.function->name + (field.name.empty() ? "" : "." + field.name);
  if (field.entries.size() == 1) return name;
  const std::size_t row = entry / field.columns + 1;
  if (field.columns == 1) return fmt::format("{}[{}]", name, row);
  return fmt::format("{}[{},{}]", name, row, entry % field.columns + 1);
}

void LostDigits::add(const FieldPlace& place, const Finding& finding, const Subject& subject,
                     const State& state, std::size_t at) {
  if (!finding.loss) return;
  states_ += last_ == at ? 0 : 1;
  last_ = at;
  const auto record = [&](Worst& worst, const LostEntry& lost) {
    if (lost.figure <= worst.figure) return;
    worst = {lost.figure, name_of_entry(place, lost.entry), describe_exactly(subject, state)};
  };
  record(of_entry_, finding.loss->of_entry);
  record(of_field_, finding.loss->of_field);
}

CertificateRow LostDigits::row(ScalarKind scalar) const {
  const int all = decimal_digits(scalar);
  const double of_entry = digits_lost(of_entry_.figure, scalar);
  const double of_field = digits_lost(of_field_.figure, scalar);
  CertificateRow row;
  row.check = "digits lost";
  row.formula =
      "log10 of |x - x*| / (u R), R = |x*| + K, max |x*| of the field for an x* of 0, K = sum "
      "|z dx/dz| over inputs and parameters: what their own rounding costs; in brackets of |x - "
      "x*| / (u max |x*|) of a field; at most all digits";
  row.samples = states_;
  row.loss = std::min(of_entry_.figure, std::pow(10.0, all));
  row.loss_of_field = std::min(of_field_.figure, std::pow(10.0, all));
  const bool is_grave = of_field > all / 2.0;
  const Worst& told = is_grave ? of_field_ : of_entry_;
  row.worst = fmt::format("{:.1f} digits{} (of the largest entry {:.1f})", of_entry,
                          of_entry_.entry.empty() ? "" : " of " + of_entry_.entry, of_field);
  if (is_grave && of_field_.entry != of_entry_.entry) row.worst += ", in " + of_field_.entry;
  row.where = told.where;
  row.tolerance = fmt::format(
      "a figure; noted beyond {:.1f} of the {} digits of the scalar, of the largest entry of a "
      "field; near zeros of typed sums of R, too",
      all / 2.0, all);
  row.verdict = is_grave ? Verdict::noted : Verdict::holds;
  return row;
}

template <class Scalar>
std::vector<CertificateRow> rows_at(const Subject& subject,
                                    const std::vector<SampledState<Scalar>>& states,
                                    const AccuracyOptions& options) {
  constexpr std::string_view scalar = name_of(scalar_kind<Scalar>);
  std::vector<FieldRecord> records;
  for (FieldPlace& place : field_places(subject)) records.push_back({std::move(place)});
  AsUsersRecord as_users;
  std::map<const Function*, LostDigits> losses;
  visit_all(subject, states, options, [&](std::size_t i, const Findings& findings) {
    const State state = exact_state(subject, states[i].values);
    for (std::size_t k = 0; k < records.size(); ++k) {
      if (!findings[k]) continue;
      FieldRecord& record = records[k];
      add(record, *findings[k], subject, state);
      losses[record.place.function].add(record.place, *findings[k], subject, state, i);
      as_users.add(subject_of(record.place, scalar), *findings[k], state, i);
    }
  });
  std::vector<CertificateRow> rows;
  for (const FieldRecord& record : records) {
    rows.push_back(row_of(subject, record, scalar, options));
  }
  if (options.visit.as_users != nullptr) rows.push_back(as_users.row(subject, scalar));
  for (const Function& function : subject.program.functions) {
    const LostDigits& lost = losses[&function];
    if (lost.is_empty()) continue;
    CertificateRow row = lost.row(scalar_kind<Scalar>);
    row.output = function.name;
    row.subject = fmt::format("{} ({})", function.name, scalar);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

template <class Scalar>
std::vector<CertificateRow> check_accuracy(const Subject& subject,
                                           const std::vector<SampledState<Scalar>>& states,
                                           const AccuracyOptions& options) {
  return rows_at(subject, states, options);
}

template std::vector<CertificateRow> check_accuracy(const Subject&,
                                                    const std::vector<SampledState<double>>&,
                                                    const AccuracyOptions&);
template std::vector<CertificateRow> check_accuracy(const Subject&,
                                                    const std::vector<SampledState<float>>&,
                                                    const AccuracyOptions&);

}  // namespace elgen
