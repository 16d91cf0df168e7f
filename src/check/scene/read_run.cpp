// The start of a run, given by options such as "theta=1", "dot(theta)=0", "attitude=[1,0,0,0]",
// "m=2". A state also has "dot(dot(theta))=3" and "t=1". Ranges of parameters: "m=1:2".
#include <algorithm>
#include <utility>

#include "base/reason.hpp"
#include "check/expressions/parameters.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/resolver.hpp"
#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"
#include "elgen/leaf_names.hpp"

namespace elgen {
namespace {

/// The consecutive start values that one name denotes.
struct StartVariable {
  std::string name;
  std::uint32_t coordinate = 0;
  std::uint32_t first = 0;  ///< index of a coordinate, or of a velocity
  std::uint32_t count = 1;
  bool is_rate = false;
  bool is_stated = false;  ///< stored by name in StateOverrides::others
};

std::vector<StartVariable> start_variables(const Model& model) {
  std::vector<StartVariable> places;
  for (std::uint32_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    if (coordinate.rotation) continue;
    places.push_back({coordinate.name, i, i});
    places.push_back({"dot(" + coordinate.name + ")", i, coordinate.velocity, 1, true});
  }
  for (const Rotation& rotation : model.rotations) {
    const std::uint32_t q = rotation.first_coordinate;
    const std::uint32_t v = rotation.first_velocity;
    places.push_back({rotation.name, q, q, quaternion_size});
    for (std::uint32_t i = v; i < v + axis_count; ++i) {
      places.push_back({"dot(" + model.velocities[i].name + ")", q, i, 1, true});
    }
  }
  return places;
}

/// The variables of a start, then the other leaves of a state. A coordinate named h comes before
/// the step h, so that the coordinate is found first.
std::vector<StartVariable> state_and_leaf_variables(const Model& model) {
  std::vector<StartVariable> places = start_variables(model);
  const auto none = static_cast<std::uint32_t>(model.coordinates.size());
  for (const LeafRow& row : leaf_table()) {
    if (!row.is_settable) continue;
    const bool is_of_velocities = row.owner == LeafOwner::velocities;
    for (std::uint32_t i = 0; i < leaf_count(model, row.id); ++i) {
      const std::uint32_t coordinate = is_of_velocities ? model.velocities[i].coordinate : none;
      places.push_back({leaf_text(model, row.id, i), coordinate, i, 1, false, true});
    }
  }
  return places;
}

class StartReader {
 public:
  StartReader(Context& context, std::vector<StartVariable> places, StateOverrides& stated)
      : context_(context),
        model_(context.model),
        values_(context),
        places_(std::move(places)),
        stated_(stated) {}

  void read(const KeySyntax& key) {
    const StartVariable* const place = find_start_variable(key);
    if (place == nullptr) return;
    const bool is_list = key.value.kind == ValueKind::list;
    const std::vector<ValueSyntax> items = is_list ? key.value.items : std::vector{key.value};
    if (items.size() != place->count) {
      context_.report.add(Code::E606, key.value.span,
                          quote_text(place->name) + " takes " + count_text(place->count, "number"));
      return;
    }
    for (std::uint32_t i = 0; i < place->count; ++i) {
      const auto value = values_.read_exact_constant(items[i]);
      if (!value) continue;
      store_value(*place, place->first + i, value->number);
      if (place->is_rate || place->is_stated) continue;
      note_degrees(context_.report, items[i].span, model_.coordinates[place->coordinate],
                   value->number);
    }
    check_quaternion_length(*place, key.value.span);
  }

 private:
  /// The variable that a key names; null after E612.
  const StartVariable* find_start_variable(const KeySyntax& key) {
    const auto found = std::ranges::find(places_, key.key, &StartVariable::name);
    if (found == places_.end()) {
      std::vector<std::string> names;
      for (const StartVariable& place : places_) names.push_back(place.name);
      const std::string hint =
          rate_hint(key.key.substr(0, key.key.find('[')), key.key, context_.symbols);
      context_.report.add(Code::E612, key.key_span, "unknown coordinate " + quote_text(key.key),
                          hint.empty() ? suggestion(key.key, names) : hint);
      return nullptr;
    }
    if (std::ranges::count(model_.reduction.locks, found->coordinate,
                           &LockedCoordinate::coordinate) > 0) {
      context_.report.add(Code::E612, key.key_span,
                          quote_text(key.key) + " is locked by the scene");
      return nullptr;
    }
    return &*found;
  }

  cln::cl_R& start_number(const StartVariable& place, std::uint32_t index) {
    return place.is_rate ? model_.velocities[index].start_rate
                         : model_.coordinates[index].start_value;
  }

