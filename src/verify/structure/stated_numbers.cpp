// One state in 60 digits. Parameters have the values of the file there, whatever a scene fixes: an
// expectation speaks of the model.
#include "verify/structure/stated_numbers.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "sample/states.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// The field of an expectation by the oracle; empty where it has no value.
std::vector<cl_R> field_at(const Model& model, const Expectation& expectation, const State& state) {
  const auto request = find_request(model, expectation.output);
  const OracleValues all = request ? oracle_values(model, *request, state) : std::nullopt;
  const std::size_t end = expectation.first + expectation.entries.size();
  if (!all || all->size() < end) return {};
  return {all->begin() + expectation.first, all->begin() + static_cast<std::ptrdiff_t>(end)};
}

/// As many digits as doubles keep.
std::string digits_of(const cl_R& value) {
  return fmt::format("{:.15g}", ScalarTraits<double>::from_real(value));
}

}  // namespace

void check_numbers(ExpectationReport& report, const Expectation& expectation,
                   const Subject& subject) {
  const Model& model = subject.model;
  const State state = with_leaves(model, start_state(model, {}), expectation.at->leaves);
  const std::string where = describe(subject, state);
  const std::vector<cl_R> field = field_at(model, expectation, state);
  const cl_R largest = largest_of(field);
  const std::string within = short_text(expectation.at->within);
  for (std::size_t index = 0; index < expectation.entries.size(); ++index) {
    const ExpectedEntry entry{expectation, index, subject};
    const auto written = oracle_expression(model, entry.expression(), state);
    CertificateRow& row = report.rows.emplace_back(blank_row(entry));
    row.output += " at a state";
    row.tolerance = fmt::format("{} of the largest entry, at the state of the file", within);
    if (!written || field.empty()) {
      row.verdict = Verdict::fails;
      row.worst = "no value";
      report.diagnostics.push_back(
          {Code::E510, entry.span(), fmt::format("{} has no value at {}", name_of(entry), where)});
      continue;
    }
    const cl_R difference = *written - field[index];
    const cl_R scale = cln::zerop(largest) ? cln::abs(*written) : largest;
    const cl_R share = cln::zerop(difference) ? cl_R(0) : cln::abs(difference) / scale;
    row.samples = 1;
    row.worst = fmt::format("{} of the largest entry", short_text(share));
    if (share <= expectation.at->within) continue;
    row.verdict = Verdict::fails;
    row.where = where;
    report.diagnostics.push_back(
        {Code::E510, entry.span(),
         fmt::format("{} is {} in the file, {} as derived, {} too much: {}, more than {}, at {}",
                     name_of(entry), digits_of(*written), digits_of(field[index]),
                     short_text(difference), row.worst, within, where)});
  }
}

}  // namespace elgen
