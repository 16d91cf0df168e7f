// Energies with cancelling sums (energies.txt). Compares the digits of three forms in double: the
// emitted programs, the user's text (the recursive form), and stable forms.
#include "choose/energies.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>

#include "accuracy/running_errors.hpp"
#include "choose/energy_errors.hpp"
#include "elgen/evaluate.hpp"
#include "elgen/oracle.hpp"
#include "elgen/scalars.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

/// A form is as accurate as another form if its error is at most this multiple of the other error.
constexpr double max_error_ratio = 64;
/// In u. A stable form with a larger error is no reference for other forms.
constexpr double max_stable_error = 32;

/// x to the power `exponent`, a multiple of 1/2, computed by multiplications and a square root.
double power_in_double(double x, const cln::cl_RA& exponent) {
  const long halves = cln::cl_I_to_long(cln::numerator(exponent * 2));
  double result = 1;
  for (long i = 0; i < std::abs(halves) / 2; ++i) result *= x;
  if (halves % 2 != 0) result *= std::sqrt(x);
  return halves < 0 ? 1 / result : result;
}

/// Evaluates expressions of the model in double, in the order of the user's text.
class TextEvaluator {
 public:
  TextEvaluator(const Model& model, const Arguments<double>& at) : model_(model), at_(at) {}

  [[nodiscard]] double operator()(ExpressionId id) const {
    const Expression& e = model_.expressions[id];
    switch (e.kind) {
      case ExpressionKind::number:
        return to_double(e.number);
      case ExpressionKind::leaf:
        return leaf_of(at_, e.leaf, e.index);
      case ExpressionKind::negate:
        return -operand(e, 0);
      case ExpressionKind::add:
        return folded(e, [](double x, double y) { return x + y; });
      case ExpressionKind::multiply:
        return folded(e, [](double x, double y) { return x * y; });
      case ExpressionKind::divide:
        return operand(e, 0) / operand(e, 1);
      case ExpressionKind::power:
        return power_in_double(operand(e, 0), e.number);
      case ExpressionKind::function:
        return interpreter::call(e.function, operand(e, 0), operand(e, e.operands.size() - 1));
      default:
        throw std::runtime_error("a stable form is made of numbers, leaves and functions");
    }
  }

 private:
  [[nodiscard]] double operand(const Expression& e, std::size_t i) const {
    return (*this)(e.operands.at(i));
  }

  template <class Operation>
  [[nodiscard]] double folded(const Expression& e, const Operation& operation) const {
    double result = operand(e, 0);
    for (std::size_t i = 1; i < e.operands.size(); ++i) result = operation(result, operand(e, i));
    return result;
  }

  const Model& model_;
  const Arguments<double>& at_;
};

/// |x - x*|/(u |x*|), u = 2^-53. A wrong x has an infinite error if x* is 0.
double error_in_u(double x, const cln::cl_R& exact) {
  const bool is_zero = cln::zerop(exact);
  if (is_zero && x == 0) return 0;
  if (is_zero || !std::isfinite(x)) return std::numeric_limits<double>::infinity();
  const cln::cl_R error = cln::abs(exact_value(x) - exact) / cln::abs(exact);
  return std::ldexp(to_double(error), 53);
}

/// Errors of one entry in u; no `stable` if no stable form is known.
struct EntryErrors {
  std::optional<double> stable = {};
  double text = 0;
  double emitted = 0;
};

void update_maxima(std::vector<EntryErrors>& worst, const std::vector<EntryErrors>& others) {
  worst.resize(others.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (others[i].stable) {
      worst[i].stable = std::max(worst[i].stable.value_or(0), *others[i].stable);
    }
    worst[i].text = std::max(worst[i].text, others[i].text);
    worst[i].emitted = std::max(worst[i].emitted, others[i].emitted);
  }
}

/// error/max(other, 1); 0 if `other` is infinite.
double error_ratio(double error, double other) {
  return std::isinf(other) ? 0 : error / std::max(other, 1.0);
}

