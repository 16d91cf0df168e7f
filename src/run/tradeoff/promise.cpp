// check_max_error: certificate rows for a scene with `[numeric] max_error`.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "elgen/tradeoff.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// Compiled code whose errors must not exceed `max_error`.
struct ErrorLimitedCode {
  std::string types;  ///< "batch", "as users compile"; "" for the plain header
  const CompiledModel* functions;
};

/// The compiled headers to check: as written, and as users compile them, because contraction
/// changes results. Headers in other argument types are skipped, because their results are the
/// same. If the scene has a wider inner scalar, only headers in this scalar are checked.
std::vector<ErrorLimitedCode> codes_to_check(const CompiledHeaders& compiled) {
  const bool has_wide = std::ranges::any_of(compiled, &CompiledHeader::is_wide);
  std::vector<ErrorLimitedCode> codes;
  for (const CompiledHeader& header : compiled) {
    if (!header.functions || header.is_wide != has_wide) continue;
    const bool is_own = header.types.empty() || header.is_in_packs || header.is_wide;
    const bool is_written = header.build == BuildFlags::as_written;
    if (is_own && is_written) codes.push_back({header.types, header.functions.get()});
    const bool is_users = header.build == BuildFlags::user_flags && !header.is_in_packs;
    if (is_users) codes.push_back({"as users compile", header.functions.get()});
  }
  return codes;
}

/// The entries of `function` at `states`: entry k at state i is at [k * states.size() + i], NaN if
/// the call throws. Empty if every call throws, or if `code` lacks the function.
template <class Scalar>
std::vector<double> code_values(const CompiledModel& code, const Function& function,
                                const std::vector<Arguments<double>>& states) {
  std::vector<Arguments<Scalar>> rounded;
  for (const Arguments<double>& state : states) {
    rounded.push_back(map_leaves([](double x) { return static_cast<Scalar>(x); }, state));
  }
  const auto all = code.call_at_states({function.name}, rounded);
  const auto is_empty = [](const std::vector<Scalar>& entries) { return entries.empty(); };
  if (!all || std::ranges::all_of(all->front(), is_empty)) return {};
  std::vector<double> values(entry_count(function) * states.size(),
                             std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::vector<Scalar>& entries = all->front()[i];
    for (std::size_t k = 0; k < entries.size(); ++k) {
      values[k * states.size() + i] = static_cast<double>(entries[k]);
    }
  }
  return values;
}

DesignEvaluator make_design_values(const CompiledModel& code, const Function& function,
                                   ScalarKind scalar) {
  const auto values =
      scalar == ScalarKind::single_precision ? &code_values<float> : &code_values<double>;
  return [values, &code, &function](const std::vector<Arguments<double>>& states) {
    return values(code, function, states);
  };
}

class MaxErrorRows {
 public:
  MaxErrorRows(const CheckedModel& exact, const std::vector<ErrorLimitedCode>& codes,
               std::uint64_t seed)
      : exact_(exact), codes_(codes), seed_(seed) {}

  /// Adds rows for the program's only function.
  void add_function_rows(const Program& program) {
    const Function& function = program.functions.front();
    const Result<TradeoffStates> states = sample_tradeoff_states(exact_, program, {.seed = seed_});
    if (!states) return rows_.push_back(skipped_row(function));
    for (const ErrorLimitedCode& code : codes_) {
      for (const ScalarKind scalar : exact_.scene.numerics.scalars) {
        const DesignEvaluator design = make_design_values(*code.functions, function, scalar);
        if (!code.functions->has(scalar) || design({states->states.front()}).empty()) continue;
        const FoundErrors found = find_errors(exact_, program, *states, design);
        rows_.push_back(row_of(program, found));
        rows_.back().samples = states->states.size();
        rows_.back().subject +=
            fmt::format(" ({}{}{})", name_of(scalar), code.types.empty() ? "" : ", ", code.types);
      }
    }
  }

  std::vector<CertificateRow> take_rows() { return std::move(rows_); }

 private:
  [[nodiscard]] CertificateRow plain_row(const Function& function) const {
    CertificateRow row;
    row.check = "max_error";
    row.output = row.subject = function.name;
    row.formula = "|x - x*| / max |x*| of the field";
    row.tolerance =
        fmt::format("{} from the scene; at the sampled states and in a search from the ten worst",
                    *exact_.scene.numerics.max_error);
    return row;
  }

  [[nodiscard]] CertificateRow skipped_row(const Function& function) const {
    CertificateRow row = plain_row(function);
    row.verdict = Verdict::skipped;
    row.skipped = {{SkipReason::undefined, TradeoffSampling().count}};
    return row;
  }

  [[nodiscard]] CertificateRow row_of(const Program& program, const FoundErrors& found) const {
    const SystemUnderTest subject{exact_.model, exact_.scene, program};
    CertificateRow row = plain_row(program.functions.front());
    row.worst_value = fmt::format("{:.2e} of the largest value", found.worst);
    row.worst_state = describe_state(subject, exact_state(subject, found.worst_state));
    const bool is_kept = found.worst <= *exact_.scene.numerics.max_error;
    row.verdict = is_kept ? Verdict::holds : Verdict::fails;
    return row;
  }

  const CheckedModel& exact_;
  const std::vector<ErrorLimitedCode>& codes_;
  std::uint64_t seed_;
  std::vector<CertificateRow> rows_ = {};
};

}  // namespace

std::vector<CertificateRow> check_max_error(const CheckedModel& exact, const Program& program,
                                            const CompiledHeaders& compiled,
                                            const VerifyOptions& options) {
  const std::vector<ErrorLimitedCode> codes = codes_to_check(compiled);
  if (!exact.scene.numerics.max_error || codes.empty()) return {};
  MaxErrorRows rows(exact, codes, options.seed);
  for (const Function& function : program.functions) {
    Program alone = program;
    alone.functions = {function};
    rows.add_function_rows(alone);
  }
  return rows.take_rows();
}

}  // namespace elgen
