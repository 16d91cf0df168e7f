// Expectations: proved where that succeeds. Otherwise two exact functions of the model agree where
// they agree to 45 digits at 64 random points; the row says that it was sampled, since that is no
// proof.
#include "verify/structure/expectations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/random.hpp"
#include "check/names/requests.hpp"
#include "verify/states/tally.hpp"
#include "verify/structure/proofs.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr std::size_t point_count = 64;
/// The oracle has 60 digits; fifteen may cancel in either form.
constexpr double tolerance = 1e-45;
constexpr const char* reason = "1e-45 of the largest entry: sampled at 64 points, no proof";
constexpr const char* proof = "proved: both are one canonical sum";
constexpr const char* proof_of_rate = "proved: the rate is the empty canonical sum";

std::vector<State> random_points(const Model& model, std::uint64_t seed) {
  Random random(seed);
  std::vector<State> points;
  for (std::size_t i = 0; i < point_count; ++i) {
    points.push_back(nominal_state(model, {}));
    draw_parameters({}, random, points.back());
    draw_motion(model, random, points.back());
  }
  return points;
}

cl_R largest(const std::vector<cl_R>& values) {
  cl_R result = 0;
  for (const cl_R& value : values) result = cln::max(result, cln::abs(value));
  return result;
}

double quotient(const cl_R& difference, const cl_R& scale) {
  if (cln::zerop(difference)) return 0;
  return ScalarTraits<double>::from_real(cln::abs(difference) / scale);
}

struct PointOfComparison {
  State state;
  std::optional<std::vector<cl_R>> derived;  ///< entries of the output, by the oracle
  cl_R scale;  ///< of what counts as zero: the largest entry of the output and of M
};

std::vector<PointOfComparison> compare_at(const Model& model, const OutputRequest& request,
                                          const std::vector<State>& states) {
  const OutputRequest mass{.kind = OutputKind::mass_matrix};
  std::vector<PointOfComparison> points;
  for (const State& state : states) {
    PointOfComparison point{state, oracle_values(model, request, state), 0};
    const OracleValues masses = oracle_values(model, mass, state);
    if (point.derived) point.scale = largest(*point.derived);
    if (masses) point.scale = cln::max(point.scale, largest(*masses));
    points.push_back(std::move(point));
  }
  return points;
}

std::string entry_name(const Expectation& expectation, std::size_t entry) {
  const std::size_t columns = std::max<std::size_t>(expectation.columns, 1);
  if (expectation.entries.size() == 1) return expectation.output;
  if (columns == 1) return fmt::format("{}[{}]", expectation.output, entry + 1);
  return fmt::format("{}[{},{}]", expectation.output, entry / columns + 1, entry % columns + 1);
}

Span entry_span(const Expectation& expectation, std::size_t entry) {
  return entry < expectation.spans.size() ? expectation.spans[entry] : expectation.span;
}

CertificateRow expectation_row(const Expectation& expectation, std::size_t entry,
                               const Subject& subject) {
  CertificateRow row;
  row.check = "[[expect]]";
  row.output = row.check + " " + expectation.output;
  row.subject = entry_name(expectation, entry);
  row.formula = to_string(subject.model, expectation.entries[entry]);
  row.tolerance = reason;
  return row;
}

void finish(CertificateRow& row, const Tally& tally, const Subject& subject) {
  row.samples = tally.samples();
  row.worst = fmt::format("{:.1e} relative", tally.worst());
  if (tally.skipped() > 0) row.skipped = {{Obstacle::undefined, tally.skipped()}};
  row.where = tally.within(tolerance) ? std::string() : tally.where(subject);
  // The author expects a value: where there is none, the expectation is not met.
  row.verdict = tally.samples() == 0 ? Verdict::fails : tally.verdict(tolerance);
}

Diagnostic nothing_compared(const Expectation& expectation, std::size_t entry) {
  return {Code::E510, entry_span(expectation, entry),
          fmt::format("this form of {} and what is derived have no value in common at {} points",
                      entry_name(expectation, entry), point_count),
          "declare a `range` inside the domain"};
}

/// What stands in the file, what is right, and where to see it.
struct Witness {
  cl_R written;
  cl_R derived;
  State state;
};

Diagnostic wrong_entry(const Expectation& expectation, std::size_t entry, const Subject& subject,
                       const Witness& witness) {
  return {Code::E510, entry_span(expectation, entry),
          fmt::format("{} is {} by this form, {} as derived, {} too much, at {}",
                      entry_name(expectation, entry), short_text(witness.written),
                      short_text(witness.derived), short_text(witness.written - witness.derived),
                      describe(subject, witness.state))};
}

/// Compares one entry everywhere; the first point where it is wrong becomes the diagnostic.
void check_entry(ExpectationReport& report, const Expectation& expectation, std::size_t entry,
                 const Subject& subject, const std::vector<PointOfComparison>& points) {
  Tally tally;
  std::optional<Witness> witness;
  for (const PointOfComparison& point : points) {
    const auto written = oracle_expression(subject.model, expectation.entries[entry], point.state);
    if (!written || !point.derived || entry >= point.derived->size()) {
      tally.skip();
      continue;
    }
    const cl_R& derived = (*point.derived)[entry];
    const double figure = quotient(*written - derived, cln::max(point.scale, cln::abs(*written)));
    tally.add(figure, point.state);
    if (!witness && !(figure <= tolerance)) witness = Witness{*written, derived, point.state};
  }
  CertificateRow row = expectation_row(expectation, entry, subject);
  finish(row, tally, subject);
  report.rows.push_back(std::move(row));
  if (witness) {
    report.diagnostics.push_back(wrong_entry(expectation, entry, subject, *witness));
  } else if (tally.samples() == 0) {
    report.diagnostics.push_back(nothing_compared(expectation, entry));
  }
}

