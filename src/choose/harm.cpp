// harm: see harm.hpp.
#include "choose/harm.hpp"

#include <cmath>
#include <utility>

#include "lower/network/linearise.hpp"

namespace elgen {
namespace {

/// Rounding of a few more operations is no harm.
constexpr long most_harmless = 64;
/// Errors in double are right within a factor of two each.
constexpr double certainly_harmless = 16;

bool is_certainly_harmless(const RoughError& own, const RoughError& text) {
  return own.error <= certainly_harmless * std::max(text.error, std::abs(text.value));
}

bool is_harmed(const Running& own, const Running& text) {
  if (!text.error.is_defined()) return false;
  if (!own.error.is_defined()) return true;
  const Real allowed = max(text.error, abs(text.value)) * Real(cln::cl_I(most_harmless));
  return own.error.value() > allowed.value();
}

std::vector<Running> running_entries(const Program& program, const Function& function,
                                     const Arguments<double>& point) {
  const RunningErrorRules rules{running_leaves(point, Leaves::exact)};
  return entries_of(function, fold<Running>(rules, program, function));
}

std::vector<RoughError> rough_entries(const Program& program, const Function& function,
                                      const Arguments<double>& point) {
  return entries_of(function, fold<RoughError>(RoughRules{point}, program, function));
}

}  // namespace

TextErrors::TextErrors(const Program& program, const Function& text, ComparisonPoints points)
    : program_(program), text_(text), points_(std::move(points)) {
  for (const Arguments<double>& point : points_) {
    rough_.push_back(rough_entries(program, text, point));
  }
}

bool TextErrors::are_passed_by(const Expressions& way, std::size_t entry) const {
  Program program;
  Function function;
  function.fields = {Field{"", 1, 1, {0}}};
  linearise(make_network(way), program, function);
  for (std::size_t point = 0; point < points_.size(); ++point) {
    if (harmed(program, function, entry, point)) return true;
  }
  return false;
}

std::optional<std::size_t> TextErrors::harmed_entry(const Program& program,
                                                    const Function& form) const {
  for (std::size_t point = 0; point < points_.size(); ++point) {
    if (const auto entry = harmed(program, form, 0, point)) return entry;
  }
  return std::nullopt;
}

std::optional<std::size_t> TextErrors::harmed(const Program& program, const Function& form,
                                              std::size_t first, std::size_t point) const {
  const std::vector<RoughError> rough = rough_entries(program, form, points_[point]);
  std::optional<std::vector<Running>> exact;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    if (is_certainly_harmless(rough[i], rough_[point][first + i])) continue;
    if (!exact) exact = running_entries(program, form, points_[point]);
    if (is_harmed((*exact)[i], exact_text(point)[first + i])) return first + i;
  }
  return std::nullopt;
}

const std::vector<Running>& TextErrors::exact_text(std::size_t point) const {
  const auto known = exact_.find(point);
  if (known != exact_.end()) return known->second;
  return exact_.emplace(point, running_entries(program_, text_, points_[point])).first->second;
}

}  // namespace elgen