std::vector<double> entries_at(const Program& program, const Arguments<double>& at) {
  std::vector<double> entries;
  for (const Function& function : program.functions) {
    for (const double entry : evaluate(program, function, at)) entries.push_back(entry);
  }
  return entries;
}

/// Bounds on the errors in u of code that computes in `inner` and rounds the results to double:
/// u |x*| + u' E, with the running errors E and half the epsilon u' of `inner`.
std::vector<double> wide_errors_at(const ChosenForms& chosen, const Arguments<double>& at,
                                   InnerScalar inner) {
  const Program& program = chosen.choice.program;
  const RunningErrorRules<Real> rules{running_leaves<Real>(at, LeafRounding::exact)};
  const double ratio = std::ldexp(inner_scalar_row(inner).roundoff, 53);
  std::vector<double> errors;
  for (const Function& function : program.functions) {
    for (const auto& [value, error, is_lost, underflows] :
         entries_of(function, fold<RunningValue<Real>>(rules, program, function))) {
      const bool has_bound = !is_lost && !is_zero(value);
      const double relative = has_bound ? to_double((error / abs(value)).value())
                              : is_zero(value) && is_zero(error)
                                  ? 0
                                  : std::numeric_limits<double>::infinity();
      errors.push_back(1 + ratio * relative);
    }
  }
  return errors;
}

std::vector<cln::cl_R> exact_entries(const CheckedModel& checked, const State& state) {
  std::vector<cln::cl_R> entries;
  for (const OutputRequest& output : checked.scene.outputs) {
    const OracleValues values = oracle_values(checked.model, output, state);
    REQUIRE(values);
    entries.insert(entries.end(), values->begin(), values->end());
  }
  return entries;
}

/// The stable forms, in the order of the entries of gravity and V.
std::vector<ExpressionId> stable_forms(const Model& model) {
  std::vector<ExpressionId> forms;
  for (const UserOutput& output : model.outputs) {
    forms.insert(forms.end(), output.values.begin(), output.values.end());
  }
  return forms;
}

/// The errors of gravity and V at `q`, if code computes in `inner`. Checks that stable forms equal
/// gravity and V to 25 digits.
std::vector<EntryErrors> errors_at(const ChosenForms& chosen, const std::vector<double>& q,
                                   InnerScalar inner) {
  const Model& model = chosen.checked.model;
  const State state = state_in_double(chosen.checked, q);
  const auto arguments = arguments_at<double>(state);
  const TextEvaluator text_value(model, arguments);
  const std::vector<cln::cl_R> exact = exact_entries(chosen.checked, state);
  const std::vector<double> text = entries_at(chosen.recursive, arguments);
  const std::vector<double> emitted = entries_at(chosen.choice.program, arguments);
  const std::vector<ExpressionId> stable = stable_forms(model);
  REQUIRE(text.size() == exact.size());
  REQUIRE(emitted.size() == exact.size());
  std::vector<EntryErrors> errors;
  const bool is_wide = inner != InnerScalar::same;
  const std::vector<double> wide =
      is_wide ? wide_errors_at(chosen, arguments, inner) : std::vector<double>();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    errors.push_back(
        {{}, error_in_u(text[i], exact[i]), is_wide ? wide[i] : error_in_u(emitted[i], exact[i])});
    if (i >= stable.size()) continue;
    errors[i].stable = error_in_u(text_value(stable[i]), exact[i]);
    const std::optional<cln::cl_R> same = oracle_expression_value(model, stable[i], state);
    REQUIRE(same);
    CHECK((cln::abs(*same - exact[i]) <= cln::abs(exact[i]) * power_of_ten(-25)));
  }
  return errors;
}

struct EnergyErrors {
  std::vector<EntryErrors> entries = {};  ///< gravity, then V: the maximum over all states
  /// The largest ratio of the emitted program's error to the text's error, and to the stable form's
  /// error. Each error is the maximum over the states at one distance from one place, since a
  /// single state may have a small error by chance.
  double ratio_to_text = 0;
  double ratio_to_stable = 0;
};

