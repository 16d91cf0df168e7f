// text_errors: see text_errors.hpp.
#include "choose/text_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/exact_number.hpp"
#include "program/network/linearise.hpp"

namespace elgen {
namespace {

/// A form may have this many times the error of the recursive form, the text: the rounding errors
/// of a few more operations are accepted. V and its derivatives are stricter. In functions of M,
/// this would cost up to 1.9 times as much, because cos(a - b) is split near a = pi/2, b = 0. With
/// 16, products of many factors are refused: (a^6 - b^6)^2 has an error bound of 17.
constexpr long accurate_ratio_of_potential = 32;
constexpr long accurate_ratio_of_motion = 64;
/// An error computed in double is right within a factor of two. A ratio of two such errors up to a
/// quarter of the accepted ratio is therefore certainly accepted.
constexpr double certain_share = 0.25;

long accurate_ratio(const Function& text) {
  return is_potential_or_gravity(text) ? accurate_ratio_of_potential : accurate_ratio_of_motion;
}

constexpr double unit_roundoff = 0x1p-53;
/// Two values in double count as equal if their difference is at most this many times the sum of
/// their error bounds.
constexpr double certainly_equal = 4;
/// A value in double whose relative error is at most this is precise enough as the magnitude |x|.
constexpr double max_certain_error = 0x1p-10;

bool is_certainly_accurate(const RunningValue<double>& own, const RunningValue<double>& text,
                           long ratio) {
  const double certain_ratio = certain_share * static_cast<double>(ratio);
  const double apart = std::abs(own.value - text.value);
  return !own.is_lost && !text.is_lost &&
         own.error <= certain_ratio * std::max(text.error, std::abs(text.value)) &&
         apart <= certainly_equal * unit_roundoff * (own.error + text.error);
}

/// True if a rewriting and the text have different values: a rewriting may equal the text on only
/// one side of a branch.
bool has_different_value(const RunningValue<Real>& own, const RunningValue<Real>& text) {
  static const Real negligible(power_of_ten(-45));
  const Real scale = own.error + text.error + abs(text.value);
  return abs(own.value - text.value).value() > (scale * negligible).value();
}

bool is_inaccurate(const RunningValue<Real>& own, const RunningValue<Real>& text, long ratio) {
  if (!text.error.is_defined()) return false;
  if (!own.error.is_defined() || has_different_value(own, text)) return true;
  const Real allowed = max(text.error, abs(text.value)) * Real(cln::cl_I(ratio));
  return own.error.value() > allowed.value();
}

/// The running errors of the entries of a function. Number is Real, or double for rough errors.
template <class Number>
std::vector<RunningValue<Number>> running_entries(const Program& program, const Function& function,
                                                  const RunningErrorRules<Number>& rules) {
  return entries_of(function, fold<RunningValue<Number>>(rules, program, function));
}

std::vector<RunningValue<Real>> exact_entries(const Program& program, const Function& function,
                                              const Arguments<double>& point) {
  const RunningErrorRules<Real> rules{running_leaves<Real>(point, LeafRounding::exact)};
  return running_entries(program, function, rules);
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// x in double; NaN if x is undefined.
double to_double_or_nan(const Real& x) {
  return x.is_defined() ? to_double(x.value()) : not_a_number;
}

/// The loss at a point: 0 if the text has no value there, infinite if only the text has a value. At
/// an exact zero, every error is infinitely larger than the value; points near the zero decide.
double loss_ratio(double error, double magnitude, double least) {
  if (std::isnan(magnitude)) return 0;
  if (std::isnan(error)) return std::numeric_limits<double>::infinity();
  if (magnitude == 0) return 0;
  return error / (least > magnitude ? least : magnitude);
}

}  // namespace

bool is_potential_or_gravity(const Function& text) {
  return text.kind == OutputKind::potential_energy || text.kind == OutputKind::gravity;
}

bool loses_more(double loss, double other, double tolerated) {
  return loss > std::max(tolerated, loss_equality_factor * other);
}

FormErrors::FormErrors(const Program& program, const Function& text, Points points,
                       MagnitudeScope scale)
    : program_(program), text_(text), points_(std::move(points)) {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    rules_.push_back({running_leaves<double>(points_[point], LeafRounding::exact)});
    rough_entries_.push_back(running_entries(program, text, rules_[point]));
    magnitudes_.push_back(magnitudes_at(point, scale));
    least_errors_.push_back(errors_at(program, text, point, rough_entries_[point]));
  }
}

/// The magnitude |x| of each entry; NaN if the text in double overflows. A value of the text is
/// recomputed in 64 digits if its relative error in double is above max_certain_error.
std::vector<double> FormErrors::magnitudes_at(std::size_t point, MagnitudeScope scale) const {
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < rough_entries_[point].size(); ++i) {
    const RunningValue<double>& rough = rough_entries_[point][i];
    const double size = std::isfinite(rough.value) ? std::abs(rough.value) : not_a_number;
    const bool is_certain =
        !rough.is_lost && rough.error * unit_roundoff <= max_certain_error * size;
    magnitudes.push_back(is_certain || std::isnan(size)
                             ? size
                             : to_double_or_nan(exact_recursive_entries(point)[i].value));
  }
  if (scale == MagnitudeScope::entry) return magnitudes;
  auto begin = magnitudes.begin();
  for (const Field& field : text_.fields) {
    const auto end = begin + static_cast<std::ptrdiff_t>(field.entries.size());
    double largest = 0;
    for (auto at = begin; at != end; ++at) largest = std::max(largest, std::isnan(*at) ? 0 : *at);
    for (auto at = begin; at != end; ++at) *at = std::isnan(*at) ? *at : largest;
    begin = end;
  }
  return magnitudes;
}

