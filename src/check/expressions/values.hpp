// Values: reads the values of keys as roots, constants, units and references.
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

/// The place and the unit of an expression, known before it is read.
struct RootRequest {
  Place place = {};
  std::optional<Unit> unit = {};
};

/// Reads keys for one instance of an entry.
class ValueReader {
 public:
  ValueReader(Context& context, const Scope& scope) : context_(context), scope_(scope) {}
  /// Reads an entry that is not repeated.
  explicit ValueReader(Context& context) : ValueReader(context, Scope(context.sizes)) {}

  /// Resolves an expression and registers it as a root; `no_expression` after an error.
  ExpressionId root(const ExpressionSyntax& expression, const RootRequest& request);
  ExpressionId root(const ValueSyntax& value, const RootRequest& request);

  /// The same of a key, where the entry or table has it.
  template <class Table>
  std::optional<ExpressionId> root(const Table& table, std::string_view key,
                                   const RootRequest& request) {
    const KeySyntax* found = table.find(key);
    return found == nullptr ? std::nullopt : std::optional(root(found->value, request));
  }

  /// A value of a scene: where it names nothing but t and pi, numbers are in the unit of the place,
  /// t in s.
  ExpressionId scene_value(const ValueSyntax& value, const RootRequest& request);

  /// Every item of a list (or the one value) as a root.
  std::vector<ExpressionId> roots(const ValueSyntax& value, const RootRequest& request);

  /// An exact rational where it is one, else a float of 100 digits. E319 where names occur.
  std::optional<cln::cl_R> constant(const ValueSyntax& value);
  /// The same with its expression, which stays in the model, where it is not rational.
  std::optional<FixedValue> constant_with_form(const ValueSyntax& value);

  /// [low, high] of a key, where the entry has it; E112 unless low < high.
  std::optional<Interval> interval(const EntrySyntax& entry, std::string_view key);

  /// The index in the Model of what a name refers to. E201, E207, E208.
  std::optional<std::uint32_t> reference(const ValueSyntax& value, SymbolKind kind);

  /// The index in the Model of the velocity that `on` names: by its coordinate, or as
  /// `attitude[2]`. E201, E207, E208.
  std::optional<std::uint32_t> velocity(const ValueSyntax& value);

  /// The index in the Model of the rotation a name refers to. E201.
  std::optional<std::uint32_t> rotation(const ValueSyntax& value);

  /// The same for a frame; nothing for `world` (and after an error).
  std::optional<std::uint32_t> frame_or_world(const ValueSyntax& value);

  /// The point or frame of this name, or `origin`, that of the world, unless a point or a frame has
  /// the name. E201, E208.
  std::optional<JoinedPlace> joined_place(const ValueSyntax& value);

  /// False after E104: a vector has 2 or 3 components. E516 where it has fewer or more than most
  /// vectors of the model, or than the first.
  bool is_vector(const ValueSyntax& value);

  Context& context() { return context_; }

 private:
  Context& context_;
  Scope scope_;
};

/// E405: an angle that would be this multiple of pi if it was meant in degrees.
void note_degrees(Report& report, const Span& span, const cln::cl_RA& angle);
/// The same of a coordinate in rad, where its value is more than a turn and a multiple of 5.
void note_degrees(Report& report, const Span& span, const Coordinate& coordinate,
                  const std::optional<cln::cl_R>& value);

/// The dimension of most vectors of the file, 2 or 3; 0 where all agree, or in a draw.
[[nodiscard]] std::uint32_t usual_dimension(const FileSyntax& model);
/// Whether most vectors have two components.
[[nodiscard]] bool is_planar(const FileSyntax& model);

/// Text of an optional key of an entry or table, or nothing.
template <class Table>
[[nodiscard]] std::string text_of(const Table& table, std::string_view key) {
  const KeySyntax* found = table.find(key);
  return found == nullptr ? "" : found->value.text;
}

/// Whether a flag is there, and true.
[[nodiscard]] inline bool is_set(const KeySyntax* flag) {
  return flag != nullptr && flag->value.boolean;
}

/// A row with the name of an entry, and those of the texts of its keys that such rows have.
template <class Row>
[[nodiscard]] Row row_of(const EntrySyntax& entry, const NewName& name) {
  Row row;
  row.name = name.text();
  row.span = name.span;
  if constexpr (requires { row.identifier; }) row.identifier = name.identifier();
  if constexpr (requires { row.unit_text; }) row.unit_text = text_of(entry, "unit");
  if constexpr (requires { row.latex; }) row.latex = text_of(entry, "latex");
  if constexpr (requires { row.doc; }) row.doc = text_of(entry, "doc");
  return row;
}

/// Adds it to a list of the Model; its index.
template <auto list>
std::uint32_t append_row(Model& model, const EntrySyntax& entry, const NewName& name) {
  auto& rows = model.*list;
  using Row = typename std::remove_reference_t<decltype(rows)>::value_type;
  rows.push_back(row_of<Row>(entry, name));
  return static_cast<std::uint32_t>(rows.size() - 1);
}

/// The first of some keys that say the same in different ways, and the second, which is one too
/// many; null where there are fewer.
[[nodiscard]] std::array<const KeySyntax*, 2> first_two(const EntrySyntax& entry,
                                                        std::span<const std::string_view> keys);

/// larger - smaller: the units of the two are compared as those of a sum.
[[nodiscard]] ExpressionSyntax difference(const ExpressionSyntax& larger,
                                          const ExpressionSyntax& smaller, const Span& span);

/// left - right of an equation, or left where the right side is 0; none where it could not be read.
[[nodiscard]] std::optional<ExpressionSyntax> residual(const ValueSyntax& equation);

/// Options as keys; what parse_options says of the others is reported.
[[nodiscard]] std::vector<KeySyntax> keys_of(Context& context,
                                             const std::vector<SourcePointer>& options,
                                             KeyType type);

}  // namespace elgen
