// Bitwise comparison. Both sides do the same operations in the same order on one machine with one
// libm and without contraction, so nothing may differ.
#include "verify/compiled_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "evaluate/pack_trigonometry.hpp"
#include "lower/code_interface.hpp"

namespace elgen {
namespace {

template <class Scalar>
bool same_bits(Scalar x, Scalar y) {
  if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
  return x == y && std::signbit(x) == std::signbit(y);
}

template <class Scalar>
std::size_t differing(const std::vector<Scalar>& x, const std::vector<Scalar>& y) {
  if (x.size() != y.size()) return std::max(x.size(), y.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < x.size(); ++i) count += same_bits(x[i], y[i]) ? 0 : 1;
  return count;
}

/// Packs of numbers: sines and cosines are polynomials.
template <class Scalar>
struct PackRules : interpreter::NumberRules<Scalar> {
  const PackTrigonometry<Scalar>& trigonometry;

  [[nodiscard]] Scalar call(FunctionId function, const Scalar& x, const Scalar& y) const {
    if (function == FunctionId::sin) return trigonometry.of(x).sine;
    if (function == FunctionId::cos) return trigonometry.of(x).cosine;
    return interpreter::call(function, x, y);
  }
};

/// The numbers that the compiled function has to give.
template <class Scalar>
class Expected {
 public:
  Expected(const Subject& subject, const CompiledHeader& compiled)
      : program_(subject.program),
        trigonometry_(subject.scene.numerics),
        in_packs_(compiled.in_packs) {}

  [[nodiscard]] std::vector<Scalar> of(const Function& function,
                                       const Arguments<Scalar>& arguments) const {
    // A batch takes one state after another where numbers are compared.
    if (!in_packs_ || needs_order(function)) return evaluate(program_, function, arguments);
    const PackRules<Scalar> rules{{arguments}, trigonometry_};
    return entries_of(function, fold<Scalar>(rules, program_, function));
  }

 private:
  const Program& program_;
  PackTrigonometry<Scalar> trigonometry_;
  bool in_packs_;
};

template <class Scalar>
CertificateRow compiled_row(const Subject& subject, const CompiledHeader& compiled,
                            const Function& function,
                            const std::vector<SampledState<Scalar>>& states) {
  const Expected<Scalar> program(subject, compiled);
  std::size_t wrong = 0;
  std::size_t entries = 0;
  std::string where;
  for (const SampledState<Scalar>& sample : states) {
    const auto expected = program.of(function, sample.values);
    const std::size_t count =
        differing(compiled.functions->call(function.name, sample.values), expected);
    if (wrong == 0 && count > 0) where = describe(subject, exact_state(subject, sample.values));
    wrong += count;
    entries += expected.size();
  }
  CertificateRow row;
  row.check = "compiled code vs program";
  row.output = function.name;
  row.subject = fmt::format("{} ({}{}{})", function.name, name_of(scalar_kind<Scalar>),
                            compiled.types.empty() ? "" : ", ", compiled.types);
  row.formula = "same bits";
  row.samples = states.size();
  row.worst = fmt::format("{} of {} entries differ", wrong, entries);
  row.where = where;
  row.tolerance = compiled.in_packs
                      ? "exact: same operations, same order, no contraction, the polynomials that "
                        "were asked for"
                      : "exact: same operations, same order, no contraction, one libm";
  row.verdict = wrong == 0 ? Verdict::holds : Verdict::fails;
  return row;
}

}  // namespace

template <class Scalar>
std::vector<CertificateRow> check_compiled(const Subject& subject, const CompiledHeader& compiled,
                                           const std::vector<SampledState<Scalar>>& states) {
  std::vector<CertificateRow> rows;
  for (const Function& function : subject.program.functions) {
    if (compiled.in_packs && !is_returned(function)) continue;
    rows.push_back(compiled_row(subject, compiled, function, states));
  }
  return rows;
}

CertificateRow check_declared(const std::vector<DeclaredNumber>& numbers) {
  const auto differs = [](const DeclaredNumber& x) { return !same_bits(x.declared, x.of_model); };
  const auto wrong = std::ranges::count_if(numbers, differs);
  CertificateRow row;
  row.check = "declared numbers vs model";
  row.output = row.subject = "declarations";
  row.evidence = Evidence::numbers;
  row.samples = numbers.size();
  row.formula = "values and order of parameters, counts, ranges, limits";
  row.worst = fmt::format("{} of {} numbers differ", wrong, numbers.size());
  if (wrong > 0) {
    const DeclaredNumber& first = *std::ranges::find_if(numbers, differs);
    row.where = fmt::format("{} is {:.17g}, the model says {:.17g}", first.name, first.declared,
                            first.of_model);
  }
  row.tolerance = "exact: the nearest numbers of the scalar";
  row.verdict = wrong == 0 ? Verdict::holds : Verdict::fails;
  return row;
}

template std::vector<CertificateRow> check_compiled(const Subject&, const CompiledHeader&,
                                                    const std::vector<SampledState<double>>&);
template std::vector<CertificateRow> check_compiled(const Subject&, const CompiledHeader&,
                                                    const std::vector<SampledState<float>>&);

}  // namespace elgen
