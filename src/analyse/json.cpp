// Results of the analysis as JSON, for programs: numbers in the digits that tell doubles apart.
#include <nlohmann/json.hpp>

#include "analyse/formulas.hpp"
#include "analyse/linear_equations.hpp"
#include "elgen/analyse.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

double double_of(const cln::cl_R& value) { return ScalarTraits<double>::from_real(value); }

Json rows_json(const std::vector<double>& values, std::size_t columns) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < values.size(); i += columns) {
    Json row = Json::array();
    for (std::size_t k = 0; k < columns; ++k) row.push_back(values[i + k]);
    rows.push_back(std::move(row));
  }
  return rows;
}

Json matrix_json(const std::vector<cln::cl_R>& values, std::size_t columns) {
  return rows_json(doubles_of(values), columns);
}

const char* name_of(Stability stability) {
  if (is_stable(stability)) return "stable";
  return stability == Stability::unstable ? "unstable" : "undecided";
}

const char* name_of(Completeness completeness) {
  switch (completeness) {
    case Completeness::proved:
      return "proved";
    case Completeness::undecided:
      return "undecided";
    case Completeness::searched:
      return "searched";
  }
  return "";
}

Json coordinates_json(const Model& model, const Algebra& algebra, const RestPoint& point) {
  Json object = Json::object();
  for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
    const CoordinateAtRest& coordinate = point.coordinates[i];
    Json& entry = object[model.coordinates[i].name];
    if (coordinate.is_any) entry["any"] = true;
    entry["value"] = double_of(coordinate.value);
    if (!coordinate.form) continue;
    const auto formula = printed(model, algebra, coordinate.form);
    if (formula) entry["form"] = formula->text;
  }
  return object;
}

Json point_json(const Model& model, const Algebra& algebra, const RestPoint& point) {
  const std::size_t n = model.velocities.size();
  Json object{{"coordinates", coordinates_json(model, algebra, point)},
              {"M", matrix_json(point.mass, n)},
              {"D", matrix_json(point.damping, n)},
              {"K", matrix_json(point.stiffness, n)}};
  object["stability"] = name_of(point.stability.kind);
  object["growth_rates"] = point.stability.growth_rates;
  return object;
}

}  // namespace

std::string equilibria_json(const CheckedModel& checked, const Equilibria& equilibria) {
  const Model& model = checked.model;
  Json inputs = Json::object();
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    inputs[model.inputs[i].name] = double_of(equilibria.inputs[i]);
  }
  Json points = Json::array();
  for (const RestPoint& point : equilibria.points) {
    points.push_back(point_json(model, equilibria.forms.algebra, point));
    points.back()["exact"] = point.is_exact;
  }
  Json undecided = Json::array();
  for (const UndecidedBox& box : equilibria.undecided) {
    Json& place = undecided.emplace_back(Json::object());
    for (const auto& [coordinate, sides] : box) {
      place[model.coordinates[coordinate].name] = {double_of(sides.low), double_of(sides.high)};
    }
  }
  Json breaks = Json::array();
  for (const ChartBreak& here : equilibria.breaks) {
    Json& place = breaks.emplace_back(Json::object());
    place[model.coordinates[here.coordinate].name] = double_of(here.at.value);
  }
  const Json object{{"model", model.name},
                    {"inputs", inputs},
                    {"points", points},
                    {"completeness", name_of(equilibria.completeness)},
                    {"undecided", undecided},
                    {"boxes", equilibria.boxes},
                    {"starts", equilibria.starts},
                    {"chart_breaks", breaks}};
  return object.dump(1) + "\n";
}

std::string modes_json(const CheckedModel& checked, const Equilibria& equilibria,
                       const std::vector<LinearMotions>& all) {
  const Model& model = checked.model;
  Json points = Json::array();
  for (const LinearMotions& motions : all) {
    Json point = point_json(model, equilibria.forms.algebra, motions.point);
    const std::size_t states = 2 * model.velocities.size();
    Json squares = Json::array();
    Json shapes = Json::array();
    for (const NormalMode& mode : motions.modes) {
      squares.push_back(double_of(mode.omega_squared));
      shapes.push_back(mode.shape);
    }
    Json poles = Json::array();
    for (const std::complex<double>& pole : motions.poles) {
      poles.push_back(Json{pole.real(), pole.imag()});
    }
    point["omega_squared"] = squares;
    point["shapes"] = shapes;
    point["A"] = rows_json(motions.a, states);
    if (!model.inputs.empty()) {
      point["B"] = rows_json(motions.b, model.inputs.size());
      point["controllable_rank"] = motions.controllable;
    }
    point["poles"] = poles;
    points.push_back(std::move(point));
  }
  const Json object{{"model", model.name}, {"points", points}};
  return object.dump(1) + "\n";
}

}  // namespace elgen
