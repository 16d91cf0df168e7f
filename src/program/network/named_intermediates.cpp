// named_intermediates: evaluates in double at random leaves. Sums, products and quotients are
// rounded equally on every machine. Functions are computed in 64 digits, so that they are rounded
// equally, too.
#include "program/network/named_intermediates.hpp"

#include <cmath>

#include "elgen/evaluate.hpp"
#include "program/network/linearise.hpp"
#include "sample/points.hpp"

namespace elgen {
namespace {

/// Relative tolerance. Equal values differ by rounding, about 1e-15. The probability that two of
/// ten thousand different values agree within 1e-12 is 1e-4.
constexpr double relative_tolerance = 1e-12;

struct PortableRules : interpreter::NumberRules<double> {
  [[nodiscard]] double call(FunctionId function, double x, double y) const {
    const auto is_usual = [](double number) { return number == 0 || std::isnormal(number); };
    if (!is_usual(x) || !is_usual(y)) return 0;
    const Real value = interpreter::call(function, Real(cln::cl_R(x)), Real(cln::cl_R(y)));
    return value.is_defined() ? to_double(value.value()) : 0;
  }
};

/// The value of each instruction at the random leaves.
std::vector<double> sample_values(const Program& program, const Function& function) {
  const LeafValues<double> at = Sampler(1).log_uniform_point(program.leaves, -2, 0);
  return fold<double>(PortableRules{{at}}, program, function);
}

NamedIntermediates::const_iterator find_value(const NamedIntermediates& named, double value) {
  const auto next = named.lower_bound(std::abs(value) * (1 - relative_tolerance));
  const bool is_near =
      next != named.end() && next->first <= std::abs(value) * (1 + relative_tolerance);
  return is_near ? next : named.end();
}

}  // namespace

NamedIntermediates named_intermediates(const Expressions& named,
                                       const std::vector<std::string>& names,
                                       const LeafNames& leaves) {
  LinearisedNetwork all(make_network(named));
  all.program.leaves = leaves;
  const std::vector<double> values =
      entries_of(all.function, sample_values(all.program, all.function));
  NamedIntermediates result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_new = std::isnormal(values[i]) && find_value(result, values[i]) == result.end();
    if (is_new) result.try_emplace(std::abs(values[i]), names[i], values[i] < 0);
  }
  return result;
}

void name_intermediates(const NamedIntermediates& named, const Program& program,
                        Function& function) {
  const std::vector<double> values = sample_values(program, function);
  for (std::size_t at = 0; at < values.size(); ++at) {
    const auto known = find_value(named, values[at]);
    if (known == named.end() || operand_count(function.instructions[at]) == 0) continue;
    const auto& [name, is_negative] = known->second;
    const bool is_opposite = is_negative != (values[at] < 0);
    merge_name(function.names[at], intermediate_mark + (is_opposite ? "minus_" + name : name));
  }
}

}  // namespace elgen
