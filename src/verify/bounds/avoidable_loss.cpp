// avoidable loss: the states are visited again where there is one, and all ways compared.
#include "verify/bounds/avoidable_loss.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "elgen/render.hpp"
#include "lower/network/instructions.hpp"

namespace elgen {
namespace {

constexpr const char* loss_reason =
    "64 u R, R = |x*| + K, K = sum |z dx/dz| over inputs, parameters and literals: what their own "
    "rounding costs; fails where one way keeps the digits there, and loses no more elsewhere than "
    "is tolerated or 8 times what the code loses";

/// An entry that loses digits, and the ways that may be better.
struct LossyEntry {
  std::size_t entry = 0;
  double figure = 0;            ///< where it is largest
  std::size_t at = 0;           ///< that state
  std::vector<FieldWay> ways;   ///< that are left
  std::string_view there = {};  ///< one of those that keep the digits at that state
  double cost = 0;              ///< of one that is better and costs too much, by that of the code
};

template <class Scalar>
using LossOfWay = typename Visit<Scalar>::LossOfWay;

/// Drops the ways that lose more than so much of the entry.
template <class Scalar>
void drop_losing(LossyEntry& lossy, const LossOfWay<Scalar>& loss, double most) {
  std::erase_if(lossy.ways, [&](const FieldWay& way) { return loss(way, lossy.entry) > most; });
}

/// Leaves to every entry the ways that are better.
template <class Scalar>
void compare_ways(const FieldPlace& place, const Subject& subject,
                  const std::vector<SampledState<Scalar>>& states, const VisitOptions& options,
                  std::vector<LossyEntry>& entries) {
  std::vector<FieldWay> others = field_ways(subject, place, *options.ways);
  const FieldWay code = others.front();
  others.erase(others.begin());
  const auto has_ways = [](const LossyEntry& lossy) { return !lossy.ways.empty(); };
  for (LossyEntry& lossy : entries) {
    lossy.ways = others;
    Visit<Scalar> visit(subject, states[lossy.at], options);
    drop_losing<Scalar>(lossy, visit.losses_of_ways(place), tolerated_loss);
    if (has_ways(lossy)) lossy.there = lossy.ways.front().name;
  }
  for (const SampledState<Scalar>& state : states) {
    if (std::ranges::none_of(entries, has_ways)) return;
    Visit<Scalar> visit(subject, state, options);
    const auto loss = visit.losses_of_ways(place);
    for (LossyEntry& lossy : entries) {
      if (!has_ways(lossy)) continue;
      const double alike = similar_losses * loss(code, lossy.entry);
      drop_losing<Scalar>(lossy, loss, std::max(tolerated_loss, alike));
    }
  }
}

/// What the field costs as a function of its own, where there is one.
std::size_t cost_alone(const FieldPlace& place, const Program& program) {
  const auto alone = std::ranges::find(program.functions, place.field().name, &Function::name);
  const bool is_repeated = output_row(place.function->kind).repeats;
  const bool is_there = is_repeated && alone != program.functions.end();
  return cost(count_operations(is_there ? *alone : *place.function));
}

/// Leaves the ways that `choose` would pay for.
void drop_costly(LossyEntry& lossy, const FieldPlace& place, const Program& program) {
  const std::size_t known = cost_alone(place, program);
  std::erase_if(lossy.ways, [&](const FieldWay& way) {
    const std::size_t own = cost(count_operations(without_repeats(*way.function)));
    if (is_worth_its_digits(place.request.kind, own, known)) return false;
    lossy.cost = static_cast<double>(own) / static_cast<double>(known);
    lossy.there = way.name;
    return true;
  });
}

std::string figure_text(double figure) {
  if (!std::isfinite(figure)) return "all digits";
  return fmt::format("loss {:.2g}, {:.1f} digits", figure, std::log10(figure));
}

/// What may be done about it.
std::string remedy(const LossyEntry& lossy) {
  if (!lossy.ways.empty()) return fmt::format("the {} keeps them", lossy.ways.front().name);
  if (lossy.there.empty()) return "no known way keeps them there";
  if (lossy.cost > 0) {
    return fmt::format("the {} keeps them at {:.2g} times the cost", lossy.there, lossy.cost);
  }
  return fmt::format("the {} keeps them there, but loses others elsewhere", lossy.there);
}

/// Entries that a way would improve come before those that none does.
bool is_lossier(const LossyEntry& x, const LossyEntry& y) {
  return std::pair(!x.ways.empty(), x.figure) > std::pair(!y.ways.empty(), y.figure);
}

}  // namespace

void LossRecord::add(const Finding& finding, const State& state, std::size_t at) {
  if (!finding.loss) return;
  const auto [figure, entry] = *finding.loss;
  figures_.add(figure, state);
  if (figure <= tolerated_loss) return;
  Lost& lost = lossy_[entry];
  if (figure > lost.figure) lost = {figure, at};
}

template <class Scalar>
CertificateRow LossRecord::row(const FieldPlace& place, const Subject& subject,
                               const std::vector<SampledState<Scalar>>& states,
                               const VisitOptions& options) const {
  CertificateRow row;
  row.check = "avoidable loss";
  row.formula = "|x - x*| / (u R), where |x - x*| > 64 u |x*|";
  figures_.tell(row, subject, tolerated_loss);
  row.tolerance = loss_reason;
  row.worst = figures_.samples() == 0 ? "no state to compare at"
                                      : fmt::format("loss {:.2g}", figures_.worst());
  if (figures_.samples() > 0) row.loss = figures_.worst();
  if (lossy_.empty()) return row;
  std::vector<LossyEntry> entries;
  for (const auto& [entry, lost] : lossy_) entries.push_back({entry, lost.figure, lost.at, {}});
  compare_ways(place, subject, states, options, entries);
  for (LossyEntry& lossy : entries) drop_costly(lossy, place, subject.program);
  const LossyEntry& worst = *std::ranges::min_element(entries, is_lossier);
  Visit<Scalar> there(subject, states[worst.at], options);
  const std::uint32_t culprit = there.culprit(place, worst.entry);
  const bool is_chosen = subject.scene.numerics.prefer == Preference::speed;
  row.verdict = worst.ways.empty() || is_chosen ? Verdict::noted : Verdict::fails;
  row.where = describe(subject, there.state());
  row.worst = fmt::format("{} of entry {}, most of it in {}; {}", figure_text(worst.figure),
                          worst.entry + 1, equation_at(subject.program, *place.function, culprit),
                          remedy(worst));
  if (is_chosen) row.worst += "; the scene prefers speed";
  return row;
}

template CertificateRow LossRecord::row(const FieldPlace&, const Subject&,
                                        const std::vector<SampledState<double>>&,
                                        const VisitOptions&) const;
template CertificateRow LossRecord::row(const FieldPlace&, const Subject&,
                                        const std::vector<SampledState<float>>&,
                                        const VisitOptions&) const;

}  // namespace elgen
