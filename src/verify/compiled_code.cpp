// Bitwise comparison. Both sides do the same operations in the same order on one machine with one
// libm and without contraction, so nothing may differ.
#include "verify/compiled_code.hpp"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

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

template <class Scalar>
CertificateRow compiled_row(const Subject& subject, const CompiledHeader& compiled,
                            const Function& function,
                            const std::vector<SampledState<Scalar>>& states) {
  std::size_t wrong = 0;
  std::size_t entries = 0;
  std::string where;
  for (const SampledState<Scalar>& sample : states) {
    const auto expected = evaluate(subject.program, function, sample.values);
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
  row.tolerance = "exact: same operations, same order, no contraction, one libm";
  row.verdict = wrong == 0 ? Verdict::holds : Verdict::fails;
  return row;
}

}  // namespace

template <class Scalar>
std::vector<CertificateRow> check_compiled(const Subject& subject, const CompiledHeader& compiled,
                                           const std::vector<SampledState<Scalar>>& states) {
  std::vector<CertificateRow> rows;
  for (const Function& function : subject.program.functions) {
    rows.push_back(compiled_row(subject, compiled, function, states));
  }
  return rows;
}

template std::vector<CertificateRow> check_compiled(const Subject&, const CompiledHeader&,
                                                    const std::vector<SampledState<double>>&);
template std::vector<CertificateRow> check_compiled(const Subject&, const CompiledHeader&,
                                                    const std::vector<SampledState<float>>&);

}  // namespace elgen
