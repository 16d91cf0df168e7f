// shown_places: the points, bodies and frames that a page draws, and the lines between them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/scene.hpp"

namespace elgen {

enum class PlaceKind : std::uint8_t { point, body, frame };

/// A point, the centre of mass of a body, or the origin of a frame with its three axes.
struct ShownPlace {
  PlaceKind kind = PlaceKind::point;
  std::uint32_t index = 0;
  std::string name = {};
  std::optional<ExpressionId> mass = {};
};

/// Points, bodies with a mass, and frames, each in file order. Empty if `[routh]` eliminates
/// coordinates.
[[nodiscard]] std::vector<ShownPlace> shown_places(const Model& model);

/// World coordinates of a place, three numbers per row; for a frame three rows with its axes
/// follow.
[[nodiscard]] std::vector<ExpressionId> rows_of(const Model& model, const ShownPlace& place);

/// A line between two places, by number. `to` none: the origin of the world.
struct ShownLine {
  std::uint32_t from = 0;
  std::optional<std::uint32_t> to = {};
  bool is_spring = false;
};

/// The lines from a place to the places that its position contains, from a frame to its parent, and
/// of `joined_to`.
[[nodiscard]] std::vector<ShownLine> shown_lines(const Model& model);

/// "places"
[[nodiscard]] std::string_view name_of(ShownValues shown);

/// The `conserved` entries without momenta and E. Empty if a scene expands, locks or eliminates.
[[nodiscard]] std::vector<ExpressionId> shown_integrals(const Model& model);

}  // namespace elgen
