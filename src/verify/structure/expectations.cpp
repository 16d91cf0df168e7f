// Expectations: proved where that succeeds. Otherwise they are compared to 45 digits at 64 random
// points and more where these miss a side of a kink; the row says that it was sampled, since that
// is no proof.
#include "verify/structure/expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analyse/substitution.hpp"
#include "elgen/references.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"
#include "verify/states/kinks.hpp"
#include "verify/states/tally.hpp"

namespace elgen {
namespace {

using cln::cl_R;

constexpr std::size_t point_count = 64;
/// The oracle has 60 digits; fifteen may cancel in either form.
constexpr double tolerance = 1e-45;
constexpr const char* sampled_reason = "1e-45 of the largest entry: sampled, no proof";
constexpr const char* proof = "proved: both are one canonical sum";
constexpr const char* proof_of_rate = "proved: the rate is the empty canonical sum";

/// Where the model is sampled, and the sides of kinks that are not among it.
struct SamplingStates {
  std::vector<State> states = {};
  std::string unseen = {};
};

SamplingStates random_points(const Model& model, std::uint64_t seed) {
  Sampler draw(seed);
  Kinks kinks(model);
  SamplingStates points;
  for (std::size_t turn = 0; turn < most_draws_for_kinks; ++turn) {
    if (turn >= point_count && kinks.are_seen()) break;
    State state = drawn_state(model, {}, draw, turn);
    const bool is_new = kinks.add(state);
    if (turn < point_count || is_new) points.states.push_back(std::move(state));
  }
  points.unseen = kinks.unseen();
  return points;
}

double quotient(const cl_R& difference, const cl_R& scale) {
  if (cln::zerop(difference)) return 0;
  return ScalarTraits<double>::from_real(cln::abs(difference) / scale);
}

/// One entry of an expectation about a system.
struct Entry {
  const Expectation& of;
  std::size_t index;
  const Subject& subject;