/// The state at rest of inputs, with the acceleration it then has; none where M is singular.
std::optional<State> free_motion(const Model& model, State state) {
  for (cl_R& u : state.u) u = 0;
  const OracleValues solution = oracle_values(model, {.kind = OutputKind::forward_dynamics}, state);
  if (!solution) return std::nullopt;
  for (std::size_t i = 0; i < state.a.size(); ++i) state.a[i] = (*solution)[i];
  return state;
}

struct Rate {
  cl_R value;  ///< de/dt along the motion
  cl_R scale;  ///< of its terms: |e|, the part without a, and the part of each a_i
};

std::optional<Rate> rate_along(const Model& model, ExpressionId expression, const State& motion) {
  const auto value = oracle_expression(model, expression, motion);
  const auto rate = oracle_rate(model, expression, motion);
  State part = motion;
  part.a.assign(motion.a.size(), cl_R(0));
  const auto coasting = oracle_rate(model, expression, part);
  if (!value || !rate || !coasting) return std::nullopt;
  Rate result{*rate, cln::abs(*value) + cln::abs(*coasting)};
  for (std::size_t i = 0; i < motion.a.size(); ++i) {
    part.a[i] = motion.a[i];
    const auto accelerated = oracle_rate(model, expression, part);
    part.a[i] = 0;
    if (!accelerated) return std::nullopt;
    result.scale = result.scale + cln::abs(*accelerated - *coasting);
  }
  return result;
}

CertificateRow conserved_row(const Expectation& expectation, std::size_t entry,
                             const Subject& subject) {
  CertificateRow row = expectation_row(expectation, entry, subject);
  row.formula = fmt::format("d/dt ({}) = 0 at u = 0", row.formula);
  return row;
}

void check_conserved(ExpectationReport& report, const Expectation& expectation, std::size_t entry,
                     const Subject& subject, const std::vector<State>& motions) {
  Tally tally;
  std::optional<Witness> witness;
  for (const State& motion : motions) {
    const auto rate = rate_along(subject.model, expectation.entries[entry], motion);
    if (!rate) {
      tally.skip();
      continue;
    }
    const double figure = quotient(rate->value, rate->scale);
    tally.add(figure, motion);
    if (!witness && !(figure <= tolerance)) witness = Witness{rate->value, 0, motion};
  }
  CertificateRow row = conserved_row(expectation, entry, subject);
  finish(row, tally, subject);
  report.rows.push_back(std::move(row));
  if (witness) {
    report.diagnostics.push_back(
        {Code::E510, entry_span(expectation, entry),
         fmt::format("its rate is {} instead of 0 at {}", short_text(witness->written),
                     describe(subject, witness->state))});
  } else if (tally.samples() == 0) {
    report.diagnostics.push_back(nothing_compared(expectation, entry));
  }
}

std::vector<State> free_motions(const Model& model, const std::vector<State>& states) {
  std::vector<State> motions;
  for (const State& state : states) {
    if (std::optional<State> motion = free_motion(model, state)) {
      motions.push_back(std::move(*motion));
    }
  }
  return motions;
}

CertificateRow proved_row(CertificateRow row, const char* how) {
  row.worst = "equal";
  row.evidence = Evidence::proof;
  row.tolerance = how;
  return row;
}

/// Entries of one expectation; the points are made for the first that is not proved.
void check_values(ExpectationReport& report, const Expectation& expectation, const Subject& subject,
                  Proofs& proofs, const std::vector<State>& states) {
  const auto request = find_request(subject.model, expectation.output);
  std::optional<std::vector<PointOfComparison>> points;
  for (std::size_t entry = 0; entry < expectation.entries.size(); ++entry) {
    if (proofs.equal(expectation, entry)) {
      report.rows.push_back(proved_row(expectation_row(expectation, entry, subject), proof));
      continue;
    }
    if (!points && request) points = compare_at(subject.model, *request, states);
    check_entry(report, expectation, entry, subject,
                points.value_or(std::vector<PointOfComparison>()));
  }
}

void check_rates(ExpectationReport& report, const Expectation& expectation, const Subject& subject,
                 Proofs& proofs, const std::vector<State>& states) {
  std::optional<std::vector<State>> motions;
  for (std::size_t entry = 0; entry < expectation.entries.size(); ++entry) {
    if (proofs.conserved(expectation, entry)) {
      CertificateRow row = conserved_row(expectation, entry, subject);
      report.rows.push_back(proved_row(std::move(row), proof_of_rate));
      continue;
    }
    if (!motions) motions = free_motions(subject.model, states);
    check_conserved(report, expectation, entry, subject, *motions);
  }
}

}  // namespace

ExpectationReport check_expectations(const Subject& subject, ClosedForms* forms,
                                     std::uint64_t seed) {
  ExpectationReport report;
  // They speak of the exact model.
  if (subject.model.expectations.empty() || subject.model.approximation) return report;
  Proofs proofs(subject, forms);
  const std::vector<State> states = random_points(subject.model, seed);
  for (const Expectation& expectation : subject.model.expectations) {
    const bool is_rate = expectation.output == "conserved";
    (is_rate ? check_rates : check_values)(report, expectation, subject, proofs, states);
  }
  return report;
}

}  // namespace elgen
