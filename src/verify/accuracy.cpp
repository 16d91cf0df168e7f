// Program against oracle. Two steps per state and entry: the program, run in 64 digits, must be the
// oracle's value (the mathematics is right); the program, run in the scalar, must be within 8 u B
// of it (so is the rounding).
#include "accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "agreement.hpp"
#include "elgen/outputs.hpp"
#include "own_bound.hpp"
#include "stated_error.hpp"
#include "tally.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr const char* own_reason =
    "8 u B + N eta (own bound): B run along the program; n u B for n > 16 roundings in an entry";
constexpr const char* closed_reason =
    "8 u B + N eta: B of the closed form, own bound where the code underflows; n u B for n > 16 "
    "roundings in an entry";

/// One field of a function, and what was found of it so far.
struct FieldRecord {
  const Program* program = nullptr;
  const Function* function = nullptr;
  const Field* field = nullptr;
  Judge judge = {};
  OutputRequest request = {};     ///< what the oracle is asked for
  std::size_t first = 0;          ///< of its entries among the function's
  std::size_t first_oracle = 0;   ///< of its entries among the oracle's
  Tally errors = {};              ///< in u B
  Tally cancellation = {};        ///< B/|x|: how badly the physics cancels
  std::vector<double> ulps = {};  ///< at nominal states
  std::size_t undefined = 0;      ///< states by regime
  std::size_t overflows = 0;
  std::size_t ill_conditioned = 0;
  std::string mistake = {};  ///< the first entry whose exact value is wrong, and where
  std::string mistake_at = {};
};

/// `dynamics` holds other outputs under their names; every other function is one output.
FieldRecord record_of(const Subject& subject, const Function& function, const Field& field) {
  FieldRecord record;
  record.program = &subject.program;
  record.function = &function;
  record.field = &field;
  record.request = standard_request(function.kind);
  record.request.user = function.user;
  if (function.kind == OutputKind::dynamics) {
    if (const OutputRequest* member = find_request(subject.scene, field.name)) {
      record.request = *member;
    }
  }
  return record;
}

std::vector<FieldRecord> records_of(const Subject& subject) {
  std::vector<FieldRecord> records;
  for (std::size_t index = 0; index < subject.program.functions.size(); ++index) {
    const Function& function = subject.program.functions[index];
    std::size_t first = 0;
    for (const Field& field : function.fields) {
      FieldRecord record = record_of(subject, function, field);
      record.judge = judge_of(subject.program, index, field, first);
      record.first = first;
      record.first_oracle = function.kind == OutputKind::dynamics ? 0 : first;
      first += field.entries.size();
      records.push_back(std::move(record));
    }
  }
  return records;
}

template <class Scalar>
double ulps_apart(Scalar x, const cl_R& truth) {
  const Scalar magnitude = std::abs(ScalarTraits<Scalar>::from_real(truth));
  const Scalar next = std::nextafter(magnitude, std::numeric_limits<Scalar>::infinity());
  const Real difference = abs(Real(exact_value(static_cast<double>(x)) - truth));
  return ScalarTraits<double>::from_real(difference.value()) /
         static_cast<double>(next - magnitude);
}

double cancellation(const Bound& entry) {
  if (cln::zerop(entry.value.value())) return 0;
  return ScalarTraits<double>::from_real((entry.bound / abs(entry.value)).value());
}

/// One function at one state.
template <class Scalar>
struct Run {
  BoundedRun exact;
  BoundedRun judged;  ///< of the judge, where that is another function
  std::vector<Scalar> values;
  bool nominal = false;
};

/// The regimes of the program and of its judge together.
template <class Scalar>
Regime regime_of(const Run<Scalar>& run) {
  return worse(run.exact.regime, run.judged.regime);
}

std::string mismatch(std::size_t entry, const Real& value, const cl_R& truth) {
  return fmt::format("entry {} is {}, the oracle says {}", entry + 1, short_text(value),
                     short_text(truth));
}

template <class Scalar>
void record_entry(FieldRecord& record, const Run<Scalar>& run, std::size_t i, OracleCache& oracle) {
  const Bound& exact = run.exact.entries[record.first + i];
  const Bound& judged =
      record.judge.is_closed_form ? run.judged.entries[record.judge.first + i] : exact;
  const cl_R& truth = (*oracle.values(record.request))[record.first_oracle + i];
  const Real stated = stated_error(*record.program, record.request.kind, i, oracle.state());
  const Scalar x = run.values[record.first + i];
  for (const Bound* value : {&exact, &judged}) {
    if (!record.mistake.empty()) break;
    const Measured number{value->value, value->bound, stated};
    if (agrees_with_oracle(number, truth, run.exact.largest, oracle)) continue;
    record.mistake = mismatch(i, value->value, truth);
  }
  if (regime_of(run) == Regime::ill_conditioned) return;
  const Bound& entry = judging_bound(exact, judged);
  record.errors.add(error_in_bounds(x, entry, record.function->instructions.size()),
                    oracle.state());
  record.cancellation.add(cancellation(entry), oracle.state());
  if (run.nominal && !cln::zerop(entry.value.value())) record.ulps.push_back(ulps_apart(x, truth));
}

/// False where there is nothing to compare. Without a bound the exact value still has to be right.
bool is_comparable(FieldRecord& record, Regime regime) {
  record.undefined += regime == Regime::undefined ? 1 : 0;
  record.overflows += regime == Regime::overflow ? 1 : 0;
  record.ill_conditioned += regime == Regime::ill_conditioned ? 1 : 0;
  return regime == Regime::regular || regime == Regime::ill_conditioned;
}

