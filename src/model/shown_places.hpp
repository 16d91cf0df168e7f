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

/// The world coordinates of a place (three expressions); for a frame, the world coordinates of its
/// three axes follow (nine expressions).
[[nodiscard]] std::vector<ExpressionId> place_coordinates(const Model& model,
                                                          const ShownPlace& place);

/// A line between two places, given by their indices; to the world's origin if `to` is none.
struct ShownLine {
  std::uint32_t from = 0;
  std::optional<std::uint32_t> to = {};
  bool is_spring = false;
};

/// The lines that `joined_to` declares; a line from each frame to its parent; a line from each
/// point or body in a frame to this frame; and lines from each other point or body to the places
/// that occur in its position.
[[nodiscard]] std::vector<ShownLine> shown_lines(const Model& model);

/// "places", "masses", "laws", "integrals" or "kinks".
[[nodiscard]] std::string_view name_of(ShownValues shown);

/// The `conserved` entries that contain neither momenta nor E. Empty if the scene expands the
/// equations, or locks or eliminates variables.
[[nodiscard]] std::vector<ExpressionId> shown_integrals(const Model& model);

}  // namespace elgen
