// Expectations: closed forms as row-major matrices of expressions, complete or by entry:
//
//     gravity_entry = { for = "i in 1..2", value = "m[i]*g" }   ->   gravity = [m[1]*g, m[2]*g]
//     equations = ["m*dot(dot(x)) = -k*x"]                      ->   m*dot(dot(x)) - -k*x
#include <algorithm>
#include <utility>

#include "check/expressions/open_functions.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/judge/judge.hpp"
#include "elgen/references.hpp"
#include "model/output_units.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

constexpr std::string_view entry_suffix = "_entry";
/// The only field of forward_dynamics that is itself a key of an [[expect]].
constexpr std::string_view multipliers = "multipliers";
constexpr ExpressionRole closed_form{"a closed form", place::all_terms};
constexpr ExpressionRole closed_form_of_momenta{"a closed form", place::all_terms | uses_momentum};
constexpr ExpressionRole conserved_form{"a conserved quantity",
                                        place::all_terms | uses_momentum | uses_energy};
constexpr ExpressionRole equation_of_motion{"an equation of motion",
                                            place::all_terms | uses_multiplier};

/// A field of an output: the first field, or `multipliers`.
struct ExpectedField {
  OutputRequest request = {};
  std::string field = {};
  std::uint32_t first = 0;
};

ExpressionRole role_of_field(const ExpectedField& expected) {
  const OutputKind kind = expected.request.kind;
  const bool takes_momenta = output_row(kind).argument_kinds.has_any(Opcode::momentum);
  ExpressionRole place = takes_momenta ? closed_form_of_momenta : closed_form;
  place.is_force = field_row(kind, expected.field).unit == UnitRule::power;
  return place;
}

std::string dimensions_text(std::size_t rows, std::size_t columns) {
  return std::to_string(rows) + " x " + std::to_string(columns);
}

using Rows = std::vector<std::vector<const ValueSyntax*>>;

/// The rows of a value: a list of lists, a list (a column), or one expression.
Rows split_rows(const ValueSyntax& value) {
  Rows rows;
  if (value.kind != ValueKind::list) return {{&value}};
  for (const ValueSyntax& item : value.items) {
    rows.emplace_back();
    if (item.kind != ValueKind::list) rows.back().push_back(&item);
    for (const ValueSyntax& entry : item.items) rows.back().push_back(&entry);
  }
  return rows;
}

/// True for outputs whose kind is a matrix, even if it is 1 x 1, such as the mass matrix of one
/// coordinate. A pose is a matrix too.
bool is_matrix(const OutputRequest& request) {
  return request.columns > 1 || is_matrix_field(field_row(request.kind, ""));
}

bool is_nested(const ValueSyntax& value) {
  return !value.items.empty() && value.items.front().kind == ValueKind::list;
}

/// The shape of `rows`: "2 x 1 entries".
std::string observed_dimensions_text(const Rows& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  const bool is_ragged =
      std::ranges::any_of(rows, [&](const auto& row) { return row.size() != columns; });
  return is_ragged ? "rows of different lengths"
                   : dimensions_text(rows.size(), columns) + " entries";
}

/// The output and field with this name; none after an error of require_request.
std::optional<ExpectedField> require_field(const Model& model, std::string_view name,
                                           const Span& span, Report& report) {
  const bool is_field = name == multipliers && !model.constraints.empty();
  auto request = require_request(model, is_field ? "forward_dynamics" : name, span, report);
  if (!request) return std::nullopt;
  if (!is_field) return ExpectedField{std::move(*request)};
  ExpectedField expected{std::move(*request), std::string(name)};
  expected.first = expected.request.rows + extent_size(model, Extent::pivots);
  expected.request.rows = extent_size(model, Extent::constraints);
  return expected;
}

/// The expectation of a field, without entries.
Expectation make_expectation(const ExpectedField& expected, const Span& span) {
  Expectation expectation;
  expectation.output = expected.request.name;
  expectation.field = expected.field;
  expectation.first = expected.first;
  expectation.rows = expected.request.rows;
  expectation.columns = expected.request.columns;
  expectation.span = span;
  return expectation;
}

/// The row-major index of the entry at the running indices, which count from 1 in files. E517.
std::optional<std::size_t> entry_index(const OutputRequest& request,
                                       const std::vector<RangeSyntax>& ranges,
                                       const IndexScope& scope, const Span& span, Report& report) {
  const std::int64_t row = *scope.find(ranges[0].index);
  const std::int64_t column = ranges.size() > 1 ? *scope.find(ranges[1].index) : 1;
  if (row >= 1 && row <= request.rows && column >= 1 && column <= request.columns) {
    return static_cast<std::size_t>((row - 1) * std::int64_t{request.columns} + column - 1);
  }
  report.add(Code::E517, span,
             "entry " + std::to_string(row) + ", " + std::to_string(column) + ", but " +
                 quote_text(request.name) + " is " +
                 dimensions_text(request.rows, request.columns));
  return std::nullopt;
}