  [[nodiscard]] ExpressionId expression() const { return of.entries[index]; }
  [[nodiscard]] Span span() const { return index < of.spans.size() ? of.spans[index] : of.span; }
};

/// As the file calls it.
const std::string& written_name(const Expectation& expectation) {
  return expectation.field.empty() ? expectation.output : expectation.field;
}

std::string name_of(const Entry& entry) {
  const Field field{.columns = std::max(entry.of.columns, 1U), .entries = entry.of.entries};
  return written_name(entry.of) + index_text(field, entry.index);
}

CertificateRow row_of(const Entry& entry) {
  CertificateRow row;
  row.check = "[[expect]]";
  row.output = row.check + " " + written_name(entry.of);
  row.subject = name_of(entry);
  row.formula = to_string(entry.subject.model, entry.expression());
  if (entry.of.is_conserved()) row.formula = fmt::format("d/dt ({}) = 0 at u = 0", row.formula);
  row.tolerance = sampled_reason;
  return row;
}

CertificateRow proved_row(const Entry& entry) {
  CertificateRow row = row_of(entry);
  row.worst = "equal";
  row.evidence = Evidence::proof;
  row.tolerance = entry.of.is_conserved() ? proof_of_rate : proof;
  return row;
}

/// The value in the file and the right one at a state, and the scale that judges their difference.
struct Sample {
  cl_R written;
  cl_R derived;
  cl_R scale;
};

std::string wrong_text(const Entry& entry, const Sample& sample, const State& state) {
  const std::string where = describe(entry.subject, state);
  const std::string written = short_text(sample.written);
  if (entry.of.is_conserved())
    return fmt::format("its rate is {} instead of 0 at {}", written, where);
  return fmt::format("{} is {} by this form, {} as derived, {} too much, at {}", name_of(entry),
                     written, short_text(sample.derived),
                     short_text(sample.written - sample.derived), where);
}

Diagnostic nothing_compared(const Entry& entry) {
  return {Code::E510, entry.span(),
          fmt::format("this form of {} and the derived one have no value in common at {} points",
                      name_of(entry), point_count),
          "declare a `range` inside the domain"};
}

/// A state, and what an output is there by the oracle; of a rate the state alone.
struct SampledPoint {
  State state;
  OracleValues entries = {};
  cl_R scale = 0;  ///< of what counts as zero: the largest entry of the output and of M
};

SampledPoint derived_at(const Model& model, const OutputRequest& request, const State& state) {
  SampledPoint derived{state, oracle_values(model, request, state)};
  const OracleValues masses = oracle_values(model, {.kind = OutputKind::mass_matrix}, state);
  if (derived.entries) derived.scale = largest_of(*derived.entries);
  if (masses) derived.scale = cln::max(derived.scale, largest_of(*masses));
  return derived;
}

std::optional<Sample> value_sample(const Entry& entry, const SampledPoint& derived) {
  const auto written = oracle_expression(entry.subject.model, entry.expression(), derived.state);
  const std::size_t index = entry.of.first + entry.index;
  const bool is_there = derived.entries && index < derived.entries->size();
  if (!written || !is_there) return std::nullopt;
  return Sample{*written, (*derived.entries)[index], cln::max(derived.scale, cln::abs(*written))};
}

/// A state that keeps the constraints to all digits: one more step than a pose asks for. None where
/// there is none near this one.
std::optional<State> kept(const Model& model, const State& state) {
  if (model.constraints.empty()) return state;
  std::optional<State> there = oracle_assembled(model, state);
  if (!there) return std::nullopt;
  const OracleValues moved = oracle_values(model, {.kind = OutputKind::projected}, *there);
  if (!moved) return std::nullopt;
  const auto middle = moved->begin() + static_cast<std::ptrdiff_t>(there->q.size());
  there->q.assign(moved->begin(), middle);
  there->v.assign(middle, moved->end());
  return there;
}

/// The state at rest of inputs, with the acceleration, the momenta and the energy that it then has;
/// none where M is singular, or the constraints cannot be kept.
std::optional<State> free_motion(const Model& model, const State& start) {
  std::optional<State> constrained = kept(model, start);
  if (!constrained) return std::nullopt;
  State& state = *constrained;
  for (cl_R& u : state.u) u = 0;
  const OracleValues solution = oracle_values(model, {.kind = OutputKind::forward_dynamics}, state);
  const OracleValues momenta = oracle_values(model, {.kind = OutputKind::momentum}, state);
  const OracleValues energy = oracle_values(model, {.kind = OutputKind::energy_function}, state);
  if (!solution || !momenta || !energy) return std::nullopt;
  for (std::size_t i = 0; i < state.a.size(); ++i) state.a[i] = (*solution)[i];
  state.momenta = *momenta;
  state.E = energy->front();
  return constrained;
}

/// de/dt along the motion, judged by the size of its terms: |e|, the part without a, and the part
/// of each a_i.
std::optional<Sample> rate_sample(const Entry& entry, const State& motion) {
  const Model& model = entry.subject.model;
  const auto value = oracle_expression(model, entry.expression(), motion);
  const auto rate = oracle_rate(model, entry.expression(), motion);
  State part = motion;
  part.a.assign(motion.a.size(), cl_R(0));
  const auto coasting = oracle_rate(model, entry.expression(), part);
  if (!value || !rate || !coasting) return std::nullopt;
  Sample result{*rate, 0, cln::abs(*value) + cln::abs(*coasting)};
  for (std::size_t i = 0; i < motion.a.size(); ++i) {
    part.a[i] = motion.a[i];
    const auto accelerated = oracle_rate(model, entry.expression(), part);
    part.a[i] = 0;
    if (!accelerated) return std::nullopt;
    result.scale = result.scale + cln::abs(*accelerated - *coasting);
  }
  return result;
}

/// Where one expectation is sampled.
std::vector<SampledPoint> points_of(const Model& model, const Expectation& expectation,
                                    const std::vector<State>& states) {
  const auto request = find_request(model, expectation.output);
  std::vector<SampledPoint> points;
  for (const State& state : states) {
    if (expectation.is_conserved()) {
      if (const auto motion = free_motion(model, state)) points.push_back({*motion});
    } else if (request) {
      points.push_back(derived_at(model, *request, state));
    }
  }
  return points;
}

/// Compares one entry at all states; the first where it is wrong becomes the diagnostic.
void compare(ExpectationReport& report, const Entry& entry, const std::vector<SampledPoint>& points,
             const std::string& unseen) {
  Tally tally;
  std::string wrong;
  for (const SampledPoint& point : points) {
    const auto sample =
        entry.of.is_conserved() ? rate_sample(entry, point.state) : value_sample(entry, point);
    if (!sample) {
      tally.skip();
      continue;
    }
    const double figure = quotient(sample->written - sample->derived, sample->scale);
    tally.add(figure, point.state);
    if (wrong.empty() && !(figure <= tolerance)) wrong = wrong_text(entry, *sample, point.state);
  }
  CertificateRow& row = report.rows.emplace_back(row_of(entry));
  tally.tell(row, entry.subject, tolerance);
  row.worst = fmt::format("{:.1e} relative", tally.worst());
  if (row.verdict == Verdict::holds) row.where.clear();
  // The author expects a value: where there is none, the expectation is not met.
  if (tally.samples() == 0) row.verdict = Verdict::fails;
  if (!unseen.empty()) row.tolerance += "; not seen on both sides: " + unseen;
  if (!wrong.empty()) {
    report.diagnostics.push_back({Code::E510, entry.span(), std::move(wrong)});
  } else if (tally.samples() == 0) {
    report.diagnostics.push_back(nothing_compared(entry));
  }
}

/// The author's form and the derived one are one canonical sum. The former comes straight from the
/// model, the latter from the program, so that they share nothing but the ring they are compared
/// in.
class Proofs {
 public:
  /// Without `forms` nothing is proved.
  Proofs(const Subject& subject, ClosedForms* forms) : subject_(subject), forms_(forms) {}

  /// The entry equals that of the output derived. False says nothing.
  [[nodiscard]] bool equal(const Expectation& expectation, std::size_t entry);

