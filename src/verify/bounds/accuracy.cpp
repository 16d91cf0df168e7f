// Compares the program with the oracle at all states, and tallies the findings by field.
#include "verify/bounds/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "elgen/outputs.hpp"
#include "elgen/scalars.hpp"
#include "verify/states/tally.hpp"

namespace elgen {
namespace {

/// One field of a function, and its findings at the states so far.
struct FieldRecord {
  ComparedField place = {};
  std::vector<double> errors = {};  ///< at nominal states
  std::size_t compared = 0;         ///< number of compared states
  std::map<SkipReason, std::size_t> skipped = {};
  std::size_t skipped_inside = 0;  ///< number of skipped states inside the ranges; only for double
  std::string mistake = {};        ///< the first mistake
  std::string mistake_state = {};
};

/// The obstacle that a row reports for a state that was not compared because of `regime`.
SkipReason obstacle_of(Regime regime) {
  if (regime == Regime::overflow) return SkipReason::overflow;
  return regime == Regime::unsettled ? SkipReason::undecided : SkipReason::undefined;
}

void record_finding(FieldRecord& record, const Finding& finding, bool is_inside,
                    const SystemUnderTest& subject, const State& state) {
  if (!finding.is_compared) ++record.skipped[obstacle_of(finding.regime)];
  record.skipped_inside += !finding.is_compared && is_inside ? 1 : 0;
  if (record.mistake.empty() && !finding.mistake.empty()) {
    record.mistake = finding.mistake;
    record.mistake_state = describe_state(subject, state);
  }
  record.compared += finding.is_compared ? 1 : 0;
  record.errors.insert(record.errors.end(), finding.errors.begin(), finding.errors.end());
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// "forward_dynamics.acceleration"
std::string name_of(const ComparedField& place) {
  const std::string& field = place.field().name;
  return place.function->name + (field.empty() ? "" : "." + field);
}

/// The subject of a row: "forward_dynamics.acceleration (double)".
std::string subject_of(const ComparedField& place, std::string_view scalar) {
  return fmt::format("{} ({})", name_of(place), scalar);
}

CertificateRow accuracy_row(const FieldRecord& record, std::string_view scalar,
                            const AccuracyOptions& options) {
  CertificateRow row;
  row.check = "program vs oracle";
  row.output = record.place.function->name;
  row.subject = subject_of(record.place, scalar);
  row.formula = options.check_options.comparison == ComparisonMode::entries
                    ? "x = x* in exact arithmetic, each entry"
                    : "x = x* in exact arithmetic, by one random projection";
  row.samples = record.compared;
  for (const auto& [obstacle, states] : record.skipped) row.skipped.push_back({obstacle, states});
  row.skipped_in_ranges = record.skipped_inside;
  row.tolerance =
      "1e-50 (E + |x*|), E the running error of x; NaN and infinity fail if exact arithmetic "
      "stays below max/16 and E is known";
  row.worst_value = record.compared == 0
                        ? "no state to compare"
                        : fmt::format("equal; median {:.2g} {}", median(record.errors),
                                      record.place.is_remainder() ? "u E" : "ulp");
  if (record.compared == 0) row.verdict = Verdict::skipped;
  if (!record.mistake.empty()) {
    row.worst_value = record.mistake;
    row.worst_state = record.mistake_state;
    row.verdict = Verdict::fails;
  }
  return row;
}

/// A check of compiled code: the texts of its row, the unit of its errors, and the largest
/// permitted error in this unit.
struct CodeCheck {
  std::string check = {};
  std::string formula = {};
  std::string unit = {};
  double max_error = 0;
  std::string tolerance = {};
};

/// Code as users compile it: with -O3, all instructions of this machine and contraction.
/// Contraction changes the rounding.
CodeCheck user_code_check() {
  return {"as users compile", "|x_users - x| / (u E); x_users of -O3 -march=native, contraction on",
          "u E", max_user_code_error,
          fmt::format("{} u E + N eta, E the running error: both programs round once for each "
                      "rounding in E",
                      max_user_code_error)};
}

CodeCheck wide_check(InnerScalar inner) {
  const InnerScalarRow& row = inner_scalar_row(inner);
  if (inner == InnerScalar::single_precision) {
    return {fmt::format("in {}", row.name),
            "|x_wide - x*| / (u |x*| + 16 h u' E_a); x_wide of -O3 -march=native, contraction on",
            "of the tolerance", max_wide_code_error,
            fmt::format("{}, and N eta: the sums of a step are in double, the accelerations have "
                        "the running error E_a in float, u' = {:.2g}; besides random steps h = "
                        "2^-20, and h = 0, which changes no bit",
                        max_wide_code_error, row.roundoff)};
  }
  return {fmt::format("in {}", row.name),
          "|x_wide - x*| / (u |x*| + 16 u' E); x_wide of -O3 -march=native, contraction on",
          "of the tolerance", max_wide_code_error,
          fmt::format("{}, and N eta: x* is rounded to double; before that, each rounding in the "
                      "running error E has u' = {:.2g}",
                      max_wide_code_error, row.roundoff)};
}

/// The largest error of all fields in one check of code, and the field with this error.
class CodeRecord {
 public:
  explicit CodeRecord(CodeCheck check) : check_(std::move(check)) {}

  /// `field`: "forward_dynamics.acceleration (double)"; `at`: index of the state.
  void add(const std::string& field, const CodeFinding& finding, const State& state,
           std::size_t at) {
    if (!finding.error) return;
    states_.insert(at);
    fields_.insert(field);
    if (!errors_.add(*finding.error, state)) return;
    worst_ = field;
    mistake_ = finding.mistake;
  }

  /// One row for all fields in one scalar.
  [[nodiscard]] CertificateRow row(const SystemUnderTest& subject, std::string_view scalar) const;

 private:
  CodeCheck check_;
  Tally errors_ = {};  ///< in the unit of the check
  std::set<std::string> fields_ = {};
  std::set<std::size_t> states_ = {};
  std::string worst_ = {};  ///< the field with the largest error
  std::string mistake_ = {};
};

CertificateRow CodeRecord::row(const SystemUnderTest& subject, std::string_view scalar) const {
  CertificateRow row;
  row.check = row.output = check_.check;
  row.subject = fmt::format("all outputs ({})", scalar);
  row.formula = check_.formula;
  errors_.write_result(row, subject, check_.max_error);
  row.samples = states_.size();
  row.tolerance = check_.tolerance;
  if (row.samples == 0) {
    row.worst_value = "no state to compare";
    return row;
  }
  const std::string figure = fmt::format("{:.2g} {}", errors_.worst(), check_.unit);
  row.worst_value =
      row.verdict != Verdict::holds
          ? fmt::format("{}: {}, differs by {}", worst_, mistake_, figure)
          : fmt::format("{} outputs within {}; most in {}", fields_.size(), figure, worst_);
  return row;
}

/// The digits that one output loses, over all states in one scalar: a figure, never a failure.
class LostDigits {
 public:
  /// `at`: index of the state.
  void add(const ComparedField& place, const Finding& finding, const SystemUnderTest& subject,
           const State& state, std::size_t at) {
    if (!finding.loss) return;
    states_.insert(at);
    entries_without_reference_ += finding.loss->entries_without_reference;
    const auto record = [&](WorstLoss& worst, const LostEntry& lost) {
      if (lost.loss <= worst.figure) return;
      worst = {lost.loss, name_of(place) + index_text(place.field(), lost.entry),
               describe_state_exactly(subject, state)};
    };
    record(entry_loss_, finding.loss->relative_to_entry);
    record(field_loss_, finding.loss->relative_to_field);
  }

  [[nodiscard]] bool is_empty() const { return states_.empty(); }

  /// The row of one output: the largest loss relative to R = |x*| + K, and the largest loss
  /// relative to the largest entry of the field, each with its entry and state. The verdict is
  /// `noted` if the second loss exceeds half of all digits of the scalar.
  [[nodiscard]] CertificateRow row(ScalarKind scalar) const;

 private:
  struct WorstLoss {
    double figure = 0;
    std::string entry = {};  ///< "mass_matrix[7,7]"
    std::string where = {};
  };

  std::set<std::size_t> states_ = {};
  std::size_t entries_without_reference_ = 0;  ///< number of entries with an error, but R = 0
  WorstLoss entry_loss_ = {};
  WorstLoss field_loss_ = {};
};

CertificateRow LostDigits::row(ScalarKind scalar) const {
  const int all = decimal_digits(scalar);
  const double of_entry = digits_lost(entry_loss_.figure, scalar);
  const double of_field = digits_lost(field_loss_.figure, scalar);
  CertificateRow row;
  row.check = "digits lost";
  row.formula =
      "log10 of |x - x*| / (u R), R = |x*| + K; K = sum |z dx/dz| over inputs and parameters z is "
      "the effect of their rounding; solutions of M x = b in the norm |D^1/2 x|, D = diag M; in "
      "brackets: log10 of |x - x*| / (u max |x*|) of the field; at most all digits";
  row.samples = states_.size();
  row.loss = std::min(entry_loss_.figure, std::pow(10.0, all));
  row.loss_of_field = std::min(field_loss_.figure, std::pow(10.0, all));
  const bool is_grave = of_field > all / 2.0;
  const WorstLoss& reported = is_grave ? field_loss_ : entry_loss_;
  row.worst_value =
      fmt::format("{:.1f} digits{} (of the largest entry {:.1f})", of_entry,
                  entry_loss_.entry.empty() ? "" : " of " + entry_loss_.entry, of_field);
  if (is_grave && field_loss_.entry != entry_loss_.entry)
    row.worst_value += ", in " + field_loss_.entry;
  if (entries_without_reference_ > 0)
    row.worst_value +=
        fmt::format("; R is 0 {}", entries_without_reference_ == 1
                                       ? "once"
                                       : fmt::format("{} times", entries_without_reference_));
  row.worst_state = reported.where;
  row.tolerance = fmt::format(
      "never fails; noted if the largest entry of a field loses more than {:.1f} of the {} digits "
      "of "
      "the scalar; near zeros of typed sums the smaller of both losses counts",
      all / 2.0, all);
  row.verdict = is_grave ? Verdict::noted : Verdict::holds;
  return row;
}

template <class Scalar>
std::vector<CertificateRow> accuracy_rows(const SystemUnderTest& subject,
                                          const std::vector<SampledState<Scalar>>& states,
                                          const AccuracyOptions& options) {
  constexpr std::string_view scalar = name_of(scalar_kind<Scalar>);
  std::vector<FieldRecord> records;
  for (ComparedField& place : field_places(subject)) records.push_back({std::move(place)});
  CodeRecord user_code_record(user_code_check());
  CodeRecord wide(wide_check(subject.scene.numerics.inner));
  std::map<const Function*, LostDigits> losses;
  check_states(subject, states, options, [&](std::size_t i, const Findings& findings) {
    const State state = exact_state(subject, states[i].values);
    // Ranges are chosen for double: in float, an exponential overflows in most of them.
    const bool is_inside =
        scalar_kind<Scalar> == ScalarKind::double_precision && states[i].region == Region::nominal;
    for (std::size_t k = 0; k < records.size(); ++k) {
      if (!findings[k]) continue;
      FieldRecord& record = records[k];
      record_finding(record, *findings[k], is_inside, subject, state);
      losses[record.place.function].add(record.place, *findings[k], subject, state, i);
      user_code_record.add(subject_of(record.place, scalar), findings[k]->user_code, state, i);
      wide.add(subject_of(record.place, scalar), findings[k]->wide_code, state, i);
    }
  });
  std::vector<CertificateRow> rows;
  for (const FieldRecord& record : records) {
    rows.push_back(accuracy_row(record, scalar, options));
  }
  if (options.check_options.user_code != nullptr)
    rows.push_back(user_code_record.row(subject, scalar));
  if (options.check_options.wide_code != nullptr) rows.push_back(wide.row(subject, scalar));
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
std::vector<CertificateRow> check_accuracy(const SystemUnderTest& subject,
                                           const std::vector<SampledState<Scalar>>& states,
                                           const AccuracyOptions& options) {
  return accuracy_rows(subject, states, options);
}

template std::vector<CertificateRow> check_accuracy(const SystemUnderTest&,
                                                    const std::vector<SampledState<double>>&,
                                                    const AccuracyOptions&);
template std::vector<CertificateRow> check_accuracy(const SystemUnderTest&,
                                                    const std::vector<SampledState<float>>&,
                                                    const AccuracyOptions&);

}  // namespace elgen
