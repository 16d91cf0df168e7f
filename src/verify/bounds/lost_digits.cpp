// lost digits: the logarithm of the worst losses.
#include "verify/bounds/lost_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace elgen {
namespace {

std::string name_of_entry(const FieldPlace& place, std::size_t entry) {
  const Field& field = place.field();
  const std::string name = place.function->name + (field.name.empty() ? "" : "." + field.name);
  if (field.entries.size() == 1) return name;
  const std::size_t row = entry / field.columns + 1;
  if (field.columns == 1) return fmt::format("{}[{}]", name, row);
  return fmt::format("{}[{},{}]", name, row, entry % field.columns + 1);
}

/// Of a loss of so many u.
double digits_of(double figure) { return figure > 1 ? std::log10(figure) : 0; }

}  // namespace

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

CertificateRow LostDigits::row(double digits) const {
  CertificateRow row;
  row.check = "digits lost";
  row.formula =
      "log10 of |x - x*| / (u R), R = |x*| + K, K = sum |z dx/dz| over inputs, parameters and "
      "literals: what their own rounding costs; in brackets of |x - x*| / (u max |x*|) of a field";
  row.samples = states_;
  row.loss = of_entry_.figure;
  row.loss_of_field = of_field_.figure;
  const double of_field = digits_of(of_field_.figure);
  const bool is_grave = of_field > digits / 2;
  const Worst& told = is_grave ? of_field_ : of_entry_;
  row.worst =
      fmt::format("{:.1f} digits{} (of the largest entry {:.1f})", digits_of(of_entry_.figure),
                  of_entry_.entry.empty() ? "" : " of " + of_entry_.entry, of_field);
  if (is_grave && of_field_.entry != of_entry_.entry) row.worst += ", in " + of_field_.entry;
  row.where = told.where;
  row.tolerance = fmt::format(
      "a figure; noted beyond {:.1f} of the {:.1f} digits of the scalar, of "
      "the largest entry of a field",
      digits / 2, digits);
  row.verdict = is_grave ? Verdict::noted : Verdict::holds;
  return row;
}

}  // namespace elgen
