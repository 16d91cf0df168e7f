// The start of a run, word by word: "theta=1", "dot(theta)=0", "attitude=[1,0,0,0]", "m=2".
#include <algorithm>

#include "check/expressions/options.hpp"
#include "check/expressions/parameters.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"

namespace elgen {
namespace {

/// Nothing after E606.
std::optional<Assignment> assignment_of(Context& context, const OptionWord& word) {
  Assignment assignment = split_assignment(word);
  std::erase(assignment.name.text, ' ');
  if (assignment.value.begin < assignment.value.end) return assignment;
  context.report.add(Code::E606, word.span, in_backticks(word.text) + " has no value");
  return std::nullopt;
}

std::optional<ExpressionSyntax> expression_of(Context& context, const Span& text) {
  Result<ExpressionSyntax> read = parse_expression(text, context.limits);
  for (const Diagnostic& diagnostic : read.diagnostics) context.report.add(diagnostic);
  return std::move(read.value);
}

std::optional<FixedValue> constant_of(Context& context, const Span& text) {
  const std::optional<ExpressionSyntax> expression = expression_of(context, text);
  if (!expression) return std::nullopt;
  ValueSyntax value;
  value.expression = *expression;
  return ValueReader(context, Scope(context.sizes)).constant_with_form(value);
}

/// The texts of "[a, b]", or of one number.
std::vector<OptionWord> items_of(Span text) {
  const std::string_view covered = covered_text(text);
  if (!covered.starts_with('[') || !covered.ends_with(']')) {
    return {{std::string(covered), text}};
  }
  ++text.begin;
  --text.end;
  return split_at_commas(text);
}

/// The numbers of a start that one name stands for, side by side.
struct StartPlace {
  std::string name;
  std::uint32_t coordinate = 0;
  std::uint32_t first = 0;  ///< of coordinates, or of velocities
  std::uint32_t count = 1;
  bool is_rate = false;
};

std::vector<StartPlace> start_places(const Model& model) {
  std::vector<StartPlace> places;
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

class StartReader {
 public:
  explicit StartReader(Context& context)
      : context_(context), model_(context.model), places_(start_places(model_)) {}

  void read(const OptionWord& word) {
    const std::optional<Assignment> given = assignment_of(context_, word);
    const StartPlace* const place = given ? place_of(given->name) : nullptr;
    if (place == nullptr) return;
    const std::vector<OptionWord> items = items_of(given->value);
    if (items.size() != place->count) {
      context_.report.add(Code::E606, given->value,
                          in_backticks(place->name) + " takes " + counted(place->count, "number"));
      return;
    }
    for (std::uint32_t i = 0; i < place->count; ++i) {
      const std::optional<FixedValue> value = constant_of(context_, items[i].span);
      if (!value) continue;
      give(*place, place->first + i, value->number);
      if (place->is_rate) continue;
      note_degrees(context_.report, items[i].span, model_.coordinates[place->coordinate],
                   value->number);
    }
    check_direction(*place, given->value);
  }

 private:
  /// Null after E612.
  const StartPlace* place_of(const OptionWord& name) {
    const auto found = std::ranges::find(places_, name.text, &StartPlace::name);
    if (found == places_.end()) {
      std::vector<std::string> names;
      for (const StartPlace& place : places_) names.push_back(place.name);
      context_.report.add(Code::E612, name.span, "unknown coordinate " + in_backticks(name.text),
                          suggestion(name.text, names));
      return nullptr;
    }
    if (std::ranges::count(model_.variant.locks, found->coordinate, &Lock::coordinate) > 0) {
      context_.report.add(Code::E612, name.span,
                          in_backticks(name.text) + " is locked by the scene");
      return nullptr;
    }
    return &*found;
  }

  cln::cl_R& number(const StartPlace& place, std::uint32_t index) {
    return place.is_rate ? model_.velocities[index].start_rate
                         : model_.coordinates[index].start_value;
  }

  void give(const StartPlace& place, std::uint32_t index, const cln::cl_R& value) {
    number(place, index) = value;
    (place.is_rate ? model_.velocities[index].is_start_named
                   : model_.coordinates[index].is_start_named) = true;
  }

  void check_direction(const StartPlace& place, const Span& value) {
    if (place.count != quaternion_size) return;
    for (std::uint32_t i = 0; i < place.count; ++i) {
      if (!cln::zerop(number(place, place.first + i))) return;
    }
    context_.report.add(Code::E606, value, "a quaternion of length 0 is no rotation");
  }

  Context& context_;
  Model& model_;
  std::vector<StartPlace> places_;
};

/// Gains are plain numbers, so the units of a law are not judged.
void read_law(Context& context, const OptionWord& word) {
  const std::optional<Assignment> given = assignment_of(context, word);
  if (!given) return;
  const auto input = std::ranges::find(context.model.inputs, given->name.text, &Input::name);
  if (input == context.model.inputs.end()) {
    const std::vector<std::string> names = context.symbols.names({SymbolKind::input});
    context.report.add(Code::E201, given->name.span,
                       "unknown input " + in_backticks(given->name.text),
                       context.symbols.suggest(given->name.text, names));
    return;
  }
  const std::optional<ExpressionSyntax> expression = expression_of(context, given->value);
  if (!expression) return;
  const Place place{"the law of an input", place::of_state | uses_kink};
  const std::size_t known = context.roots.size();
  const ExpressionId law =
      ValueReader(context, Scope(context.sizes)).root(*expression, {place, std::nullopt});
  if (context.roots.size() == known) return;
  context.roots.back().plain_numbers = true;
  input->law = law;
}

}  // namespace

void read_starts(Context& context, const SceneOptions& options) {
  if (options.starts.empty()) return;
  StartReader reader(context);
  for (const OptionWord& word : words_of(options.starts, context.report)) reader.read(word);
}

void read_laws(Context& context, const SceneOptions& options) {
  for (const OptionWord& word : words_of(options.laws, context.report)) read_law(context, word);
}

void read_values(Context& context, const Scene& scene, const SceneOptions& options) {
  for (const OptionWord& word : words_of(options.values, context.report)) {
    const std::optional<Assignment> given = assignment_of(context, word);
    if (!given) continue;
    const auto targets = named_parameters(context, given->name.text, given->name.span);
    if (targets.empty()) continue;
    const std::optional<FixedValue> value = constant_of(context, given->value);
    for (const std::uint32_t target : targets) {
      if (scene.specialisation.fixed.count(target) > 0) {
        context.report.add(Code::E606, given->name.span,
                           in_backticks(given->name.text) + " is fixed, so it is no parameter");
        break;
      }
      if (!value) break;
      check_value(context, target, value->number, given->value);
      context.model.parameters[target].value = value->number;
      context.model.parameters[target].form = value->form;
      context.model.parameters[target].is_computed = false;
    }
  }
}

}  // namespace elgen
