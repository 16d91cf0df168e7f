// tradeoff_states: random states inside the ranges, and what is exact there.
#include "sample/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "elgen/leaf_names.hpp"
#include "elgen/wording.hpp"
#include "run/tradeoff/errors.hpp"

namespace elgen {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

Diagnostic refused(const Span& span, std::string message, std::string hint = {}) {
  return {Code::E630, span, std::move(message), std::move(hint)};
}

/// Narrows the range of what it names, if that is there and varies. Returns what does.
std::vector<std::string> narrow(const Model& model, const NamedRange& narrowed,
                                LeafValues<Range>& ranges) {
  std::vector<std::string> names;
  const auto visit = [&](Opcode kind, std::uint32_t i, Range& range) {
    if (kind == Opcode::parameter || never_passed.has_any(kind)) return;
    names.push_back(leaf_text(model, kind, i));
    if (names.back() == narrowed.name) range = {narrowed.low, narrowed.high};
  };
  for_each_leaf(visit, ranges);
  return names;
}

/// E630 where it names nothing that varies.
Diagnostics narrow(const Model& model, const SourceText& source, LeafValues<Range>& ranges) {
  const Result<NamedRange> narrowed = read_range(source);
  if (!narrowed) return narrowed.diagnostics;
  const std::vector<std::string> names = narrow(model, *narrowed, ranges);
  if (std::ranges::find(names, narrowed->name) != names.end()) return {};
  const Span name{&source, 0, static_cast<std::uint32_t>(narrowed->name.size())};
  return {refused(name, in_backticks(narrowed->name) + " is no coordinate, rate, momentum or input",
                  suggestion(narrowed->name, names))};
}

ExactNumber exact_number(const cln::cl_R& value) {
  const double high = ScalarTraits<double>::from_real(value);
  return {high, ScalarTraits<double>::from_real(value - exact_value(high))};
}

/// State by state -> entry by entry.
std::vector<ExactNumber> transposed(
    const std::vector<std::vector<ExactNumber>>& entries_of_states) {
  std::vector<ExactNumber> result;
  for (std::size_t k = 0; k < entries_of_states.front().size(); ++k) {
    for (const auto& entries : entries_of_states) result.push_back(entries[k]);
  }
  return result;
}

}  // namespace

Result<NamedRange> read_range(const SourceText& source) {
  const std::string_view text = source.text;
  const Span all{&source, 0, static_cast<std::uint32_t>(text.size())};
  const std::size_t equals = text.rfind('=');
  const std::size_t dots = text.find("..", equals == std::string_view::npos ? 0 : equals);
  if (equals == std::string_view::npos || dots == std::string_view::npos) {
    return refused(all, in_backticks(text) + " is no range", "write NAME=LOW..HIGH");
  }
  const std::optional<double> low = number(text.substr(equals + 1, dots - equals - 1));
  const std::optional<double> high = number(text.substr(dots + 2));
  const Span numbers{&source, static_cast<std::uint32_t>(equals + 1), all.end};
  if (!low || !high) return refused(numbers, in_backticks(numbers) + " are no two numbers");
  if (!(*low <= *high))
    return refused(numbers, fmt::format("the range {} is empty", in_backticks(numbers)));
  return NamedRange{std::string(text.substr(0, equals)), *low, *high};
}

std::optional<std::vector<ExactNumber>> exact_entries(const CheckedModel& checked,
                                                      const Program& program,
                                                      const Arguments<double>& state) {
  Arguments<Real> arguments = map_leaves([](double x) { return Real(exact_value(x)); }, state);
  const State nominal = nominal_state(checked.model, checked.scene);
  for (std::size_t i = 0; i < arguments.parameters.size(); ++i) {
    arguments.parameters[i] = Real(nominal.parameters[i]);
  }
  std::vector<ExactNumber> entries;
  for (const Real& value : evaluate(program, program.functions.front(), arguments)) {
    if (!value.is_defined()) return std::nullopt;
    entries.push_back(exact_number(value.value()));
  }
  return entries;
}

Result<TradeoffStates> tradeoff_states(const CheckedModel& exact, const Program& program,
                                       const std::vector<SourcePointer>& ranges,
                                       const TradeoffSampling& sampling) {
  const Subject subject{exact.model, exact.scene, program};
  LeafValues<Range> within = ranges_of(subject);
  for (const NamedRange& range : exact.scene.numerics.ranges) {
    (void)narrow(exact.model, range, within);
  }
  for (const SourcePointer& source : ranges) {
    const Diagnostics wrong = narrow(exact.model, *source, within);
    if (!wrong.empty()) return wrong;
  }
  Random random(sampling.seed);
  TradeoffStates result;
  result.low = map_leaves([](const Range& range) { return range.low; }, within);
  result.high = map_leaves([](const Range& range) { return range.high; }, within);
  std::vector<std::vector<ExactNumber>> values;
  const std::size_t count = sampling.count;
  for (std::size_t tried = 0; result.states.size() < count && tried < 2 * count; ++tried) {
    const Arguments<double> state = drawn_within(subject, within, random);
    auto entries = exact_entries(exact, program, state);
    if (!entries) continue;
    result.states.push_back(state);
    values.push_back(std::move(*entries));
  }
  if (result.states.size() < count) {
    return Diagnostic{Code::E521,
                      {},
                      fmt::format("{} has no value at most states inside the ranges",
                                  in_backticks(program.functions.front().name)),
                      "`--range NAME=LOW..HIGH` narrows them"};
  }
  for (const Field& field : program.functions.front().fields) {
    result.field_sizes.push_back(field.entries.size());
  }
  result.exact = transposed(values);
  return result;
}

}  // namespace elgen
