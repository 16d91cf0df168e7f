// Integer arithmetic on indices and sizes while repetitions are expanded:
//
//     for = ["i in 1..n", "j in i..n"]   with n = 2   ->   (1, 1) (1, 2) (2, 2)
#include "check/names/integers.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <cstdlib>

#include "base/reason.hpp"

namespace elgen {
namespace {

std::optional<std::int64_t> report_not_integer(const ExpressionSyntax& expression, Report& report) {
  report.add(Code::E318, expression.span,
             in_backticks(expression.span) + " is not integer arithmetic over sizes and indices");
  return std::nullopt;
}

std::optional<std::int64_t> evaluate_name(const ExpressionSyntax& name, const IndexScope& scope,
                                          Report& report) {
  const std::optional<std::int64_t> value = scope.find(name.text);
  if (!name.operands.empty()) return report_not_integer(name, report);
  if (!value) {
    report.add(Reason::unknown_index, name.span, "unknown index " + quote_text(name.text),
               suggestion(name.text, scope.names()));
  }
  return value;
}

std::optional<std::int64_t> evaluate_literal(const ExpressionSyntax& literal, Report& report) {
  const bool in_range = cln::denominator(literal.value) == 1 &&
                        cln::abs(literal.value) <= cln::cl_I(static_cast<long>(largest_integer));
  if (!in_range) return report_not_integer(literal, report);
  return cln::cl_I_to_long(cln::numerator(literal.value));
}

/// Combines two values at a time and checks each result, so that no intermediate overflows.
template <class Combine>
std::optional<std::int64_t> fold_checked(const std::vector<std::int64_t>& values, Combine combine) {
  std::int64_t result = values.front();
  for (std::size_t i = 1; i < values.size(); ++i) {
    result = combine(result, values[i]);
    if (std::abs(result) > largest_integer) return std::nullopt;
  }
  return result;
}

std::optional<std::int64_t> apply_operator(const ExpressionSyntax& expression,
                                           const std::vector<std::int64_t>& values) {
  switch (expression.kind) {
    case SyntaxKind::negate:
      return -values.front();
    case SyntaxKind::add:
      return fold_checked(values, std::plus<>());
    case SyntaxKind::multiply:
      return fold_checked(values, std::multiplies<>());
    case SyntaxKind::call:
      if (values.size() == 2 && expression.text == "min") return std::min(values[0], values[1]);
      if (values.size() == 2 && expression.text == "max") return std::max(values[0], values[1]);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<std::int64_t> IndexScope::find(std::string_view name) const {
  const auto innermost = std::find_if(indices_.rbegin(), indices_.rend(),
                                      [&](const auto& index) { return index.first == name; });
  if (innermost != indices_.rend()) return innermost->second;
  const auto size = sizes_->find(name);
  return size == sizes_->end() ? std::nullopt : std::optional(size->second);
}

std::vector<std::string> IndexScope::names() const {
  std::vector<std::string> result;
  for (const auto& [name, value] : indices_) result.push_back(name);
  for (const auto& [name, value] : *sizes_) result.push_back(name);
  return result;
}

std::optional<std::int64_t> evaluate_integer(const ExpressionSyntax& expression,
                                             const IndexScope& scope, Report& report) {
  if (expression.kind == SyntaxKind::number) return evaluate_literal(expression, report);
  if (expression.kind == SyntaxKind::name) return evaluate_name(expression, scope, report);
  std::vector<std::int64_t> values;
  for (const ExpressionSyntax& operand : expression.operands) {
    const std::optional<std::int64_t> value = evaluate_integer(operand, scope, report);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  const std::optional<std::int64_t> result =
      values.empty() ? std::nullopt : apply_operator(expression, values);
  return result ? result : report_not_integer(expression, report);
}

std::vector<RangeSyntax> read_repetition(const ValueSyntax& value) {
  std::vector<RangeSyntax> ranges;
  for (const ValueSyntax& table : value.items) {
    const ValueSyntax& index = table.find("index")->value;
    ranges.push_back({index.text, table.find("low")->value.expression,
                      table.find("high")->value.expression, index.span, table.span});
  }
  return ranges;
}

bool for_each_index_tuple(std::span<const RangeSyntax> ranges, IndexScope& scope, Report& report,
                          const std::function<bool()>& body) {
  if (ranges.empty()) return body();
  const RangeSyntax& range = ranges.front();
  const auto low = evaluate_integer(range.low, scope, report);
  const auto high = evaluate_integer(range.high, scope, report);
  if (!low || !high) return false;
  if (*low > *high) {
    report.add(
        Code::E209, range.span,
        "from " + std::to_string(*low) + " to " + std::to_string(*high) + " there is no element");
  }
  bool going = *low <= *high;
  for (std::int64_t i = *low; going && i <= *high; ++i) {
    scope.push(range.index, i);
    going = for_each_index_tuple(ranges.subspan(1), scope, report, body);
    scope.pop();
  }
  return going;
}

}  // namespace elgen
