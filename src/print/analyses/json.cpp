// json: results of analyses for other programs. Numbers have enough digits to distinguish doubles.
#include "base/json.hpp"

#include "elgen/analysis_pages.hpp"
#include "elgen/real.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

Json number_json(const cln::cl_R& value) { return to_double(value); }
Json number_json(double value) { return value; }

template <class Number>
Json matrix_json(const std::vector<Number>& values, std::size_t columns) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % columns == 0) rows.push_back(Json::array());
    rows.back().push_back(number_json(values[i]));
  }
  return rows;
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

/// The formula of a form as text; null if the form is not readable.
Json form_json(const PageForms& known, const OptionalFraction& form) {
  const std::optional<Formula> formula = known.to_formula(form);
  return formula ? Json(text_of(*formula)) : Json(nullptr);
}

Json coordinates_json(const PageForms& known, const RestPoint& point) {
  Json object = Json::object();
  for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
    const RestCoordinate& coordinate = point.coordinates[i];
    Json& entry = object[known.model.coordinates[i].name];
    if (coordinate.is_arbitrary) entry["any"] = true;
    entry["value"] = to_double(coordinate.value);
    Json form = form_json(known, coordinate.closed_form);
    if (!form.is_null()) entry["form"] = std::move(form);
  }
  return object;
}

Json point_json(const PageForms& known, const RestPoint& point) {
  const std::size_t n = known.model.velocities.size();
  Json object{{"coordinates", coordinates_json(known, point)},
              {"M", matrix_json(point.mass, n)},
              {"D", matrix_json(point.damping, n)},
              {"K", matrix_json(point.stiffness, n)}};
  object["stability"] = name_of(point.stability.kind);
  object["growth_rates"] = point.stability.growth_rates;
  return object;
}

Json symmetry_json(const PageForms& known, const Symmetry& symmetry) {
  Json displacement = Json::array();
  for (const Fraction& along : symmetry.displacement) {
    displacement.push_back(form_json(known, along));
  }
  return {{"kind", name_of(symmetry.kind)},
          {"displacement", displacement},
          {"time", form_json(known, symmetry.generator.back())},
          {"integral", form_json(known, symmetry.momentum_form)},
          {"closed_form", form_json(known, symmetry.velocity_form)},
          {"F", form_json(known, symmetry.gauge_function)},
          {"rate", form_json(known, symmetry.rate)},
          {"proved", symmetry.is_proved},
          {"generic", !symmetry.is_at_values_only}};
}

}  // namespace

std::string equilibria_json(const CheckedModel& checked, const Equilibria& equilibria) {
  const Model& model = checked.model;
  const PageForms known(model, equilibria.forms);
  Json inputs = Json::object();
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    inputs[model.inputs[i].name] = to_double(equilibria.inputs[i]);
  }
  Json points = Json::array();
  for (const RestPoint& point : equilibria.points) {
    points.push_back(point_json(known, point));
    points.back()["exact"] = point.is_exact;
  }
  Json undecided = Json::array();
  for (const UndecidedBox& box : equilibria.undecided_boxes) {
    Json& place = undecided.push_back(Json::object());
    for (const auto& [coordinate, sides] : box) {
      place[model.coordinates[coordinate].name] = {to_double(sides.low), to_double(sides.high)};
    }
  }
  Json breaks = Json::array();
  for (const ChartSingularity& here : equilibria.chart_singularities) {
    Json& place = breaks.push_back(Json::object());
    place[model.coordinates[here.coordinate].name] = to_double(here.value.value);
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

std::string modes_json(const CheckedModel& checked, const Modes& modes) {
  const Model& model = checked.model;
  const PageForms known(model, modes.forms);
  Json points = Json::array();
  for (const LinearMotions& motions : modes.motions) {
    Json point = point_json(known, motions.point);
    const std::size_t states = 2 * model.velocities.size();
    Json squares = Json::array();
    Json shapes = Json::array();
    for (const NormalMode& mode : motions.modes) {
      squares.push_back(to_double(mode.omega_squared));
      shapes.push_back(mode.shape);
    }
    Json poles = Json::array();
    for (const std::complex<double>& pole : motions.poles) {
      poles.push_back(Json{pole.real(), pole.imag()});
    }
    point["omega_squared"] = squares;
    point["shapes"] = shapes;
    point["A"] = matrix_json(motions.a, states);
    if (!model.inputs.empty()) {
      point["B"] = matrix_json(motions.b, model.inputs.size());
      point["controllable_rank"] = motions.controllable_rank;
    }
    point["poles"] = poles;
    points.push_back(std::move(point));
  }
  const Json object{{"model", model.name}, {"points", points}};
  return object.dump(1) + "\n";
}

std::string symmetries_json(const CheckedModel& checked, const Symmetries& symmetries) {
  PageForms known(checked.model, symmetries.forms);
  Json list = Json::array();
  for (const Symmetry& symmetry : symmetries.symmetries)
    list.push_back(symmetry_json(known, symmetry));
  const Json object{{"model", checked.model.name},
                    {"unknowns", symmetries.unknowns},
                    {"exact", symmetries.is_exact},
                    {"complete", symmetries.is_complete},
                    {"sampled", symmetries.sampled},
                    {"states", symmetries.states},
                    {"symmetries", list},
                    {"conserved", stated_integrals(checked, known, symmetries)}};
  return object.dump(1) + "\n";
}

std::string base_parameters_json(const CheckedModel& checked, const BaseParameters& found) {
  Json base = Json::array();
  for (const BaseParameter& parameter : found.base) {
    Json terms = Json::object();
    terms[found.parameters[parameter.parameter].name] = 1.0;
    for (const WeightedParameter& other : parameter.regrouped_terms) {
      terms[found.parameters[other.parameter].name] = to_double(other.factor);
    }
    base.push_back({{"parameters", terms}, {"value", to_double(parameter.value)}});
  }
  Json names = Json::array();
  for (const InertialParameter& parameter : found.parameters) names.push_back(parameter.name);
  Json unseen = Json::array();
  for (const std::uint32_t k : found.unidentifiable) unseen.push_back(found.parameters[k].name);
  const Json object{
      {"model", checked.model.name}, {"parameters", names},    {"base", base},
      {"without_effect", unseen},    {"states", found.states}, {"exact", found.is_exact}};
  return object.dump(1) + "\n";
}

}  // namespace elgen
