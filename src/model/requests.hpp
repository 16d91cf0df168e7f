// Requests: which outputs a model has, and their shapes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The request for a name: built-in outputs, and NAME, NAME_jacobian, NAME_bias of declared ones.
[[nodiscard]] std::optional<OutputRequest> find_request(const Model& model, std::string_view name);

/// Like find_request, with E601, E603, E505, E534 or E633 if the model lacks the output. The
/// independent velocities are those that the scene names for `completed`.
[[nodiscard]] std::optional<OutputRequest> require_request(
    const Model& model, std::string_view name, const Span& span, Report& report,
    const std::vector<std::uint32_t>& independent = {});

/// All outputs of the model in table order, except big ones and ones that must be requested by
/// name.
[[nodiscard]] std::vector<OutputRequest> full_requests(const Model& model);

/// The outputs that full_requests omits and a reader may look for, grouped by reason.
[[nodiscard]] std::vector<LeftOut> left_out_of_full(const Model& model);

/// An `abs`, `sign`, `min` or `max` in a force on an unlocked coordinate; null if there is none.
/// Only forces may have kinks.
[[nodiscard]] const Expression* find_kink(const Model& model);

/// A row or column of a field: its name, its unit, and the leaf or entry that it stands for.
struct Line {
  /// "theta", "hand.m"; "tip[2]" in an [[output]] of several values; in a pose "x", "y", "z" by
  /// "x", "y", "z", "p", in a twist "wx" to "vz"; empty if the line is a single number.
  std::string name = {};
  /// The unit that the model declares for the entry; for the rate of a constraint that unit per
  /// second. Accelerations, both halves of a state and pivots have the unit of their entry.
  std::optional<Unit> unit = {};
  std::optional<Opcode> leaf = {};  ///< the kind of the leaf that it stands for, if any
  std::uint32_t number = 0;         ///< of the leaf, or of the entry in its list
  bool is_rate = false;             ///< the rate in a state (q, v)
  bool is_numbered = false;         ///< of an [[output]]: its number determines its name

  /// "theta", "dot(theta)"
  [[nodiscard]] std::string text() const { return is_rate ? "dot(" + name + ")" : name; }
};

/// The rows or columns in order, with distinct texts; `user` is the number of an [[output]].
[[nodiscard]] std::vector<Line> lines_along(const Model& model, Extent extent,
                                            std::uint32_t user = 0);

/// The line with this index; none beyond the last.
[[nodiscard]] std::optional<Line> line_at(const Model& model, Extent extent, std::size_t at,
                                          std::uint32_t user = 0);

/// The names of rows or columns that stand for no leaf of the model, so that no list of leaves
/// names them: coordinates that are held or cyclic, inertial parameters. Values of an [[output]]
/// are not among them.
[[nodiscard]] std::vector<std::string> unlisted_names(const Model& model, Extent extent);

/// The number of rows or columns: cheap, since no name is built.
[[nodiscard]] std::uint32_t extent_of(const Model& model, Extent extent, std::uint32_t user = 0);

/// The number of the first entry of a field, or of entries if `field` is the number of fields. It
/// counts every field before it in the output table.
[[nodiscard]] std::uint32_t first_entry_of(const Model& model, const OutputRequest& output,
                                           std::size_t field);

/// Whether the output gives this field of its row: explicit steps leave no remainder.
[[nodiscard]] bool gives_field(const OutputRequest& output, const FieldRow& field);

/// The request for a kind, with the shape of its first field; `user` as in extent_of.
[[nodiscard]] OutputRequest request_of(const Model& model, OutputKind kind, std::uint32_t user);

/// Whether the model can give the output.
[[nodiscard]] bool is_available(const Model& model, const OutputRequest& request);

/// The requests of these kinds that the model can give.
[[nodiscard]] std::vector<OutputRequest> available_requests(
    const Model& model, std::initializer_list<OutputKind> kinds);

/// E609 if user-defined outputs share a function name with each other or with built-in ones.
void check_output_names(const Model& model, Report& report);

}  // namespace elgen