  void store_value(const StartVariable& place, std::uint32_t index, const cln::cl_R& value) {
    if (place.is_stated) {
      stated_.others[place.name] = value;
      return;
    }
    start_number(place, index) = value;
    if (place.is_rate) stated_.velocities.insert(model_.velocities[index].name);
    if (!place.is_rate) stated_.coordinates.insert(model_.coordinates[index].name);
  }

  void check_quaternion_length(const StartVariable& place, const Span& value) {
    if (place.count != quaternion_size) return;
    for (std::uint32_t i = 0; i < place.count; ++i) {
      if (!cln::zerop(start_number(place, place.first + i))) return;
    }
    context_.report.add(Code::E606, value, "a quaternion of length 0 is no rotation");
  }

  Context& context_;
  Model& model_;
  ValueReader values_;
  std::vector<StartVariable> places_;
  StateOverrides& stated_;
};

/// Reads the law of an input. Gains are plain numbers, so the units of a law are not checked.
void read_law(Context& context, const KeySyntax& key, Scene& scene) {
  const std::string name = component_name(context.model, key.key);
  const auto input = std::ranges::find(context.model.inputs, name, &Input::name);
  if (input == context.model.inputs.end()) {
    const std::vector<std::string> names = context.symbols.names({SymbolKind::input});
    context.report.add(Reason::unknown_input, key.key_span, "unknown input " + quote_text(key.key),
                       context.symbols.suggest(key.key, names));
    return;
  }
  const auto index = static_cast<std::size_t>(input - context.model.inputs.begin());
  if (!remaining_variables(context.model).inputs[index]) {
    context.report.add({Code::E606, key.key_span,
                        quote_text(key.key) + " acts only on locked coordinates, so it has no law",
                        "", input->span, "declared here"});
    return;
  }
  const ExpressionRole place{"the law of an input", place::state_terms | uses_kink};
  const std::size_t known = context.roots.size();
  const ExpressionId law = ValueReader(context).root(key.value, {place, std::nullopt});
  if (context.roots.size() == known) return;
  context.roots.back().is_in_role_unit = true;
  scene.laws[input->name] = law;
}

/// The parameters that an option names; none after E602, or E606 if the scene fixes one.
std::vector<std::uint32_t> find_free_parameters(Context& context, const Scene& scene,
                                                const KeySyntax& key) {
  std::vector<std::uint32_t> found = find_parameters(context, key.key, key.key_span);
  for (const std::uint32_t target : found) {
    if (scene.specialisation.fixed.count(target) == 0) continue;
    context.report.add(Code::E606, key.key_span,
                       quote_text(key.key) + " is fixed, so it is no parameter");
    return {};
  }
  return found;
}

}  // namespace

void read_starts(Context& context, const SceneOptions& options, Scene& scene) {
  if (options.starts.empty()) return;
  StartReader reader(context,
                     options.purpose.accepts_all_leaves ? state_and_leaf_variables(context.model)
                                                        : start_variables(context.model),
                     scene.state_overrides);
  const auto keys = parse_option_keys(context, options.starts, KeyType::expression_or_list);
  for (const KeySyntax& key : keys) reader.read(key);
}

void read_laws(Context& context, const SceneOptions& options, Scene& scene) {
  for (const KeySyntax& key : parse_option_keys(context, options.laws, KeyType::expression)) {
    read_law(context, key, scene);
  }
}

void read_parameter_values(Context& context, const SceneOptions& options, Scene& scene) {
  ValueReader values(context);
  for (const KeySyntax& key : parse_option_keys(context, options.values, KeyType::expression)) {
    const auto targets = find_free_parameters(context, scene, key);
    if (targets.empty()) continue;
    const std::optional<FixedValue> value = values.read_exact_constant(key.value);
    for (const std::uint32_t target : targets) {
      if (!value) break;
      check_parameter_value(context, target, value->number, key.value.span);
      context.model.parameters[target].value = value->number;
      context.model.parameters[target].exact_expression = value->exact_expression;
      set_cyclic_momentum(context.model, target, value->number);
    }
  }
  for (const KeySyntax& key : parse_option_keys(context, options.over, KeyType::range)) {
    const auto targets = find_free_parameters(context, scene, key);
    const std::optional<Interval> ends = values.read_interval(key.value);
    for (const std::uint32_t target : targets) {
      if (!ends) break;
      check_parameter_value(context, target, ends->low, key.value.items[0].span);
      check_parameter_value(context, target, ends->high, key.value.items[1].span);
      scene.numerics.varied_parameters[target] = *ends;
    }
  }
}

}  // namespace elgen
