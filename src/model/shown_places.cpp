// shown_places: the places that a page draws, and the lines between them. A line joins places A and
// B if the position of A contains components of B, directly or through definitions.
#include "model/shown_places.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "elgen/references.hpp"

namespace elgen {
namespace {

/// The index of a place in `places`; none if it is missing.
std::optional<std::uint32_t> find_place_index(const std::vector<ShownPlace>& places, PlaceKind kind,
                                              std::uint32_t index) {
  const auto found = std::ranges::find_if(
      places, [&](const ShownPlace& place) { return place.kind == kind && place.index == index; });
  if (found == places.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - places.begin());
}

struct PlaceReference {
  PlaceKind kind = PlaceKind::point;
  std::uint32_t index = 0;
};

/// The place that has the node as a component; none if the node is not a component of a place.
std::optional<PlaceReference> referenced_place(const Expression& node) {
  if (node.kind != ExpressionKind::named) return std::nullopt;
  switch (node.named) {
    case NamedKind::point:
      return PlaceReference{PlaceKind::point, node.index};
    case NamedKind::body:
      return PlaceReference{PlaceKind::body, node.index};
    case NamedKind::frame:
      return PlaceReference{PlaceKind::frame, node.index};
    case NamedKind::prescribed:
    case NamedKind::definition:
      break;
  }
  return std::nullopt;
}

/// The places whose components the expressions `open` contain. The positions of these places are
/// not searched further.
std::set<std::uint32_t> referenced_places(const Model& model, const std::vector<ShownPlace>& places,
                                          std::vector<ExpressionId> open) {
  std::set<std::uint32_t> named;
  std::set<ExpressionId> seen;
  while (!open.empty()) {
    const ExpressionId id = open.back();
    open.pop_back();
    if (!seen.insert(id).second) continue;
    const Expression& node = model.expressions[id];
    if (const std::optional<PlaceReference> place = referenced_place(node)) {
      const auto number = find_place_index(places, place->kind, place->index);
      if (number) named.insert(*number);
    } else {
      for (const ExpressionId each : references(model, id)) open.push_back(each);
    }
  }
  return named;
}

/// The frame in which a point or body is declared, or the parent of a frame; none: the world.
std::optional<std::uint32_t> carrying_frame(const Model& model, const ShownPlace& place) {
  if (place.kind == PlaceKind::frame) return model.frames[place.index].parent;
  if (place.kind == PlaceKind::body) {
    const auto& local = model.bodies[place.index].local;
    return local ? std::optional(local->com.frame) : std::nullopt;
  }
  const auto& local = model.points[place.index].local;
  return local ? std::optional(local->frame) : std::nullopt;
}

/// Adds a line unless both ends are the same place or the line exists. Springs are added first, so
/// they are not replaced by rods.
void add_line(std::vector<ShownLine>& lines, const ShownLine& line) {
  if (line.from == line.to) return;
  const auto same = std::ranges::find_if(lines, [&](const ShownLine& other) {
    return other.from == line.from && other.to == line.to;
  });
  if (same == lines.end()) lines.push_back(line);
}

/// If the place `from` is a point, adds the lines that `joined_to` of the point declares.
void add_joined_lines(const Model& model, const std::vector<ShownPlace>& places, std::uint32_t from,
                      std::vector<ShownLine>& lines) {
  if (places[from].kind != PlaceKind::point) return;
  const Point& point = model.points[places[from].index];
  for (const LineEnd& joined : point.line_ends) {
    ShownLine line{from, {}, point.has_springs};
    if (joined.point) line.to = find_place_index(places, PlaceKind::point, *joined.point);
    if (joined.frame) line.to = find_place_index(places, PlaceKind::frame, *joined.frame);
    add_line(lines, line);
  }
}

}  // namespace

std::vector<ShownPlace> shown_places(const Model& model) {
  std::vector<ShownPlace> places;
  // Positions may depend on cyclic coordinates, which the model no longer has.
  if (!model.reduction.cyclic.empty()) return places;
  for (std::uint32_t i = 0; i < model.points.size(); ++i) {
    if (!model.points[i].is_named) continue;
    places.push_back({PlaceKind::point, i, model.points[i].name, model.points[i].mass});
  }
  for (std::uint32_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.mass) places.push_back({PlaceKind::body, i, body.name, body.mass});
  }
  for (std::uint32_t i = 0; i < model.frames.size(); ++i) {
    places.push_back({PlaceKind::frame, i, model.frames[i].name, {}});
  }
  return places;
}

std::vector<ExpressionId> place_coordinates(const Model& model, const ShownPlace& place) {
  if (place.kind == PlaceKind::frame) {
    const Frame& frame = model.frames[place.index];
    std::vector<ExpressionId> rows(frame.origin.begin(), frame.origin.end());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < 3; ++i) rows.push_back(frame.rotation[3 * i + axis]);
    }
    return rows;
  }
  const Vector3& at = place.kind == PlaceKind::point ? model.points[place.index].position
                                                     : model.bodies[place.index].com;
  return {at.begin(), at.end()};
}

std::vector<ShownLine> shown_lines(const Model& model) {
  const std::vector<ShownPlace> places = shown_places(model);
  std::vector<ShownLine> lines;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    add_joined_lines(model, places, i, lines);
    const std::optional<std::uint32_t> carrier = carrying_frame(model, places[i]);
    if (carrier) add_line(lines, {i, find_place_index(places, PlaceKind::frame, *carrier)});
    if (carrier || places[i].kind == PlaceKind::frame) continue;
    for (const std::uint32_t to :
         referenced_places(model, places, place_coordinates(model, places[i]))) {
      add_line(lines, {i, to});
    }
  }
  return lines;
}

std::string_view name_of(ShownValues shown) {
  constexpr std::array<std::string_view, 5> names{"places", "masses", "laws", "integrals", "kinks"};
  return names[static_cast<std::size_t>(shown)];
}

std::vector<ExpressionId> shown_integrals(const Model& model) {
  std::vector<ExpressionId> integrals;
  const bool is_variant = !model.reduction.locks.empty() || !model.reduction.cyclic.empty();
  if (model.approximation || is_variant) return integrals;
  for (const Expectation& expectation : model.expectations) {
    if (!expectation.claims_conservation()) continue;
    for (const ExpressionId id : expectation.entries) {
      const bool is_of_motion = contains_leaf(model, id, Opcode::momentum | Opcode::energy);
      if (!is_of_motion) integrals.push_back(id);
    }
  }
  return integrals;
}

}  // namespace elgen
