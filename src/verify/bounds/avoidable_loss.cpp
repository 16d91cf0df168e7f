// avoidable loss: the states are visited again where there is one, and all ways compared.
#include "verify/bounds/avoidable_loss.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "elgen/render.hpp"

namespace elgen {
namespace {

constexpr const char* loss_reason =
    "64 u R, R = |x*| + K, K = sum |z dx/dz| over inputs, parameters and literals: what their own "
    "rounding costs; fails where one way keeps the digits at all states";

/// The ways that keep all digits at the states of a list, out of those that are left.
template <class Scalar>
class KeepingWays {
 public:
  KeepingWays(const FieldPlace& place, const Subject& subject,
              const std::vector<SampledState<Scalar>>& states, const VisitOptions& options)
      : place_(place),
        subject_(subject),
        states_(states),
        options_(options),
        left_(field_ways(subject, place, *options.ways)) {
    left_.erase(left_.begin());  // the code itself
  }

  [[nodiscard]] const std::vector<FieldWay>& left() const { return left_; }

  void ask(std::size_t at) {
    if (left_.empty()) return;
    Visit<Scalar> visit(subject_, states_[at], options_);
    const std::vector<bool> keep = visit.keeping_ways(place_, left_);
    std::vector<FieldWay> some;
    for (std::size_t i = 0; i < keep.size(); ++i) {
      if (keep[i]) some.push_back(left_[i]);
    }
    left_ = std::move(some);
  }

 private:
  const FieldPlace& place_;
  const Subject& subject_;
  const std::vector<SampledState<Scalar>>& states_;
  const VisitOptions& options_;
  std::vector<FieldWay> left_;
};

std::string figure_text(double figure) {
  if (!std::isfinite(figure)) return "all digits";
  return fmt::format("loss {:.2g}, {:.1f} digits", figure, std::log10(figure));
}

}  // namespace

template <class Scalar>
void LossRecord::add(const FieldPlace& place, const Finding& finding, Visit<Scalar>& visit,
                     std::size_t at) {
  if (!finding.loss) return;
  const double figure = finding.loss->figure;
  const bool is_worst = figures_.samples() == 0 || figure > figures_.worst();
  figures_.add(figure, visit.state());
  if (figure <= tolerated_loss) return;
  has_loss_ = true;
  if (!is_worst) return;
  entry_ = finding.loss->entry;
  culprit_ = visit.culprit(place, entry_);
  worst_at_ = at;
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
  if (!has_loss()) return row;
  KeepingWays<Scalar> ways(place, subject, states, options);
  ways.ask(worst_at_);
  const std::string there = ways.left().empty() ? "" : std::string(ways.left().front().name);
  for (std::size_t at = 0; at < states.size(); ++at) ways.ask(at);
  row.verdict = ways.left().empty() ? Verdict::noted : Verdict::fails;
  row.worst = fmt::format("{} of entry {}, most of it in {}", figure_text(figures_.worst()),
                          entry_ + 1, equation_at(subject.program, *place.function, culprit_));
  if (!ways.left().empty()) {
    row.worst += fmt::format("; the {} keeps them", ways.left().front().name);
  } else if (there.empty()) {
    row.worst += "; no known way keeps them there";
  } else {
    row.worst += fmt::format("; the {} keeps them there, but not everywhere", there);
  }
  return row;
}

template void LossRecord::add(const FieldPlace&, const Finding&, Visit<double>&, std::size_t);
template void LossRecord::add(const FieldPlace&, const Finding&, Visit<float>&, std::size_t);
template CertificateRow LossRecord::row(const FieldPlace&, const Subject&,
                                        const std::vector<SampledState<double>>&,
                                        const VisitOptions&) const;
template CertificateRow LossRecord::row(const FieldPlace&, const Subject&,
                                        const std::vector<SampledState<float>>&,
                                        const VisitOptions&) const;

}  // namespace elgen
