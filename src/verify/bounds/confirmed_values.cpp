// Confirms the fields of an exact run one by one. Entries that are small against the rounding
// errors of their field are confirmed only as zeros.
#include "verify/bounds/confirmed_values.hpp"

#include <algorithm>

#include "numbers/more_digits.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/projection.hpp"

namespace elgen {
namespace {

/// A projection agrees to 50 digits of the errors of its field. An entry of this share of them has
/// 30 of these digits; an ill-conditioned M may take a third of them.
const Real& least_share() {
  static const Real share(power_of_ten(-20));
  return share;
}

/// Digits in addition, and the factor by which rounding errors shrink at least with so many digits.
constexpr unsigned more_digits = 60;
const Real& shrink_ratio() {
  static const Real ratio(power_of_ten(-20));
  return ratio;
}

}  // namespace

std::optional<std::vector<cln::cl_R>> confirmed_values(const SystemUnderTest& subject,
                                                       std::size_t function, const State& state,
                                                       const ExactRun& run) {
  if (run.regime != Regime::regular) return std::nullopt;
  OracleCache oracle(subject, state);
  Sampler draw(1);
  std::optional<ExactRun> longer;
  const auto is_rounding_error = [&](std::size_t entry) {
    const RunningValue<Real>& own = run.entries[entry];
    if (is_zero(own.error)) return is_zero(own.value);
    if (!longer) {
      longer = with_digits(more_digits, [&] {
        return run_exactly(subject.program, subject.program.functions[function], state,
                           rounding_constants<double>());
      });
    }
    return abs(longer->entries[entry].value) <= abs(own.value) * shrink_ratio();
  };
  std::vector<cln::cl_R> values;
  for (const ComparedField& place : compared_fields(subject, function)) {
    const std::optional<Mismatch> mismatch = compare_projection(subject, place, run, oracle, draw);
    if (!mismatch || !mismatch->text.empty()) return std::nullopt;
    Real scale(oracle.used_scale());
    for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
      scale = scale + run.entries[place.first_entry + i].error;
    }
    for (std::size_t i = 0; i < place.field().entries.size(); ++i) {
      const Real& value = run.entries[place.first_entry + i].value;
      const bool is_large = abs(value) > scale * least_share();
      if (!is_large && !is_rounding_error(place.first_entry + i)) return std::nullopt;
      values.push_back(is_large ? cln::cl_R(value.value()) : cln::cl_R(0));
    }
  }
  return values;
}

}  // namespace elgen
