// Compares errors of emitted values with the running errors of the users' texts, for all energies
// of energies.txt. States are at rest: the origin, zeros of typed sums and points near them down to
// a distance of 1e-150, and random points inside the ranges.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "accuracy/conditioning.hpp"
#include "accuracy/running_errors.hpp"
#include "choose/energy_errors.hpp"
#include "numbers/more_digits.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// The bound on |x - x*|/u of an emitted entry, as a multiple of E + R. E is the running error of
/// the text. R is |x*| plus the absolute condition of the entry (accuracy/conditioning.hpp).
constexpr double max_multiple = 16;
constexpr std::size_t min_states = 10'000;

/// The largest multiple (see max_multiple), and a description of the entry and the state.
struct WorstEntry {
  double multiple = 0;
  std::string words = {};
};

/// The error as a multiple of `bound`, after subtracting one denormal for each operation; none if
/// the text has no bound.
std::optional<double> error_multiple(double x, const cln::cl_R& exact, const Real& bound,
                                     std::size_t operations) {
  const RoundingConstants<Real>& of_double = rounding_constants<double, Real>();
  if (!bound.is_defined()) return std::nullopt;
  if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
  const Real denormals =
      Real(cln::cl_I(static_cast<unsigned long>(operations))) * of_double.underflow;
  const Real error = abs(Real(exact_value(x) - exact)) / of_double.roundoff;
  if (error <= denormals) return 0;
  const Real multiple = (error - denormals) / bound;
  if (!multiple.is_defined()) return std::numeric_limits<double>::infinity();
  return to_double(multiple.value());
}

/// Updates `worst`. False if the text of the function has no bound, or no value in double or in
/// exact arithmetic.
bool update_worst(const ChosenForms& c, std::size_t index, const State& state, WorstEntry& worst) {
  const Function& text = c.recursive.functions.at(index);
  const SystemUnderTest subject{c.checked.model, c.checked.scene, c.choice.program};
  const auto values = [&] {
    return oracle_values(subject.model, subject.scene.outputs.at(index), state);
  };
  OracleValues exact = values();
  const auto is_zero = [](const cln::cl_R& x) { return cln::zerop(x); };
  // In 60 digits 1 + tan(1e-150)^2 - 1 would be 0.
  if (exact && std::ranges::any_of(*exact, is_zero)) exact = with_digits(700, values);
  if (!exact) return false;
  const auto point = arguments_at<double>(state);
  const RunningErrorRules<Real> rules{running_leaves<Real>(point, LeafRounding::exact)};
  const auto running = fold<RunningValue<Real>>(rules, c.recursive, text);
  const Conditioning conditioning(c.recursive, text, values_of(running));
  const std::vector<double> typed = evaluate(c.recursive, text, point);
  const auto emitted = evaluate(subject.program, subject.program.functions.at(index), point);
  const std::vector<std::uint32_t> entries = entries_of(text);
  REQUIRE(exact->size() == entries.size());
  REQUIRE(emitted.size() == entries.size());
  bool is_judged = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const cln::cl_R& x = (*exact)[i];
    const Real bound =
        running[entries[i]].error + abs(Real(x)) + conditioning.absolute_condition(entries[i]);
    const auto multiple = error_multiple(emitted[i], x, bound, text.instructions.size());
    if (!std::isfinite(typed[i]) || !multiple) continue;
    is_judged = true;
    if (*multiple <= worst.multiple) continue;
    worst = {*multiple,
             fmt::format("{}[{}] is {}, its text {}, {} exactly, E + R {}; {}", text.name, i + 1,
                         emitted[i], typed[i], short_number_text(x),
                         short_number_text(bound.value()), describe_state_exactly(subject, state))};
  }
  return is_judged;
}

}  // namespace

TEST_CASE(
    "the error of an emitted energy or force is at most 16 times the error of its text plus u R") {
  std::size_t states = 0;
  for (const TypedEnergy& energy : typed_energies()) {
    const ChosenForms c = chosen_energy(energy);
    WorstEntry worst;
    for (const std::vector<double>& q : SampleStates(energy, c).all) {
      const State state = state_in_double(c.checked, q);
      const bool has_force = update_worst(c, 0, state, worst);
      const bool has_energy = update_worst(c, 1, state, worst);
      states += has_force || has_energy ? 1 : 0;
    }
    INFO(energy.name << ": " << worst.words);
    CHECK(worst.multiple <= max_multiple);
  }
  CHECK(states >= min_states);
}
