// Requests: the outputs of a model, and their shapes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The request for a name: a built-in output, or NAME, NAME_jacobian, NAME_bias, … of an
/// [[output]].
[[nodiscard]] std::optional<OutputRequest> find_request(const Model& model, std::string_view name);

/// Like find_request(), but reports E601, E603, E505, E534, E539 or E633 if the model lacks the
/// output. `independent`: the independent velocities of `completed` in the scene.
[[nodiscard]] std::optional<OutputRequest> require_request(
    const Model& model, std::string_view name, const Span& span, Report& report,
    const std::vector<std::uint32_t>& independent = {});

/// All outputs of the model in table order, except large ones and outputs that are only given by
/// name.
[[nodiscard]] std::vector<OutputRequest> full_requests(const Model& model);

/// The outputs that full_requests() omits although a reader may expect them, by reason.
[[nodiscard]] std::vector<OmittedOutputs> omitted_from_full(const Model& model);

/// The first `abs`, `sign`, `min` or `max` in a force on a coordinate that is not locked; null if
/// there is none. Only forces may have kinks.
[[nodiscard]] const Expression* find_kink(const Model& model);

/// A row or column of a field: its name, unit, and leaf or entry.
struct Line {
  /// "theta", "hand.m"; "tip[2]" for an [[output]] of several values; "x", "y", "z" (rows) and "x",
  /// "y", "z", "p" (columns) of a pose; "wx" to "vz" of a twist; "" for a single number.
  std::string name = {};
  /// The declared unit of the entry; for the rate of a position constraint this unit per second.
  /// Accelerations, both halves of a state, and pivots have the unit of their entry.
  std::optional<Unit> unit = {};
  std::optional<Opcode> leaf = {};  ///< kind of its leaf; none: no leaf
  std::uint32_t number = 0;         ///< of the leaf, or of the entry in its list
  bool is_rate = false;             ///< the rate in a state (q, v)
  bool is_numbered = false;         ///< of an [[output]]; the number determines the name

  /// "theta", "dot(theta)"
  [[nodiscard]] std::string text() const { return is_rate ? "dot(" + name + ")" : name; }
};

/// The rows or columns in order, with distinct texts. `user` is the number of an [[output]].
[[nodiscard]] std::vector<Line> lines_along(const Model& model, Extent extent,
                                            std::uint32_t user = 0);

/// The line with this index; none beyond the last.
[[nodiscard]] std::optional<Line> line_at(const Model& model, Extent extent, std::size_t at,
                                          std::uint32_t user = 0);

/// The names of rows or columns without a leaf of the model, which no list of leaves contains: held
/// and cyclic coordinates, inertial parameters. Values of an [[output]] are excluded.
[[nodiscard]] std::vector<std::string> names_without_leaf(const Model& model, Extent extent);

/// The number of rows or columns. Cheaper than lines_along(), since no names are built.
[[nodiscard]] std::uint32_t extent_of(const Model& model, Extent extent, std::uint32_t user = 0);

/// The number of the first entry of a field, counting all earlier fields of the output table. If
/// `field` is the number of fields: the number of all entries.
[[nodiscard]] std::uint32_t first_entry_of(const Model& model, const OutputRequest& output,
                                           std::size_t field);

/// False for the residual of an explicit step; true for other fields.
[[nodiscard]] bool has_field(const OutputRequest& output, const FieldRow& field);

/// The request for an output of a kind, with the shape of its first field. `user` is the number of
/// an [[output]].
[[nodiscard]] OutputRequest request_of(const Model& model, OutputKind kind, std::uint32_t user);

/// True if the model can give the output.
[[nodiscard]] bool is_available(const Model& model, const OutputRequest& request);

/// The requests of these kinds that the model can give.
[[nodiscard]] std::vector<OutputRequest> available_requests(
    const Model& model, std::initializer_list<OutputKind> kinds);

/// E609 if a user output has the function name of another user output or of a built-in one.
void check_output_names(const Model& model, Report& report);

}  // namespace elgen