  /// The rate of a `conserved` entry along the motion at u = 0 is the empty sum.
  [[nodiscard]] bool conserved(const Expectation& expectation, std::size_t entry);

 private:
  /// The form of an entry of the first field, or of the one of this name; null where there is none,
  /// or where it rests on zeros that were sampled.
  [[nodiscard]] const Fraction* derived(const OutputRequest& request, std::string_view field,
                                        std::size_t entry) const;
  [[nodiscard]] std::optional<std::vector<Fraction>> entries(OutputKind kind) const;
  [[nodiscard]] Replacements momenta() const;
  std::optional<Fraction> written(const Expectation& expectation, std::size_t entry);

  const Subject& subject_;
  ClosedForms* forms_;
};

const Fraction* Proofs::derived(const OutputRequest& request, std::string_view field,
                                std::size_t entry) const {
  const std::vector<Function>& functions = subject_.program.functions;
  for (std::size_t i = 0; forms_ != nullptr && i < forms_->functions.size(); ++i) {
    if (functions[i].kind != request.kind || functions[i].user != request.user) continue;
    if (!field.empty()) entry += first_entry_of(functions[i], field);
    if (std::ranges::count(functions[i].sampled_zeros, entry) > 0) return nullptr;
    for (const ClosedField& closed : forms_->functions[i].fields) {
      if (entry < closed.entries.size()) {
        return closed.entries[entry] ? &*closed.entries[entry] : nullptr;
      }
      entry -= closed.entries.size();
    }
    return nullptr;
  }
  return nullptr;
}

std::optional<Fraction> Proofs::written(const Expectation& expectation, std::size_t entry) {
  return closed_form(*forms_, subject_.model, subject_.scene.specialisation.fixed,
                     expectation.entries[entry]);
}

bool Proofs::equal(const Expectation& expectation, std::size_t entry) {
  const auto request = find_request(subject_.model, expectation.output);
  const Fraction* const form = request ? derived(*request, expectation.field, entry) : nullptr;
  if (form == nullptr) return false;
  const auto own = written(expectation, entry);
  return own && proved_equal(*forms_, *own, *form);
}

/// Entries of the first field; none where one of them has no form, or rests on samples.
std::optional<std::vector<Fraction>> Proofs::entries(OutputKind kind) const {
  const Function* const function = find_function(subject_.program, kind);
  if (function == nullptr) return std::nullopt;
  std::vector<Fraction> result;
  for (std::size_t i = 0; i < function->fields.front().entries.size(); ++i) {
    const Fraction* const form = derived({.kind = kind}, "", i);
    if (form == nullptr) return std::nullopt;
    result.push_back(*form);
  }
  return result;
}

/// The forms of p and E in `conserved`, as far as they are known.
Replacements Proofs::momenta() const {
  Replacements result;
  for (const auto& [leaf, kind] : {std::pair{Opcode::momentum, OutputKind::momentum},
                                   std::pair{Opcode::energy, OutputKind::energy_function}}) {
    const auto forms = entries(kind);
    for (std::uint32_t i = 0; forms && i < forms->size(); ++i)
      result[{leaf, i}].value = (*forms)[i];
  }
  return result;
}

bool Proofs::conserved(const Expectation& expectation, std::size_t entry) {
  const auto accelerations = entries(OutputKind::forward_dynamics);
  if (!accelerations) return false;
  auto own = written(expectation, entry);
  const bool has_momenta =
      holds_leaf(subject_.model, expectation.entries[entry], Opcode::momentum | Opcode::energy);
  if (own && has_momenta) own = substituted(forms_->algebra, *own, momenta());
  const std::vector<Fraction> rates = coordinate_rates(*forms_, subject_.model);
  const OpenTerms open_values =
      open_terms(*forms_, subject_.model, subject_.scene.specialisation.fixed);
  return own && proved_conserved(*forms_, *own, *accelerations, rates, open_values);
}

void check(ExpectationReport& report, const Expectation& expectation, const Subject& subject,
           Proofs& proofs, const SamplingStates& all) {
  std::optional<std::vector<SampledPoint>> points;  // for the first entry that is not proved
  for (std::size_t index = 0; index < expectation.entries.size(); ++index) {
    const Entry entry{expectation, index, subject};
    const bool is_proved = expectation.is_conserved() ? proofs.conserved(expectation, index)
                                                      : proofs.equal(expectation, index);
    if (is_proved) {
      report.rows.push_back(proved_row(entry));
      continue;
    }
    if (!points) points = points_of(subject.model, expectation, all.states);
    compare(report, entry, *points, all.unseen);
  }
}

}  // namespace

ExpectationReport check_expectations(const Subject& subject, ClosedForms* forms,
                                     std::uint64_t seed) {
  ExpectationReport report;
  // They speak of the exact model.
  if (subject.model.expectations.empty() || subject.model.approximation) return report;
  Proofs proofs(subject, forms);
  const SamplingStates points = random_points(subject.model, seed);
  for (const Expectation& expectation : subject.model.expectations) {
    check(report, expectation, subject, proofs, points);
  }
  return report;
}

}  // namespace elgen
