// Integer arithmetic on indices and sizes, and the repetitions that use it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/report.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// Largest magnitude of an index or a size: sums and products of two of them fit 64 bits.
inline constexpr std::int64_t largest_integer = 1'000'000'000;

using Sizes = std::map<std::string, std::int64_t, std::less<>>;

/// The names in an index expression: sizes, and the running indices of the enclosing repetitions.
class IndexScope {
 public:
  explicit IndexScope(const Sizes& sizes) : sizes_(&sizes) {}

  void push(std::string index, std::int64_t value) {
    indices_.emplace_back(std::move(index), value);
  }
  void pop() { indices_.pop_back(); }

  [[nodiscard]] std::optional<std::int64_t> find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  const Sizes* sizes_;
  std::vector<std::pair<std::string, std::int64_t>> indices_ = {};
};

/// Value of an expression of integers, names in scope, +, -, *, min and max. E201 for an unknown
/// name, E318 for any other expression.
[[nodiscard]] std::optional<std::int64_t> evaluate_integer(const ExpressionSyntax& expression,
                                                           const IndexScope& scope, Report& report);

/// "i in 1..n", both bounds included.
struct RangeSyntax {
  std::string index;
  ExpressionSyntax low;
  ExpressionSyntax high;
  Span index_span;
  Span span;
};

/// The ranges of a parsed `for`.
[[nodiscard]] std::vector<RangeSyntax> read_repetition(const ValueSyntax& value);

/// Calls `body` for every combination of indices, the last range fastest. The bounds of a range may
/// depend on earlier indices. Returns false at the first error, or as soon as `body` does. E209 if
/// a range has no element.
bool for_each_index_tuple(std::span<const RangeSyntax> ranges, IndexScope& scope, Report& report,
                          const std::function<bool()>& body);

}  // namespace elgen
