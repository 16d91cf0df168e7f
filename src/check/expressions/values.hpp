// ValueReader: reads the values of keys as roots, constants, units and references.
#pragma once

#include <cln/real.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "check/expressions/expand.hpp"
#include "check/names/context.hpp"
#include "elgen/scene.hpp"
#include "elgen/syntax.hpp"

namespace elgen {

/// The place and the expected unit of an expression.
struct RootRequest {
  ExpressionRole role = {};
  std::optional<Unit> unit = {};
};

/// Reads keys for one instance of an entry.
class ValueReader {
 public:
  ValueReader(Context& context, const IndexScope& scope) : context_(context), scope_(scope) {}
  /// Reads an entry that is not repeated.
  explicit ValueReader(Context& context) : ValueReader(context, IndexScope(context.sizes)) {}

  /// Resolves an expression and registers it as a root; `no_expression` after an error.
  ExpressionId read_root(const ExpressionSyntax& expression, const RootRequest& request);
  ExpressionId root(const ValueSyntax& value, const RootRequest& request);

  /// Resolves the value of a key as a root; none if the table does not have the key.
  template <class Table>
  std::optional<ExpressionId> root(const Table& table, std::string_view key,
                                   const RootRequest& request) {
    const KeySyntax* found = table.find(key);
    return found == nullptr ? std::nullopt : std::optional(root(found->value, request));
  }

  /// Resolves a value of a scene. A value that names no parameter, definition or prescribed
  /// function is in the unit of the place, with t in s.
  ExpressionId read_scene_value(const ValueSyntax& value, const RootRequest& request);

  /// Resolves every item of a list, or the single value, as a root.
  std::vector<ExpressionId> read_roots(const ValueSyntax& value, const RootRequest& request);

  /// An exact rational, or else a float of 100 digits. E319 if the value contains names.
  std::optional<cln::cl_R> read_constant(const ValueSyntax& value);
  /// Like read_constant(), but the nodes of an irrational value stay in the model, so that the form
  /// of the value is known.
  std::optional<FixedValue> read_exact_constant(const ValueSyntax& value, std::string hint = {});

  /// [low, high]. E112 unless low < high.
  std::optional<Interval> read_interval(const ValueSyntax& value);
  /// [low, high] of a key; none if the entry does not have it.
  std::optional<Interval> read_interval(const EntrySyntax& entry, std::string_view key);

  /// The index in the Model of the named entry. E201, E207, E208.
  std::optional<std::uint32_t> resolve_reference(const ValueSyntax& value, SymbolKind kind);

  /// The index in the Model of the velocity that `on` names: by its coordinate, or as
  /// `attitude[2]`. E201, E207, E208.
  std::optional<std::uint32_t> resolve_velocity_name(const ValueSyntax& value);

  /// The index in the Model of the named rotation. E201.
  std::optional<std::uint32_t> resolve_rotation_name(const ValueSyntax& value);

  /// The index in the Model of the named frame; none for `world`, and after an error.
  std::optional<std::uint32_t> resolve_frame_or_world(const ValueSyntax& value);

  /// The point or frame with this name. `origin` is the origin of the world, unless a point or a
  /// frame has this name. E201, E208.
  std::optional<LineEnd> resolve_joined_place(const ValueSyntax& value);

  /// True if `value` has 2 or 3 components; false after E104. Reports E516 if the number of
  /// components is not Context::dimension.
  bool check_vector(const ValueSyntax& value);

  Context& context() { return context_; }

 private:
  Context& context_;
  IndexScope scope_;
};

/// Reports E405 for an angle in rad that looks like degrees; the hint gives the multiple of pi.
void report_degrees(Report& report, const Span& span, const cln::cl_RA& angle);
/// Reports E405 for a coordinate in rad whose value is more than a turn and a multiple of 5.
void note_degrees(Report& report, const Span& span, const Coordinate& coordinate,
                  const std::optional<cln::cl_R>& value);

/// The dimension of most vectors of the file, 2 or 3; 0 if all vectors have the same dimension, or
/// if both dimensions are equally frequent.
[[nodiscard]] std::uint32_t majority_dimension(const FileSyntax& model);
/// True if most vectors have two components.
[[nodiscard]] bool is_planar(const FileSyntax& model);

/// Text of an optional key of an entry or table; "" if it is absent.
template <class Table>
[[nodiscard]] std::string text_value(const Table& table, std::string_view key) {
  const KeySyntax* found = table.find(key);
  return found == nullptr ? "" : found->value.text;
}

/// True if a flag is present and true.
[[nodiscard]] inline bool is_flag_set(const KeySyntax* flag) {
  return flag != nullptr && flag->value.boolean;
}

/// A row of the Model with the entry's name, and with the text keys that the row's type has.
template <class Row>
[[nodiscard]] Row make_row(const EntrySyntax& entry, const NewName& name) {
  Row row;
  row.name = name.text();
  row.span = name.span;
  if constexpr (requires { row.identifier; }) row.identifier = name.identifier();
  if constexpr (requires { row.unit_text; }) row.unit_text = text_value(entry, "unit");
  if constexpr (requires { row.latex; }) row.latex = text_value(entry, "latex");
  if constexpr (requires { row.doc; }) row.doc = text_value(entry, "doc");
  return row;
}

/// Appends the row of an entry to a list of the Model; returns its index.
template <auto list>
std::uint32_t append_row(Model& model, const EntrySyntax& entry, const NewName& name) {
  auto& rows = model.*list;
  using Row = typename std::remove_reference_t<decltype(rows)>::value_type;
  rows.push_back(make_row<Row>(entry, name));
  return static_cast<std::uint32_t>(rows.size() - 1);
}

/// The first two of the alternative `keys` that the entry has; null for a missing key. The caller
/// reports a second key.
[[nodiscard]] std::array<const KeySyntax*, 2> first_two_keys(
    const EntrySyntax& entry, std::span<const std::string_view> keys);

/// larger - smaller. The units of both sides are then compared as terms of a sum.
[[nodiscard]] ExpressionSyntax difference_syntax(const ExpressionSyntax& larger,
                                                 const ExpressionSyntax& smaller, const Span& span);

/// left - right of an equation, or left if the right side is 0; none if a side is missing.
[[nodiscard]] std::optional<ExpressionSyntax> residual_syntax(const ValueSyntax& equation);

/// Parses options as keys, and reports the diagnostics of parse_options.
[[nodiscard]] std::vector<KeySyntax> parse_option_keys(Context& context,
                                                       const std::vector<SourcePointer>& options,
                                                       KeyType type);

}  // namespace elgen
