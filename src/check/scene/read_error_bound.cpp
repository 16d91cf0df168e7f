// [numeric] max_error, the bound on the errors of outputs, and the ranges in which it holds.
#include <cln/real.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/wording.hpp"

namespace elgen {
namespace {

/// The names of the state variables, as models write them.
std::vector<std::string> state_variable_names(const Model& model) {
  std::vector<std::string> names;
  const LeafNames leaves = leaf_names(model);
  const auto visit = [&](Opcode kind, std::uint32_t number, const std::string& name) {
    if (is_in_state(kind) && !name.empty()) names.push_back(leaf_text(leaves, kind, number));
  };
  for_each_leaf(visit, leaves);
  return names;
}

class ErrorBoundReader {
 public:
  ErrorBoundReader(Context& context, Numerics& numerics)
      : context_(context), values_(context), numerics_(numerics) {}

  void read_error(const ValueSyntax& value) {
    const std::optional<double> error = read_double(value);
    if (!error) return;
    if (!(*error > 0)) {
      context_.report.add(Code::E640, value.span, in_backticks(value.span) + " is not positive");
    }
    if (std::ranges::count(numerics_.scalars, ScalarKind::long_double) > 0) {
      context_.report.add(Code::E640, value.span, "errors are measured in `float` and `double`",
                          "`scalar` names `long double`");
    }
    numerics_.max_error = error;
  }

  void read_range(const KeySyntax& key, const std::vector<std::string>& names) {
    const std::string name = component_name(context_.model, key.key);
    if (std::ranges::find(names, name) == names.end()) {
      return report_range_error(
          key.key_span, quote_text(key.key) + " is no coordinate, rate, acceleration or input",
          suggestion(key.key, names));
    }
    const std::optional<double> low = read_double(key.value.items[0]);
    const std::optional<double> high = read_double(key.value.items[1]);
    if (!low || !high) return;
    if (*low > *high) {
      return report_range_error(key.value.span,
                                "the range " + in_backticks(key.value.span) + " is empty");
    }
    numerics_.ranges.push_back({name, *low, *high});
  }

 private:
  void report_range_error(const Span& span, std::string message, std::string hint = {}) {
    context_.report.add(Code::E630, span, std::move(message), std::move(hint));
  }

  std::optional<double> read_double(const ValueSyntax& value) {
    const std::optional<cln::cl_R> exact = values_.read_constant(value);
    return exact ? std::optional(cln::double_approx(*exact)) : std::nullopt;
  }

  Context& context_;
  ValueReader values_;
  Numerics& numerics_;
};

}  // namespace

void read_error_bound(Context& context, const FileSyntax* syntax, const SceneOptions& options,
                      Numerics& numerics) {
  ErrorBoundReader reader(context, numerics);
  const KeySyntax* const error = find_key(syntax, "numeric", "max_error");
  if (error != nullptr) reader.read_error(error->value);
  const KeySyntax* const ranges = find_key(syntax, "numeric", "ranges");
  if (ranges == nullptr && options.ranges.empty()) return;
  std::vector<KeySyntax> keys = parse_option_keys(context, options.ranges, KeyType::range);
  if (ranges != nullptr) {
    keys.insert(keys.begin(), ranges->value.entries.begin(), ranges->value.entries.end());
  }
  const std::vector<std::string> names = state_variable_names(context.model);
  for (const KeySyntax& key : keys) reader.read_range(key, names);
}

}  // namespace elgen