bool check_complete(Expectation& expectation, const Span& span, Report& report) {
  std::vector<ExpressionId>& entries = expectation.entries;
  entries.resize(std::size_t{expectation.rows} * expectation.columns, no_expression);
  const auto missing = std::ranges::find(entries, no_expression);
  if (missing == entries.end()) return true;
  const auto index = static_cast<std::size_t>(missing - entries.begin());
  report.add(Code::E517, span,
             "no entry " + std::to_string(index / expectation.columns + 1) + ", " +
                 std::to_string(index % expectation.columns + 1) + " of " +
                 quote_text(expectation.output));
  return false;
}

class ExpectationReader {
 public:
  /// `at`: the state of the expected values; none if the values hold in all states.
  ExpectationReader(Context& context, const Model& described,
                    const std::optional<ExpectationState>& at)
      : context_(context), described_(described), values_(context), at_(at) {}

  void read(const KeySyntax& key) {
    if (key.key == "conserved") {
      read_column(key, conserved_form);
    } else if (key.key == "equations") {
      read_column(key, equation_of_motion);
    } else if (key.value.kind == ValueKind::table) {
      read_entry_formula(key);
    } else if (const auto expected =
                   require_field(described_, key.key, key.key_span, context_.report)) {
      read_matrix(key, *expected);
    }
  }

 private:
  /// Reads `conserved` or `equations`, which are no outputs.
  void read_column(const KeySyntax& key, const ExpressionRole& place) {
    Expectation expectation;
    expectation.output = key.key;
    expectation.span = key.key_span;
    for (const ValueSyntax& item : key.value.items) {
      const auto value = item.kind == ValueKind::table ? residual_syntax(item) : item.expression;
      if (!value) continue;
      expectation.entries.push_back(values_.read_root(*value, {place}));
      expectation.spans.push_back(item.span);
    }
    expectation.rows = static_cast<std::uint32_t>(expectation.entries.size());
    expectation.columns = 1;
    store_expectation(std::move(expectation));
  }

  void read_matrix(const KeySyntax& key, const ExpectedField& expected) {
    const OutputRequest& request = expected.request;
    const auto rows = split_rows(key.value);
    Expectation expectation = make_expectation(expected, key.key_span);
    const bool needs_rows = is_matrix(request) && !is_nested(key.value);
    bool fits = rows.size() == request.rows && !needs_rows;
    for (std::size_t i = 0; fits && i < rows.size(); ++i) {
      fits = rows[i].size() == request.columns;
      for (std::size_t j = 0; fits && j < rows[i].size(); ++j) {
        const std::size_t index = expectation.entries.size();
        add_entry(expectation, *rows[i][j], entry_request(expected, index));
        drop_plain_number_unit();
      }
    }
    if (!fits) {
      const std::string found = needs_rows ? "no list of rows" : observed_dimensions_text(rows);
      context_.report.add(Code::E517, key.value.span,
                          found + ", but " + quote_text(key.key) + " is " +
                              dimensions_text(request.rows, request.columns),
                          is_matrix(request) ? "a matrix is a list of rows: [[…], […]]" : "");
      return;
    }
    store_expectation(std::move(expectation));
  }

  /// If the [[expect]] has a state, removes the expected unit of the last entry if the entry is a
  /// plain number: plain numbers come from tables and get no E405.
  void drop_plain_number_unit() {
    if (at_ && !context_.roots.empty() && context_.roots.back().is_in_role_unit) {
      context_.roots.back().unit.reset();
    }
  }

  void store_expectation(Expectation expectation) {
    if (!expectation.claims_conservation() && !expectation.claims_equations())
      expectation.state = at_;
    if (!context_.is_beyond_limits) context_.model.expectations.push_back(std::move(expectation));
  }

  /// The place and the expected unit of an entry of the output.
  RootRequest entry_request(const ExpectedField& expected, std::size_t index) const {
    const auto& [output, field, first] = expected;
    const FieldEntry place{output.kind, field, index / output.columns, index % output.columns};
    return {role_of_field(expected), unit_of_entry(described_, place)};
  }

  void add_entry(Expectation& expectation, const ValueSyntax& value, const RootRequest& entry) {
    expectation.entries.push_back(values_.root(value, entry));
    expectation.spans.push_back(value.span);
  }

  void read_entry_formula(const KeySyntax& key) {
    const std::string_view name = key.key;
    if (!name.ends_with(entry_suffix)) {
      context_.report.add(
          Code::E601, key.key_span,
          quote_text(name) + " gives a formula for each entry, but its name lacks the suffix",
          "did you mean `" + key.key + std::string(entry_suffix) + "`?");
      return;
    }
    const std::string_view output = name.substr(0, name.size() - entry_suffix.size());
    const auto expected = require_field(described_, output, key.key_span, context_.report);
    const KeySyntax* repetition = key.value.find("for");
    const KeySyntax* value = key.value.find("value");
    if (!expected || repetition == nullptr || value == nullptr) return;
    const OutputRequest& request = expected->request;
    const std::vector<RangeSyntax> ranges = read_repetition(repetition->value);
    const std::size_t indices = is_matrix(request) ? 2 : 1;
    if (ranges.size() != indices) {
      context_.report.add(Code::E517, repetition->value.span,
                          std::to_string(ranges.size()) + " indices, but an entry of " +
                              quote_text(request.name) + " has " + std::to_string(indices));
      return;
    }
    expand_entry_formula(*expected, ranges, *value, key.key_span);
  }

