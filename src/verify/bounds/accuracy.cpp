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
  FieldPlace place = {};
  std::vector<double> errors = {};  ///< at nominal states
  std::size_t compared = 0;         ///< number of compared states
  std::map<Obstacle, std::size_t> skipped = {};
  std::size_t skipped_inside = 0;  ///< skipped nominal states; 0 in float
  std::string mistake = {};        ///< the first mistake
  std::string mistake_at = {};
};

/// The obstacle that a row reports for a state that was not compared.
Obstacle obstacle_of(Regime regime) {
  if (regime == Regime::overflow) return Obstacle::overflow;
  return regime == Regime::unsettled ? Obstacle::unsettled : Obstacle::undefined;
}

void record_finding(FieldRecord& record, const Finding& finding, bool is_inside,
                    const Subject& subject, const State& state) {
  if (!finding.is_compared) ++record.skipped[obstacle_of(finding.regime)];
  record.skipped_inside += !finding.is_compared && is_inside ? 1 : 0;
  if (record.mistake.empty() && !finding.mistake.empty()) {
    record.mistake = finding.mistake;
    record.mistake_at = describe(subject, state);
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
std::string name_of(const FieldPlace& place) {
  const std::string& field = place.field().name;
  return place.function->name + (field.empty() ? "" : "." + field);
}

/// The subject of a row: "forward_dynamics.acceleration (double)".
std::string subject_of(const FieldPlace& place, std::string_view scalar) {
  return fmt::format("{} ({})", name_of(place), scalar);
}

CertificateRow row_of(const FieldRecord& record, std::string_view scalar,
                      const AccuracyOptions& options) {
  CertificateRow row;
  row.check = "program vs oracle";
  row.output = record.place.function->name;
  row.subject = subject_of(record.place, scalar);
  row.formula = options.visit.comparison == Comparison::entries
                    ? "x = x* in exact arithmetic, each entry"
                    : "x = x* in exact arithmetic, by one random projection";
  row.samples = record.compared;
  for (const auto& [obstacle, states] : record.skipped) row.skipped.push_back({obstacle, states});
  row.skipped_inside = record.skipped_inside;
  row.tolerance =
      "1e-50 (E + |x*|), E the running error of x; NaN and infinity fail if exact arithmetic "
      "stays below max/16 and E is known";
  row.worst = record.compared == 0 ? "no state to compare"
                                   : fmt::format("equal; median {:.2g} {}", median(record.errors),
                                                 record.place.is_remainder() ? "u E" : "ulp");
  if (record.compared == 0) row.verdict = Verdict::skipped;
  if (!record.mistake.empty()) {
    row.worst = record.mistake;
    row.where = record.mistake_at;
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
  double most = 0;
  std::string tolerance = {};
};

/// Code as users compile it: with -O3, all instructions of this machine and contraction.
/// Contraction changes the rounding.
CodeCheck users_check() {
  return {"as users compile", "|x_users - x| / (u E); x_users of -O3 -march=native, contraction on",
          "u E", most_of_users,
          fmt::format("{} u E + N eta, E the running error: both programs round once for each "
                      "rounding in E",
                      most_of_users)};
}

CodeCheck wide_check(InnerScalar inner) {
  const InnerRow& row = inner_row(inner);
  return {fmt::format("in {}", row.name),
          "|x_wide - x*| / (u |x*| + 16 u' E); x_wide of -O3 -march=native, contraction on",
          "of the tolerance", most_of_wide,
          fmt::format("{}, and N eta: x* is rounded to double; before that, each rounding in the "
                      "running error E has u' = {:.2g}",
                      most_of_wide, row.roundoff)};
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
  [[nodiscard]] CertificateRow row(const Subject& subject, std::string_view scalar) const;

 private:
  CodeCheck check_;
  Tally errors_ = {};  ///< in the unit of the check
  std::set<std::string> fields_ = {};
  std::set<std::size_t> states_ = {};
  std::string worst_ = {};  ///< the field with the largest error
  std::string mistake_ = {};
};

CertificateRow CodeRecord::row(const Subject& subject, std::string_view scalar) const {
  CertificateRow row;
  row.check = row.output = check_.check;
  row.subject = fmt::format("all outputs ({})", scalar);
  row.formula = check_.formula;
  errors_.write_result(row, subject, check_.most);
  row.samples = states_.size();
  row.tolerance = check_.tolerance;
  if (row.samples == 0) {
    row.worst = "no state to compare";
    return row;
  }
  const std::string figure = fmt::format("{:.2g} {}", errors_.worst(), check_.unit);
  row.worst = row.verdict != Verdict::holds
                  ? fmt::format("{}: {}, differs by {}", worst_, mistake_, figure)
                  : fmt::format("{} outputs within {}; most in {}", fields_.size(), figure, worst_);
  return row;
}

/// The digits that one output loses, over all states in one scalar: a figure, never a failure.
class LostDigits {
 public:
  /// `at`: index of the state.
  void add(const FieldPlace& place, const Finding& finding, const Subject& subject,
           const State& state, std::size_t at) {
    if (!finding.loss) return;
    states_.insert(at);
    without_reference_ += finding.loss->without_reference;
    const auto record = [&](Worst& worst, const LostEntry& lost) {
      if (lost.figure <= worst.figure) return;
      worst = {lost.figure, name_of(place) + index_text(place.field(), lost.entry),
               describe_exactly(subject, state)};
    };
    record(of_entry_, finding.loss->of_entry);
    record(of_field_, finding.loss->of_field);
  }

  [[nodiscard]] bool is_empty() const { return states_.empty(); }

  /// The row of one output: the largest loss relative to R = |x*| + K, and the largest loss
  /// relative to the largest entry of the field, each with its entry and state. The verdict is
  /// `noted` if the second loss exceeds half of all digits of the scalar.
  [[nodiscard]] CertificateRow row(ScalarKind scalar) const;

 private:
  struct Worst {
    double figure = 0;
    std::string entry = {};  ///< "mass_matrix[7,7]"
    std::string where = {};
  };

  std::set<std::size_t> states_ = {};
  std::size_t without_reference_ = 0;  ///< entries at states with R = 0
  Worst of_entry_ = {};
  Worst of_field_ = {};
};

CertificateRow LostDigits::row(ScalarKind scalar) const {
  const int all = decimal_digits(scalar);
  const double of_entry = digits_lost(of_entry_.figure, scalar);
  const double of_field = digits_lost(of_field_.figure, scalar);
  CertificateRow row;
  row.check = "digits lost";
  row.formula =
      "log10 of |x - x*| / (u R), R = |x*| + K; K = sum |z dx/dz| over inputs and parameters z is "
      "the effect of their rounding; solutions of M x = b in the norm |D^1/2 x|, D = diag M; in "
      "brackets: log10 of |x - x*| / (u max |x*|) of the field; at most all digits";
  row.samples = states_.size();
  row.loss = std::min(of_entry_.figure, std::pow(10.0, all));
  row.loss_of_field = std::min(of_field_.figure, std::pow(10.0, all));
  const bool is_grave = of_field > all / 2.0;
  const Worst& told = is_grave ? of_field_ : of_entry_;
  row.worst = fmt::format("{:.1f} digits{} (of the largest entry {:.1f})", of_entry,
                          of_entry_.entry.empty() ? "" : " of " + of_entry_.entry, of_field);
  if (is_grave && of_field_.entry != of_entry_.entry) row.worst += ", in " + of_field_.entry;
  if (without_reference_ > 0)
    row.worst +=
        fmt::format("; R is 0 {}",
                    without_reference_ == 1 ? "once" : fmt::format("{} times", without_reference_));
  row.where = told.where;
  row.tolerance = fmt::format(
      "never fails; noted if the largest entry of a field loses more than {:.1f} of the {} digits "
      "of "
      "the scalar; near zeros of typed sums the smaller of both losses counts",
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
  CodeRecord as_users(users_check());
  CodeRecord wide(wide_check(subject.scene.numerics.inner));
  std::map<const Function*, LostDigits> losses;
  visit_all(subject, states, options, [&](std::size_t i, const Findings& findings) {
    const State state = exact_state(subject, states[i].values);
    // Ranges are chosen for double: in float, an exponential overflows in most of them.
    const bool is_inside =
        scalar_kind<Scalar> == ScalarKind::double_precision && states[i].region == Region::nominal;
    for (std::size_t k = 0; k < records.size(); ++k) {
      if (!findings[k]) continue;
      FieldRecord& record = records[k];
      record_finding(record, *findings[k], is_inside, subject, state);
      losses[record.place.function].add(record.place, *findings[k], subject, state, i);
      as_users.add(subject_of(record.place, scalar), findings[k]->users, state, i);
      wide.add(subject_of(record.place, scalar), findings[k]->wide, state, i);
    }
  });
  std::vector<CertificateRow> rows;
  for (const FieldRecord& record : records) {
    rows.push_back(row_of(record, scalar, options));
  }
  if (options.visit.as_users != nullptr) rows.push_back(as_users.row(subject, scalar));
  if (options.visit.wide != nullptr) rows.push_back(wide.row(subject, scalar));
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
