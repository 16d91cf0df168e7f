// Compares compiled code with the interpreter, bit by bit. Both execute the same operations in the
// same order on one machine, with one libm and without contraction. So all bits must agree, for any
// optimisation and any width of packs. With contraction, the bits of a polynomial differ, but its
// error bound still holds.
#include "verify/compiled_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

#include "accuracy/running_errors.hpp"
#include "base/ascii.hpp"
#include "elgen/fold.hpp"
#include "emit/interface/code_interface.hpp"
#include "program/evaluate/sines.hpp"
#include "verify/bounds/exact_run.hpp"

namespace elgen {
namespace {

template <class Scalar>
bool has_same_bits(Scalar x, Scalar y) {
  if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
  return x == y && std::signbit(x) == std::signbit(y);
}

/// The kind of code in words: "float, batch, -O3 -march=native"; `first`: its first word.
std::string code_kind_text(const CompiledHeader& compiled, std::string_view first) {
  std::string text(first);
  const auto add = [&text](std::string_view word) {
    if (!text.empty() && !word.empty()) text += ", ";
    text += word;
  };
  add(compiled.types);
  if (compiled.build != BuildFlags::as_written) add("-O3 -march=native");
  if (compiled.build == BuildFlags::user_flags) add("contraction on");
  return text;
}

/// The permitted error of compiled code, in u of the largest entry of the field. 0: all bits must
/// agree. At least 4 if the function calls a library function that the language's interpreter
/// (Python, for example) implements itself.
double allowed_roundings(const CompiledHeader& compiled, const Function& function) {
  const bool calls_own = std::ranges::any_of(function.instructions, [&](const Instruction& i) {
    return i.opcode == Opcode::call &&
           has_word(compiled.own_implementations, function_row(i.function).name);
  });
  constexpr double of_own = 4;  // the interpreter and libm are each off by up to 1 ulp = 2 u
  return calls_own ? std::max<double>(of_own, compiled.roundings) : compiled.roundings;
}

/// The running errors of all entries, in u; infinite if an error has no bound. Zeros if `most` is 0
/// or Scalar is float. Needed for interpreters with their own library functions, because cancelling
/// sums magnify the difference of both libraries.
template <class Scalar>
std::vector<double> running_errors(const SystemUnderTest& subject, const Function& function,
                                   const Arguments<Scalar>& at, double most) {
  std::vector<double> errors(entry_count(function));
  if constexpr (std::is_same_v<Scalar, double>) {
    if (most == 0) return errors;
    const RunningErrorRules<double> rules{running_leaves<double>(at, LeafRounding::exact)};
    const auto entries =
        entries_of(function, fold<RunningValue<double>>(rules, subject.program, function));
    std::ranges::transform(entries, errors.begin(), [](const RunningValue<double>& entry) {
      return entry.is_lost ? std::numeric_limits<double>::infinity() : entry.error;
    });
  }
  return errors;
}

/// The number of entries of `given` whose bits differ from `expected` and whose difference exceeds
/// both `most` u of the field's largest entry and `most` times the entry's running error. `given`
/// is empty if the code threw an exception; then the result is 0 if some expected value is not
/// finite.
template <class Scalar>
std::size_t count_differing_entries(const Function& function, const std::vector<Scalar>& given,
                                    const std::vector<Scalar>& expected,
                                    const std::vector<double>& errors, double most) {
  const auto is_finite = [](Scalar x) { return std::isfinite(x); };
  if (given.empty() && !std::ranges::all_of(expected, is_finite)) return 0;
  if (given.size() != expected.size()) return std::max(given.size(), expected.size());
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
  std::size_t count = 0;
  std::size_t i = 0;
  for (const Field& field : function.fields) {
    const std::size_t end = i + field.entries.size();
    double largest = 0;
    for (std::size_t k = i; k < end; ++k) {
      largest = std::max<double>(largest, std::abs(expected[k]));
    }
    for (; i < end; ++i) {
      const double error = std::abs(given[i] - expected[i]);
      const double allowed = most * unit_roundoff * std::max(largest, errors[i]);
      // If a pivot is pure rounding error, one library may give a number and the other NaN.
      const bool is_known = std::isfinite(errors[i]);
      const bool is_near = most > 0 && (!is_known || error <= allowed);
      if (!is_near && !has_same_bits(given[i], expected[i])) ++count;
    }
  }
  return count;
}

std::string tolerance_text(const CompiledHeader& compiled, double most) {
  if (most > 0) {
    return fmt::format(
        "{0} u of the largest entry, or {0} times the running error: the interpreter has its own "
        "code for the functions of the library",
        most);
  }
  return compiled.is_in_packs ? "exact: same operations, same order, no contraction, the requested "
                                "polynomials"
                              : "exact: same operations, same order, no contraction, one libm";
}

template <class Scalar>
CertificateRow compiled_row(const SystemUnderTest& subject, const CompiledHeader& compiled,
                            const Function& function,
                            const std::vector<SampledState<Scalar>>& states,
                            const std::vector<std::vector<Scalar>>& values) {
  const SineEvaluator<Scalar> sines(
      subject.scene, compiled.is_in_packs ? SineArithmetic::packs : SineArithmetic::numbers);
  const double most = allowed_roundings(compiled, function);
  std::size_t wrong = 0;
  std::size_t entries = 0;
  std::string where;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto expected = evaluate_as_emitted(subject.program, function, states[i].values, sines);
    const auto errors = running_errors(subject, function, states[i].values, most);
    const std::size_t count = count_differing_entries(function, values[i], expected, errors, most);
    if (wrong == 0 && count > 0)
      where = describe_state(subject, exact_state(subject, states[i].values));
    wrong += count;
    entries += expected.size();
  }
  CertificateRow row;
  row.check = "compiled code vs program";
  row.output = function.name;
  row.subject =
      fmt::format("{} ({})", function.name, code_kind_text(compiled, name_of(scalar_kind<Scalar>)));
  row.formula = "same bits";
  row.samples = states.size();
  row.worst_value = fmt::format("{} of {} entries differ", wrong, entries);
  row.worst_state = where;
  row.tolerance = tolerance_text(compiled, most);
  row.verdict = wrong == 0 ? Verdict::holds : Verdict::fails;
  return row;
}

/// max(|s - sin x|, |c - cos x|) for x = `angle`; s and c are the values of the code. Infinite if s
/// or c is not finite.
template <class Scalar>
double error_of_sines(const CompiledModel& functions, Scalar angle) {
  Arguments<Scalar> arguments;
  arguments.t = angle;
  const std::vector<Scalar> values = functions.call(sine_and_cosine, arguments);
  const Real exact{exact_value(static_cast<double>(angle))};
  const std::array<Real, 2> truths{sin(exact), cos(exact)};
  if (values.size() != truths.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    if (!std::isfinite(values[i])) return std::numeric_limits<double>::infinity();
    const Real error = abs(Real(exact_value(static_cast<double>(values[i]))) - truths[i]);
    largest = std::max(largest, to_double(error.value()));
  }
  return largest;
}

template <class Scalar>
CertificateRow sine_row(const SystemUnderTest& subject, const CompiledHeader& compiled) {
  constexpr ScalarKind scalar = scalar_kind<Scalar>;
  constexpr std::size_t angles = 256;
  const double domain = angle_reduction(scalar).domain;
  const double most = to_double(trigonometry_error(subject.scene.numerics, scalar));
  constexpr double golden = 0.6180339887498949;
  double worst = 0;
  Scalar at = 0;
  for (std::size_t i = 0; i < angles; ++i) {
    const double place = 2 * std::fmod(golden * static_cast<double>(i), 1.0) - 1;
    const auto angle = static_cast<Scalar>(place * (i % 2 == 0 ? 4 : domain));
    const double error = error_of_sines(*compiled.functions, angle);
    if (error <= worst) continue;
    worst = error;
    at = angle;
  }
  CertificateRow row;
  row.check = row.output = "sines of packs";
  row.subject = fmt::format("sine and cosine ({})", code_kind_text(compiled, name_of(scalar)));
  row.formula = fmt::format("|s - sin x|, |c - cos x| in 64 digits, |x| <= {:g}", domain);
  row.samples = angles;
  row.worst_value = fmt::format("{:.2g}", worst);
  row.worst_state = fmt::format("x = {:.17g}", at);
  row.tolerance = fmt::format("{:.2g}: {}", most,
                              subject.scene.numerics.trigonometry_error
                                  ? "the `max_error` of `trigonometry`"
                                  : "the epsilon of the scalar, unless a scene sets "
                                    "`trigonometry`");
  row.verdict = worst <= most ? Verdict::holds : Verdict::fails;
  return row;
}

/// Checks f(x, order) from x = 2^-26, which the series covers, to 2^10, beyond all usual stretches
/// and angles. If f grows as cosh(x), the range ends at 2^6, so that float can hold the values.
template <class Scalar>
CertificateRow helper_row(const FunctionRow& helper, Scalar order) {
  constexpr std::size_t arguments = 256;
  const int last = order < 0 ? 6 : 10;
  const Real exact_order{exact_value(static_cast<double>(order))};
  double worst = 0;
  Scalar at = 0;
  for (std::size_t i = 0; i < arguments; ++i) {
    const double share = static_cast<double>(i) / arguments;
    const auto x = static_cast<Scalar>(std::exp2((last + 26) * share - 26));
    const Real exact{exact_value(static_cast<double>(x))};
    const Real truth = interpreter::call(helper.id, exact, exact_order);
    const Scalar value = interpreter::call(helper.id, x, order);
    const double error =
        error_in_roundoffs(excess_error(value, truth, 1, rounding_constants<Scalar>()), abs(truth),
                           rounding_constants<Scalar>());
    if (error <= worst) continue;
    worst = error;
    at = x;
  }
  CertificateRow row;
  row.check = row.output = "functions of the code";
  row.subject = fmt::format("{}(x, {}) ({})", helper.name, order, name_of(scalar_kind<Scalar>));
  row.formula = fmt::format("|f - f*| / |f*| in 64 digits, 2^-26 <= x < 2^{}", last);
  row.samples = arguments;
  row.worst_value = fmt::format("{:.1f} u", worst);
  row.worst_state = fmt::format("x = {:.17g}", at);
  row.tolerance = fmt::format("{} u, u half the epsilon: the bound in the table of functions",
                              helper.roundings);
  row.verdict = worst <= helper.roundings ? Verdict::holds : Verdict::fails;
  return row;
}

}  // namespace

