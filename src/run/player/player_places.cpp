// add_places: places as rows of a function of the program, and the plane of the motion. Rows are
// compared with 0 in the program, where the sums of frames have been simplified.
#include "run/player/player_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "elgen/oracle.hpp"
#include "elgen/real.hpp"
#include "model/shown_places.hpp"

namespace elgen {
namespace {

/// The index of each place's first row in the output that contains all places.
std::vector<std::size_t> first_rows(const Model& model, const std::vector<ShownPlace>& places) {
  std::vector<std::size_t> rows;
  std::size_t next = 0;
  for (const ShownPlace& place : places) {
    rows.push_back(next);
    next += place_coordinates(model, place).size() / 3;
  }
  return rows;
}

/// The function of the program that returns the coordinates of all places, three in each row.
class PlaceRows {
 public:
  PlaceRows(const Program& program, const Function& function)
      : program_(program), function_(function), entries_(entries_of(function)) {}

  /// True if the component of `row` along `axis` is the number 0 at every state.
  [[nodiscard]] bool is_zero(std::size_t row, std::size_t axis) const {
    return loads_zero(program_, function_.instructions[entries_[3 * row + axis]]);
  }

  /// True if a row depends on neither coordinates nor time: a place that is fixed to the world.
  [[nodiscard]] bool is_fixed(std::size_t row) const {
    const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(3 * row);
    const std::vector<bool> needed = needed_instructions(function_, {first, first + 3});
    for (std::size_t at = 0; at < needed.size(); ++at) {
      const Opcode opcode = function_.instructions[at].opcode;
      if (needed[at] && (opcode == Opcode::coordinate || opcode == Opcode::time)) return false;
    }
    return true;
  }

 private:
  const Program& program_;
  const Function& function_;
  std::vector<std::uint32_t> entries_;
};

/// None if the page draws no places.
std::optional<PlaceRows> find_place_rows(const Scene& scene, const Program& program) {
  for (const Function& function : program.functions) {
    const bool is_shown = is_user_value(output_row(function.kind));
    if (is_shown && scene.page_outputs.at(function.user) == ShownValues::places)
      return PlaceRows(program, function);
  }
  return std::nullopt;
}

/// True if all positions, and two axes of each frame, have no component along `axis`: then the
/// motion is in the plane through the origin that is perpendicular to it.
bool stays_in_plane(const PlaceRows& at, const std::vector<ShownPlace>& places,
                    const std::vector<std::size_t>& rows, std::size_t axis) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!at.is_zero(rows[i], axis)) return false;
    std::size_t out_of_plane = 0;
    for (std::size_t k = 1; k <= 3 && places[i].kind == PlaceKind::frame; ++k) {
      if (!at.is_zero(rows[i] + k, axis)) ++out_of_plane;
    }
    if (out_of_plane > 1) return false;
  }
  return true;
}

/// A direction along an axis of the world, or against it.
struct AxisDirection {
  std::size_t axis = 2;
  int sign = 1;
};

/// The axis along which gravity is largest, against gravity; none without gravity.
std::optional<AxisDirection> up_axis(const CheckedModel& checked) {
  if (!checked.model.gravity) return std::nullopt;
  const State state = nominal_state(checked.model, checked.scene);
  std::optional<AxisDirection> up;
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value =
        oracle_expression_value(checked.model, (*checked.model.gravity)[axis], state);
    const double component = value ? to_double(*value) : 0;
    if (std::abs(component) <= largest) continue;
    largest = std::abs(component);
    up = AxisDirection{axis, component > 0 ? -1 : 1};
  }
  return up;
}

/// The directions that the page draws to the right, upwards, and away from the viewer. In space
/// they are right-handed. `normal`: the axis perpendicular to a plane motion.
Json axes_json(std::optional<AxisDirection> up, std::optional<std::size_t> normal) {
  if (!up || up->axis == normal)
    up = AxisDirection{normal == std::size_t{2} ? std::size_t{1} : std::size_t{2}};
  const std::size_t right = normal ? 3 - up->axis - *normal : (up->axis + 1) % 3;
  const std::size_t away = 3 - up->axis - right;
  return {{right, 1}, {up->axis, up->sign}, {away, up->sign}};
}

}  // namespace

void add_places(Json& json, const CheckedModel& checked, const Program& program) {
  const Model& model = checked.model;
  const std::vector<ShownPlace> places = shown_places(model);
  const std::vector<std::size_t> rows = first_rows(model, places);
  const std::optional<PlaceRows> at = find_place_rows(checked.scene, program);
  const std::optional<AxisDirection> up = up_axis(checked);
  std::optional<std::size_t> normal;
  for (std::size_t axis = 0; at && axis < 3; ++axis) {
    const bool is_better = !normal || !up || up->axis != axis;  // gravity is drawn in the plane
    if (is_better && stays_in_plane(*at, places, rows, axis)) normal = axis;
  }
  Json list = Json::array();
  std::size_t masses = 0;
  std::size_t trail = rows.empty() ? 0 : rows.back();
  for (std::size_t i = 0; i < places.size(); ++i) {
    list.push_back({{"row", rows[i]},
                    {"is_frame", places[i].kind == PlaceKind::frame},
                    {"is_fixed", at && at->is_fixed(rows[i])},
                    {"mass", places[i].mass ? Json(masses++) : Json(nullptr)}});
    if (places[i].kind == PlaceKind::point) trail = rows[i];
  }
  Json lines = Json::array();
  for (const auto& [from, to, is_spring] : shown_lines(model)) {
    lines.push_back({rows[from], to ? Json(rows[*to]) : Json(nullptr), is_spring});
  }
  json["places"] = std::move(list);
  json["lines"] = std::move(lines);
  json["trail"] = trail;
  json["is_planar"] = places.empty() || normal.has_value();
  json["axes"] = axes_json(up, normal);
}

}  // namespace elgen