  void expand_entry_formula(const ExpectedField& expected, const std::vector<RangeSyntax>& ranges,
                            const KeySyntax& value, const Span& span) {
    Expectation expectation = make_expectation(expected, span);
    IndexScope scope(context_.sizes);
    const auto add = [&] {
      const auto index =
          entry_index(expected.request, ranges, scope, value.value.span, context_.report);
      if (!index) return false;
      const ExpressionId entry =
          ValueReader(context_, scope).root(value.value, entry_request(expected, *index));
      drop_plain_number_unit();
      // Grow lazily: a form over the node limit stops long before its last entry.
      expectation.entries.resize(std::max(expectation.entries.size(), *index + 1), no_expression);
      expectation.entries[*index] = entry;
      return entry != no_expression;
    };
    const bool complete = for_each_index_tuple(ranges, scope, context_.report, add);
    if (complete && check_complete(expectation, value.value.span, context_.report)) {
      expectation.spans.assign(expectation.entries.size(), value.value.span);
      store_expectation(std::move(expectation));
    }
  }

  Context& context_;
  const Model& described_;
  ValueReader values_;
  const std::optional<ExpectationState>& at_;
};

/// Reads one closed form with at most 4096 nodes. A larger form is removed again, but the errors
/// found before the limit are reported.
void read_within_node_limit(Context& context, const Model& described,
                            const std::optional<ExpectationState>& at, const KeySyntax& key) {
  constexpr std::uint64_t few_nodes = 4096;
  const std::size_t nodes = context.model.expressions.size();
  const std::size_t roots = context.roots.size();
  const std::uint64_t limit = std::exchange(context.node_limit, nodes + few_nodes);
  Report outer = std::exchange(context.report, Report{});
  ExpectationReader(context, described, at).read(key);
  const Report inner = std::exchange(context.report, std::move(outer));
  context.node_limit = limit;
  if (std::exchange(context.is_beyond_limits, false)) {
    context.truncate(nodes);
    context.roots.resize(roots);
  }
  for (const Diagnostic& diagnostic : inner.sorted_diagnostics()) {
    if (diagnostic.code != Code::E908) context.report.add(diagnostic);
  }
}

/// True if `entry` contains `no_expression`: a part with an error, or the z of a planar point.
bool contains_error(const Model& model, ExpressionId entry) {
  return std::ranges::count(reachable_expressions(model, {entry}), no_expression) > 0;
}

/// Reports E319 for each momentum of a locked or cyclic coordinate in the [[expect]] of the scene,
/// whose functions do not take it.
void refuse_removed_momenta(Context& context) {
  const Model& model = context.model;
  for (const Expectation& expectation : model.expectations) {
    if (!is_of_scene(model, expectation.span)) continue;
    for (const ExpressionId id : reachable_expressions(model, expectation.entries)) {
      const Expression& node = model.expressions[id];
      const auto& [locks, cyclic, unreduced] = model.reduction;
      const bool is_removed = has_velocity(locks, node.index) || has_velocity(cyclic, node.index);
      if (!is_leaf(node, Opcode::momentum) || !is_removed) continue;
      context.report.add(
          Code::E319, node.span,
          in_backticks(node.span) + " is the momentum of a coordinate that the scene removes");
    }
  }
}

}  // namespace

void check_expected_equations(Context& context, const std::vector<ExpressionTraits>& traits) {
  const Model& model = context.model;
  const bool is_sound = context.report.error_count() == 0;
  for (const Expectation& expectation : model.expectations) {
    if (!expectation.claims_equations()) continue;
    for (std::size_t i = 0; i < expectation.entries.size(); ++i) {
      const ExpressionId entry = expectation.entries[i];
      if ((traits[entry].ingredients & (uses_acceleration | uses_multiplier)) != 0) continue;
      if (!is_sound && contains_error(model, entry)) continue;
      context.report.add(Code::E540, expectation.spans[i],
                         in_backticks(expectation.spans[i]) + " contains no acceleration",
                         "the acceleration of `x` is `dot(dot(x))`");
    }
  }
}

void read_expectations(Context& context, const FileSyntax& syntax,
                       const ExpectationOptions& options) {
  for (const EntrySyntax& entry : syntax.entries) {
    if (entry.name != "expect") continue;
    const auto at = read_expected_state(context, options.described, entry);
    for (const KeySyntax& key : entry.keys) {
      const bool is_of_state = key.key == "at" || key.key == "within";
      if (is_of_state || uses_closed_derivative(context, key.value)) continue;
      if (options.only_conserved && key.key != "conserved") continue;
      if (options.keeps_large_forms) {
        ExpectationReader(context, options.described, at).read(key);
      } else {
        read_within_node_limit(context, options.described, at, key);
      }
    }
  }
  refuse_removed_momenta(context);
}

}  // namespace elgen