std::vector<CertificateRow> check_pack_sines(const SystemUnderTest& subject,
                                             const CompiledHeader& compiled) {
  std::vector<CertificateRow> rows;
  if (!compiled.is_in_packs || compiled.is_wide) return rows;
  if (compiled.functions->has(scalar_kind<double>)) {
    rows.push_back(sine_row<double>(subject, compiled));
  }
  if (compiled.functions->has(scalar_kind<float>)) {
    rows.push_back(sine_row<float>(subject, compiled));
  }
  return rows;
}

std::vector<CertificateRow> check_helper_functions(const SystemUnderTest& subject) {
  std::set<std::pair<FunctionId, double>> calls;
  for (const Function& function : subject.program.functions) {
    for (const Instruction& i : function.instructions) {
      if (i.opcode != Opcode::call || is_kinked(i.function)) continue;
      if (function_row(i.function).own_name.empty()) continue;
      calls.emplace(i.function, stumpff_order(subject.program, function, i.b));
    }
  }
  std::vector<CertificateRow> rows;
  for (const auto& [helper, order] : calls) {
    rows.push_back(helper_row<double>(function_row(helper), order));
    rows.push_back(helper_row<float>(function_row(helper), static_cast<float>(order)));
  }
  return rows;
}

CertificateRow missing_code_row(const CompiledHeader& compiled) {
  CertificateRow row;
  row.check =
      compiled.build == BuildFlags::user_flags ? "as users compile" : "compiled code vs program";
  row.output = row.check;
  const std::string kind = code_kind_text(compiled, "");
  row.subject = kind.empty() ? "all outputs" : fmt::format("all outputs ({})", kind);
  row.worst_value = compiled.failure_reason;
  row.verdict = Verdict::skipped;
  return row;
}

