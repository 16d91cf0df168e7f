// Requests: the outputs of a model, the shapes of their fields, and the names of rows and columns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The request for a built-in output, or for NAME, NAME_jacobian, NAME_bias, … of an [[output]];
/// none if no output has the name.
[[nodiscard]] std::optional<OutputRequest> find_request(const Model& model, std::string_view name);

/// Like find_request(), but reports E601 for an unknown name, and E603, E505, E534, E539 or E633 if
/// the model cannot provide the output. `independent`: the independent velocities of `completed` in
/// the scene.
[[nodiscard]] std::optional<OutputRequest> require_request(
    const Model& model, std::string_view name, const Span& span, Report& report,
    const std::vector<std::uint32_t>& independent = {});

/// The outputs of the built-in scene `full`, in table order: all outputs of the model, except large
/// outputs and outputs that a scene must name.
[[nodiscard]] std::vector<OutputRequest> full_scene_requests(const Model& model);

/// The outputs that full_scene_requests() omits although a reader may expect them, by reason.
[[nodiscard]] std::vector<OmittedOutputs> outputs_omitted_by_full(const Model& model);

/// The first `abs`, `sign`, `min` or `max` in a force on a coordinate that is not locked; null if
/// there is none. Only forces may have kinks.
[[nodiscard]] const Expression* find_kink(const Model& model);

/// A row or column of a field: its name, unit, and leaf or entry.
struct FieldLine {
  /// "theta", "hand.m"; "tip[2]" for an [[output]] of several values; "x", "y", "z" (rows) and "x",
  /// "y", "z", "p" (columns) of a pose; "wx" to "vz" of a twist; "" for a single number.
  std::string name = {};
  /// The declared unit of the coordinate, velocity, input or other entry of the line; for the rate
  /// of a position constraint, the unit of the constraint per second. A line of an acceleration,
  /// state or pivot has the unit of the velocity or constraint.
  std::optional<Unit> unit = {};
  std::optional<Opcode> leaf = {};  ///< kind of the leaf; none: the line has no leaf
  std::uint32_t number = 0;         ///< number of the leaf, or index of the entry in its list
  bool is_rate = false;             ///< true for the lines of v in a state (q, v)
  bool is_numbered = false;         ///< true for values of an [[output]], named by their number

  /// "theta", "dot(theta)"
  [[nodiscard]] std::string text() const { return is_rate ? "dot(" + name + ")" : name; }
};

/// The lines along an extent, in order, with distinct texts. `user` is the index of an [[output]].
[[nodiscard]] std::vector<FieldLine> extent_lines(const Model& model, Extent extent,
                                                  std::uint32_t user = 0);

/// The line with index `at`; none if `at` is beyond the last line.
[[nodiscard]] std::optional<FieldLine> line_at(const Model& model, Extent extent, std::size_t at,
                                               std::uint32_t user = 0);

/// The names of the lines along an extent that have no leaf: held and cyclic coordinates, inertial
/// parameters. Values of an [[output]] are excluded.
[[nodiscard]] std::vector<std::string> names_without_leaf(const Model& model, Extent extent);

/// The number of lines along an extent. Cheaper than extent_lines(), because no names are built.
[[nodiscard]] std::uint32_t extent_size(const Model& model, Extent extent, std::uint32_t user = 0);

/// The number of entries of all fields before field number `field`: the index of the first entry of
/// this field. If `field` is the number of fields, the number of all entries.
[[nodiscard]] std::uint32_t first_entry_index(const Model& model, const OutputRequest& output,
                                              std::size_t field);

/// False for the residual of an explicit step, which does not exist; true for all other fields.
[[nodiscard]] bool has_field(const OutputRequest& output, const FieldRow& field);

/// The request for an output of this kind, with the shape of its first field. `user` is the index
/// of the [[output]].
[[nodiscard]] OutputRequest make_request(const Model& model, OutputKind kind, std::uint32_t user);

/// True if the model can provide the output.
[[nodiscard]] bool is_available(const Model& model, const OutputRequest& request);

/// The requests of these kinds that the model can provide.
[[nodiscard]] std::vector<OutputRequest> available_requests(
    const Model& model, std::initializer_list<OutputKind> kinds);

/// Reports E609 if a function of an [[output]] has the name of another output.
void check_output_names(const Model& model, Report& report);

}  // namespace elgen
