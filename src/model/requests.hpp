// Requests: which outputs a model has, and their shapes.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// The request for a name: built-in outputs, and NAME, NAME_jacobian, NAME_bias of declared ones.
[[nodiscard]] std::optional<OutputRequest> find_request(const Model& model, std::string_view name);

/// As find_request, with E601, E603, E505, E534 or E633 where the name is no output of the model.
[[nodiscard]] std::optional<OutputRequest> require_request(const Model& model,
                                                           std::string_view name, const Span& span,
                                                           Report& report);

/// Every output the model has, in the order of the output table, without big ones and those that
/// only a name asks for.
[[nodiscard]] std::vector<OutputRequest> full_requests(const Model& model);

/// The outputs that full_requests leaves out though a reader may look for them, once per reason.
[[nodiscard]] std::vector<LeftOut> left_out_of_full(const Model& model);

/// An `abs`, `sign`, `min` or `max` in a force on what moves: only forces may have kinks. Null:
/// none.
[[nodiscard]] const Expression* find_kink(const Model& model);

/// How many rows or columns that is; `user` numbers declared outputs.
[[nodiscard]] std::uint32_t extent_of(const Model& model, Extent kind, std::uint32_t user = 0);

/// The coordinate, rate, input or constraint that a row or column stands for, or its number.
struct LineLabel {
  std::string name = {};
  bool is_rate = false;

  /// "theta", "dot(theta)"
  [[nodiscard]] std::string text() const { return is_rate ? "dot(" + name + ")" : name; }
  friend auto operator<=>(const LineLabel&, const LineLabel&) = default;
};

/// The labels of so many rows or columns; numbers where they stand for none of these.
[[nodiscard]] std::vector<LineLabel> line_labels(const Model& model, Extent extent,
                                                 std::uint32_t count);

/// The number of the first entry of a field, where the fields before it in the output table are all
/// there.
[[nodiscard]] std::uint32_t first_entry_of(const Model& model, OutputKind kind, std::size_t field);

/// The request for a kind with the shape of its first field; `user` numbers declared outputs.
[[nodiscard]] OutputRequest request_of(const Model& model, OutputKind kind, std::uint32_t user);

/// Whether the model has what the output needs.
[[nodiscard]] bool is_available(const Model& model, const OutputRequest& request);

/// Requests of these kinds whose needs the model meets.
[[nodiscard]] std::vector<OutputRequest> available_requests(
    const Model& model, std::initializer_list<OutputKind> kinds);

/// E609 where declared outputs would share a function name with each other or with the built-in
/// ones.
void check_output_names(const Model& model, Report& report);

}  // namespace elgen