namespace {

/// The row of code whose interpreter ended without results.
CertificateRow failed_code_row(const Diagnostic& why) {
  CertificateRow row;
  row.check = row.output = "compiled code vs program";
  row.subject = "all outputs";
  row.formula = "same bits";
  row.worst_value = why.message;
  row.verdict = Verdict::fails;
  return row;
}

}  // namespace

template <class Scalar>
std::vector<CertificateRow> check_compiled_code(const SystemUnderTest& subject,
                                                const CompiledHeader& compiled,
                                                const std::vector<SampledState<Scalar>>& states) {
  std::vector<CertificateRow> rows;
  if (compiled.build == BuildFlags::user_flags || compiled.is_wide) return rows;
  std::vector<const Function*> functions;
  for (const Function& function : subject.program.functions) {
    if (!compiled.is_in_packs || is_returned_by_value(function)) functions.push_back(&function);
  }
  std::vector<std::string_view> names;
  for (const Function* const function : functions) names.push_back(function->name);
  std::vector<Arguments<Scalar>> arguments;
  for (const SampledState<Scalar>& sample : states) arguments.push_back(sample.values);
  const auto values = compiled.functions->call_at_states(names, arguments);
  if (!values) return {failed_code_row(values.diagnostics.front())};
  for (std::size_t i = 0; i < functions.size(); ++i) {
    rows.push_back(compiled_row(subject, compiled, *functions[i], states, (*values)[i]));
  }
  return rows;
}

CertificateRow check_declared_numbers(const std::vector<DeclaredNumber>& numbers) {
  const auto differs = [](const DeclaredNumber& x) {
    return !has_same_bits(x.declared, x.model_value);
  };
  const auto wrong = std::ranges::count_if(numbers, differs);
  CertificateRow row;
  row.check = "declared numbers vs model";
  row.output = row.subject = "declarations";
  row.evidence = Evidence::numbers;
  row.samples = numbers.size();
  row.formula = "values and order of parameters, counts, ranges, limits";
  row.worst_value = fmt::format("{} of {} numbers differ", wrong, numbers.size());
  if (wrong > 0) {
    const DeclaredNumber& first = *std::ranges::find_if(numbers, differs);
    row.worst_state = fmt::format("{} is {:.17g}, in the model {:.17g}", first.name, first.declared,
                                  first.model_value);
  }
  row.tolerance = "exact: the model's numbers rounded to the scalar";
  row.verdict = wrong == 0 ? Verdict::holds : Verdict::fails;
  return row;
}

template std::vector<CertificateRow> check_compiled_code(const SystemUnderTest&,
                                                         const CompiledHeader&,
                                                         const std::vector<SampledState<double>>&);
template std::vector<CertificateRow> check_compiled_code(const SystemUnderTest&,
                                                         const CompiledHeader&,
                                                         const std::vector<SampledState<float>>&);

}  // namespace elgen