std::vector<double> FormErrors::errors_at(const Program& program, const Function& form,
                                          std::size_t point, const RoughEntries& rough) const {
  std::vector<double> errors;
  std::optional<std::vector<RunningValue<Real>>> exact;
  for (const RunningValue<double>& entry : rough) {
    const std::size_t i = errors.size();
    errors.push_back(entry.error);
    if (!entry.is_lost && std::isfinite(entry.error)) continue;
    if (!exact) exact = exact_entries(program, form, points_[point]);
    errors.back() = to_double_or_nan((*exact)[i].error);
  }
  return errors;
}

std::vector<double> FormErrors::errors_at(const Program& program, const Function& form,
                                          std::size_t point) const {
  return errors_at(program, form, point, running_entries(program, form, rules_[point]));
}

ErrorsAtPoints FormErrors::errors_of(const Expressions& rewriting) const {
  const LinearisedNetwork one(make_network(rewriting));
  ErrorsAtPoints errors;
  for (std::size_t point = 0; point < points_.size(); ++point) {
    errors.push_back(errors_at(one.program, one.function, point).front());
  }
  return errors;
}

std::optional<ErrorsAtPoints> FormErrors::errors_if_accurate(const Expressions& rewriting,
                                                             std::size_t entry) const {
  const auto [program, function] = LinearisedNetwork(make_network(rewriting));
  ErrorsAtPoints errors;
  for (std::size_t point = 0; point < points_.size(); ++point) {
    const RoughEntries rough = running_entries(program, function, rules_[point]);
    if (first_inaccurate_entry_at(program, function, point, rough, entry)) return std::nullopt;
    errors.push_back(errors_at(program, function, point, rough).front());
  }
  return errors;
}

bool FormErrors::may_lose_digits(const ErrorsAtPoints& errors, std::size_t entry) const {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    const double magnitude = magnitudes_[point][entry];
    if (errors[point] > tolerated_loss * magnitude) return true;
  }
  return false;
}

void FormErrors::add_rewriting(const ErrorsAtPoints& errors, std::size_t entry) {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    double& least = least_errors_[point][entry];
    if (errors[point] < least) least = errors[point];
  }
}

void FormErrors::add_form(const Program& program, const Function& form) {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    const std::vector<double> errors = errors_at(program, form, point);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      least_errors_[point][i] = std::min(least_errors_[point][i], errors[i]);
    }
  }
}

double FormErrors::loss_of(const ErrorsAtPoints& errors, std::size_t entry) const {
  double loss = 0;
  for (std::size_t point = 0; point < points_.size(); ++point) {
    loss = std::max(
        loss, loss_ratio(errors[point], magnitudes_[point][entry], least_errors_[point][entry]));
  }
  return loss;
}

double FormErrors::worst_loss(const Program& program, const Function& form) const {
  double loss = 0;
  for (std::size_t point = 0; point < points_.size(); ++point) {
    const std::vector<double> errors = errors_at(program, form, point);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      loss = std::max(loss, loss_ratio(errors[i], magnitudes_[point][i], least_errors_[point][i]));
    }
  }
  return loss;
}

std::optional<std::size_t> FormErrors::first_inaccurate_entry(const Program& program,
                                                              const Function& form) const {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    const RoughEntries rough = running_entries(program, form, rules_[point]);
    if (const auto entry = first_inaccurate_entry_at(program, form, point, rough, 0)) return entry;
  }
  return std::nullopt;
}

std::optional<std::size_t> FormErrors::first_inaccurate_entry_at(const Program& program,
                                                                 const Function& form,
                                                                 std::size_t point,
                                                                 const RoughEntries& rough,
                                                                 std::size_t first) const {
  const long ratio = accurate_ratio(text_);
  std::optional<std::vector<RunningValue<Real>>> exact;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    const RunningValue<double>& rough_text = rough_entries_[point][first + i];
    if (!std::isfinite(rough_text.value)) continue;
    if (!std::isfinite(rough[i].value)) return first + i;
    if (is_certainly_accurate(rough[i], rough_text, ratio)) continue;
    if (!exact) exact = exact_entries(program, form, points_[point]);
    const RunningValue<Real>& text = exact_recursive_entries(point)[first + i];
    if (is_inaccurate((*exact)[i], text, ratio)) return first + i;
  }
  return std::nullopt;
}

const std::vector<RunningValue<Real>>& FormErrors::exact_recursive_entries(
    std::size_t point) const {
  const auto known = exact_entries_.find(point);
  if (known != exact_entries_.end()) return known->second;
  return exact_entries_.emplace(point, exact_entries(program_, text_, points_[point]))
      .first->second;
}

}  // namespace elgen