EnergyErrors errors_of(const TypedEnergy& energy, InnerScalar inner = InnerScalar::same) {
  const ChosenForms c = chosen_energy(energy, inner);
  EnergyErrors result;
  for (const std::string& line : energy.near) {
    const StatesNear states(c.checked.model, line);
    for (const double distance : {1e-1, 1e-2, 1e-4, 1e-8}) {
      std::vector<EntryErrors> worst;
      for (const std::vector<double>& q : states.at(distance))
        update_maxima(worst, errors_at(c, q, inner));
      REQUIRE_FALSE(worst.empty());
      update_maxima(result.entries, worst);
      for (const EntryErrors& e : worst) {
        result.ratio_to_text = std::max(result.ratio_to_text, error_ratio(e.emitted, e.text));
        if (!e.stable) continue;
        result.ratio_to_stable =
            std::max(result.ratio_to_stable, error_ratio(e.emitted, *e.stable));
      }
    }
  }
  return result;
}

std::string figure(std::optional<double> error) {
  if (!error) return "-";
  return *error < 1e4 ? fmt::format("{:.1f}", *error) : fmt::format("{:.1e}", *error);
}

/// A line for each entry: its errors in u, and "*" if the emitted error exceeds max_error_ratio
/// times the error of the stable form.
std::string table_rows(const TypedEnergy& energy, const EnergyErrors& errors) {
  std::string rows;
  for (std::size_t i = 0; i < errors.entries.size(); ++i) {
    const EntryErrors& e = errors.entries[i];
    const std::string entry =
        i + 1 < errors.entries.size() ? fmt::format("gravity[{}]", i + 1) : "V";
    const bool is_near = error_ratio(e.emitted, e.stable.value_or(e.emitted)) <= max_error_ratio;
    rows += fmt::format("{:<30} {:<10} {:>8} {:>8} {:>8} {}\n", energy.name, entry,
                        figure(e.stable), figure(e.text), figure(e.emitted), is_near ? "" : "*");
  }
  return rows;
}

}  // namespace

TEST_CASE("energies keep the digits of their texts, and most keep the digits of stable forms") {
  const std::vector<TypedEnergy> energies = typed_energies();
  REQUIRE_FALSE(energies.empty());
  std::string table = fmt::format("{:<30} {:<10} {:>8} {:>8} {:>8}   errors in u\n", "energy",
                                  "entry", "stable", "text", "emitted");
  std::size_t near_stable = 0;
  for (const TypedEnergy& energy : energies) {
    INFO(energy.name);
    const EnergyErrors errors = errors_of(energy);
    for (const EntryErrors& e : errors.entries) CHECK(e.stable.value_or(0) <= max_stable_error);
    CHECK(errors.ratio_to_text <= max_error_ratio);
    if (errors.ratio_to_stable <= max_error_ratio) ++near_stable;
    table += table_rows(energy, errors);
  }
  CHECK(near_stable >= energies.size() * 95 / 100);
  if (std::getenv("ELGEN_ENERGIES") != nullptr) {
    std::cout << table << near_stable << " energies within " << max_error_ratio
              << " times the error of the stable form\n";
  }
}

TEST_CASE("most energies keep the digits of stable forms if code computes in double-double") {
  const std::vector<TypedEnergy> energies = typed_energies();
  std::string table;
  std::size_t near_stable = 0;
  for (const TypedEnergy& energy : energies) {
    INFO(energy.name);
    const EnergyErrors errors = errors_of(energy, InnerScalar::double_double);
    if (errors.ratio_to_stable <= max_error_ratio) ++near_stable;
    table += table_rows(energy, errors);
  }
  CHECK(near_stable >= energies.size() * 95 / 100);
  if (std::getenv("ELGEN_ENERGIES") != nullptr) {
    std::cout << table << near_stable << " energies within " << max_error_ratio
              << " times the error of the stable form, in double-double\n";
  }
}