/// The oracle's values where it can be trusted; none outside the domain, and counted there.
const OracleValues* trusted_values(FieldRecord& record, OracleCache& oracle) {
  const OracleValues& truth = oracle.values(record.request);
  if (!truth) {
    ++record.undefined;
    return nullptr;
  }
  if (!output_row(record.request.kind).solves || oracle.solves()) return &truth;
  ++record.ill_conditioned;
  return nullptr;
}

/// At an ordinary state the program has no value: nor must the oracle have one.
template <class Scalar>
void record_undefined(FieldRecord& record, const Run<Scalar>& run, OracleCache& oracle) {
  for (std::size_t i = 0; i < record.field->entries.size(); ++i) {
    const Real& own = run.exact.entries[record.first + i].value;
    const Real& judged =
        record.judge.is_closed_form ? run.judged.entries[record.judge.first + i].value : own;
    if (own.is_defined() && judged.is_defined()) continue;
    const OracleValues* truth = trusted_values(record, oracle);
    if (truth == nullptr) return;
    record.mistake = mismatch(i, Real::undefined(), (**truth)[record.first_oracle + i]);
    return;
  }
  ++record.undefined;
}

template <class Scalar>
void record_entries(FieldRecord& record, const Run<Scalar>& run, OracleCache& oracle) {
  const Regime regime = regime_of(run);
  if (regime == Regime::undefined && run.nominal && record.mistake.empty()) {
    record_undefined(record, run, oracle);
    return;
  }
  if (!is_comparable(record, regime)) return;
  if (trusted_values(record, oracle) == nullptr) return;
  for (std::size_t i = 0; i < record.field->entries.size(); ++i) {
    record_entry(record, run, i, oracle);
  }
}

template <class Scalar>
void record_state(FieldRecord& record, const Run<Scalar>& run, OracleCache& oracle,
                  const Subject& subject) {
  const bool was_right = record.mistake.empty();
  record_entries(record, run, oracle);
  if (was_right && !record.mistake.empty()) record.mistake_at = describe(subject, oracle.state());
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string figures(const FieldRecord& record) {
  std::string text =
      fmt::format("{:.2g} u B; median {:.2g} ulp; cancellation {:.2g}", record.errors.worst(),
                  median(record.ulps), record.cancellation.worst());
  if (record.overflows > 0) text += fmt::format("; {} overflow, reported", record.overflows);
  if (record.undefined > 0) text += fmt::format("; {} outside the domain", record.undefined);
  if (record.ill_conditioned > 0) {
    text += fmt::format("; {} too ill-conditioned to bound", record.ill_conditioned);
  }
  return text;
}

CertificateRow row_of(const Subject& subject, const FieldRecord& record, const char* scalar) {
  const Field& field = *record.field;
  CertificateRow row;
  row.check = "program vs oracle";
  row.subject = fmt::format("{}{}{} ({})", record.function->name, field.name.empty() ? "" : ".",
                            field.name, scalar);
  row.formula = "|x - x*| / (u B)";
  row.samples = record.errors.samples() / std::max<std::size_t>(field.entries.size(), 1);
  row.tolerance = record.judge.is_closed_form ? closed_reason : own_reason;
  row.worst = figures(record);
  row.where = record.errors.where(subject);
  row.verdict = record.errors.verdict(promised_bounds);
  if (!record.mistake.empty()) {
    row.worst = record.mistake;
    row.where = record.mistake_at;
    row.verdict = Verdict::fails;
  }
  return row;
}

/// A derivative of the dynamics costs the oracle as much as all other outputs together, n times: of
/// more than three velocities every sixteenth state has to do.
bool is_due(OutputKind kind, std::size_t velocities, std::size_t sample) {
  return !output_row(kind).differentiates || velocities <= 3 || sample % 16 == 0;
}

template <class Scalar>
void record_sample(std::vector<FieldRecord>& records, const Subject& subject,
                   const SampledState<Scalar>& sample, std::size_t number) {
  OracleCache oracle(subject, exact_state(subject, sample.values));
  const Function* evaluated = nullptr;
  const Function* judge = nullptr;
  Run<Scalar> run;
  for (FieldRecord& record : records) {
    if (!is_due(record.request.kind, oracle.state().v.size(), number)) continue;
    if (record.function != evaluated) {
      evaluated = record.function;
      run = {bounded_run<Scalar>(subject.program, *evaluated, oracle.state()),
             {},
             evaluate(subject.program, *evaluated, sample.values),
             sample.region == Region::nominal};
      judge = nullptr;
    }
    if (record.judge.is_closed_form && record.judge.function != judge) {
      judge = record.judge.function;
      run.judged = bounded_run<Scalar>(subject.program, *judge, oracle.state());
    }
    record_state(record, run, oracle, subject);
  }
}

}  // namespace

template <class Scalar>
std::vector<CertificateRow> check_accuracy(const Subject& subject,
                                           const std::vector<SampledState<Scalar>>& states) {
  std::vector<FieldRecord> records = records_of(subject);
  for (std::size_t i = 0; i < states.size(); ++i) record_sample(records, subject, states[i], i);
  std::vector<CertificateRow> rows;
  for (const FieldRecord& record : records) {
    rows.push_back(row_of(subject, record, std::is_same_v<Scalar, float> ? "float" : "double"));
  }
  return rows;
}

template std::vector<CertificateRow> check_accuracy(const Subject&,
                                                    const std::vector<SampledState<double>>&);
template std::vector<CertificateRow> check_accuracy(const Subject&,
                                                    const std::vector<SampledState<float>>&);

}  // namespace elgen
