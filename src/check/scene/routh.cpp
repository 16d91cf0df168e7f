// Routh: `[routh] NAME = true`, or NAME = its momentum. A cyclic coordinate is taken out, and its
// momentum, which stays, becomes a parameter.
//
//     before    q = (r, phi)    L = 1/2*m*(dot(r)^2 + r^2*dot(phi)^2) - V
//     after     q = (r)         R = L - p_phi*dot(phi) at dot(phi) = p_phi/(m*r^2)
//
// Forces, inputs and D are judged here, by what they are made of. Whether L changes with the
// coordinate no reading of its text shows: find_momenta() asks the oracle. In the model that is
// left, the coordinate and its rate are 0.
#include <algorithm>
#include <utility>

#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"
#include "elgen/references.hpp"

namespace elgen {

namespace {

class CyclicReader {
 public:
  explicit CyclicReader(Context& context)
      : context_(context), model_(context.model), values_(context, Scope(context.sizes)) {}

  void read(const KeySyntax& key) {
    const std::optional<std::uint32_t> coordinate = coordinate_of(key);
    const bool is_given = key.value.kind != ValueKind::boolean;
    if (!coordinate || !(is_given || key.value.boolean)) return;
    Cyclic cyclic;
    cyclic.coordinate = *coordinate;
    cyclic.velocity = model_.coordinates[*coordinate].velocity;
    cyclic.span = key.key_span;
    if (is_given) {
      const Place place{"a momentum", place::parameters_only};
      cyclic.momentum = values_.scene_value(key.value, {place, unit_of(cyclic)});
    }
    found_.push_back(cyclic);
  }

  void finish(const EntrySyntax& entry) && {
    if (found_.empty()) return;
    std::ranges::sort(found_, {}, &Cyclic::velocity);
    std::size_t taken = found_.size();
    for (const Lock& lock : model_.locks) taken += lock.velocity_count();
    if (taken == model_.velocities.size()) {
      context_.report.add(Code::E635, entry.span,
                          "every coordinate is taken out, so nothing moves");
    }
    for (Cyclic& cyclic : found_) declare_momentum(cyclic);
    model_.cyclic = std::move(found_);
  }

 private:
  /// None after an error.
  std::optional<std::uint32_t> coordinate_of(const KeySyntax& key) {
    if (std::ranges::count(model_.rotations, key.key, &Rotation::name) > 0) {
      context_.report.add(Code::E635, key.key_span,
                          in_backticks(key.key) + " is a rotation, which no number stands for");
      return std::nullopt;
    }
    const auto found = std::ranges::find(model_.coordinates, key.key, &Coordinate::name);
    if (found == model_.coordinates.end() || found->rotation) {
      report_unknown_coordinate(context_, key);
      return std::nullopt;
    }
    const auto index = static_cast<std::uint32_t>(found - model_.coordinates.begin());
    const auto lock = std::ranges::find(model_.locks, index, &Lock::coordinate);
    if (lock == model_.locks.end()) return index;
    context_.report.add(
        {Code::E635, key.key_span, in_backticks(key.key) + " is locked", "", lock->span, "here"});
    return std::nullopt;
  }

  /// None: not checked.
  [[nodiscard]] std::optional<Unit> unit_of(const Cyclic& cyclic) const {
    const std::optional<Unit>& rate = model_.velocities[cyclic.velocity].unit;
    return rate ? std::optional(*find_unit("J") / *rate) : std::nullopt;
  }

  void declare_momentum(Cyclic& cyclic) {
    const Coordinate& coordinate = model_.coordinates[cyclic.coordinate];
    const std::string name = "p_" + coordinate.identifier;
    if (const DeclaredName* const taken = context_.symbols.find(name)) {
      context_.report.add({Code::E635, cyclic.span,
                           in_backticks(name) + " is taken, which the momentum of " +
                               in_backticks(coordinate.name) + " is called",
                           "", taken->span, "declared here"});
      return;
    }
    cyclic.parameter = static_cast<std::uint32_t>(model_.parameters.size());
    const NewName declared{name, std::nullopt, cyclic.span};
    if (!context_.symbols.declare(declared, SymbolKind::parameter, cyclic.parameter,
                                  context_.report)) {
      return;
    }
    Parameter& momentum = model_.parameters.emplace_back();
    momentum.name = momentum.identifier = name;
    momentum.array = static_cast<std::uint32_t>(model_.parameter_arrays.size());
    momentum.unit = unit_of(cyclic);
    momentum.is_computed = true;
    ParameterArray& array = model_.parameter_arrays.emplace_back();
    array.name = name;
    array.first = cyclic.parameter;
    if (momentum.unit) array.unit_text = to_string(*momentum.unit);
    if (!coordinate.latex.empty()) array.latex = "p_{" + coordinate.latex + "}";
    array.doc = "momentum of " + coordinate.name + ", which stays";
    array.span = cyclic.span;
    context_.bounds.resize(model_.parameter_arrays.size());
  }

  Context& context_;
  Model& model_;
  ValueReader values_;
  std::vector<Cyclic> found_ = {};
};

/// Finds the entries that act on a coordinate, and those for the rest of the system that contain
/// it.
class ObstacleSearch {
 public:
  ObstacleSearch(const Model& model, const Held& variable) : model_(model), variable_(variable) {}

  std::vector<CyclicObstacle> operator()() && {
    if (model_.energies.D) check_value({*model_.energies.D}, "D contains it");
    for (const Force& force : model_.forces) check_force(force);
    for (const Input& input : model_.inputs) {
      if (input.on == variable_.velocity) {
        add("the input " + in_backticks(input.name) + " acts on it", input.span);
      }
      if (input.law)
        check_value({*input.law}, "the law of " + in_backticks(input.name) + " contains it");
    }
    return std::move(found_);
  }

 private:
  using Expressions = std::vector<ExpressionId>;

  void add(const std::string& reason, const Span& at) { found_.push_back({reason, at}); }

  void check_value(const Expressions& values, const std::string& reason) {
    if (!is_reached(model_, values, variable_)) return;
    add(reason, model_.expressions[values.front()].span);
  }

  void check_force(const Force& force) {
    const std::string name =
        force.name.empty() ? "a force" : "the force " + in_backticks(force.name);
    if (force.on == variable_.velocity) add(name + " acts on it", force.span);
    if (force.on && force.on != variable_.velocity) check_value(force.value, name + " contains it");
    if (force.at) check_place(force, model_.points[*force.at].at, force.value, name);
    if (force.from) check_place(force, model_.points[*force.from].at, force.value, name);
    if (force.frame) check_place(force, model_.frames[*force.frame].spin, force.value, name);
    if (force.from_frame) {
      check_place(force, model_.frames[*force.from_frame].spin, force.reaction, name);
    }
  }

  /// The components of a force, and those of its place along which it has one.
  void check_place(const Force& force, const Vector3& place, const Expressions& components,
                   const std::string& name) {
    Expressions all = components;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const Expression& component = model_.expressions[components[i]];
      const bool is_absent =
          component.kind == ExpressionKind::number && cln::zerop(component.number);
      if (!is_absent) all.push_back(place[i]);
    }
    if (is_reached(model_, all, variable_))
      add(name + ", or where it acts, contains it", force.span);
  }

  const Model& model_;
  const Held& variable_;
  std::vector<CyclicObstacle> found_ = {};
};

}  // namespace

void read_routh(Context& context, const FileSyntax* scene) {
  const EntrySyntax* entry = find_entry(scene, "routh");
  if (entry == nullptr) return;
  CyclicReader reader(context);
  for (const KeySyntax& key : entry->keys) reader.read(key);
  std::move(reader).finish(*entry);
}

void check_routh(Context& context) {
  const Model& model = context.model;
  if (model.cyclic.empty()) return;
  if (!model.quadratic) {
    const Span& written = model.expressions[*model.energies.L].span;
    context.report.add({Code::E635, model.cyclic.front().span,
                        "`[routh]` needs a Lagrangian at most quadratic in the rates", "", written,
                        "L is given here"});
  }
  for (const Lock& lock : model.locks) {
    if (!lock.reaction) continue;
    context.report.add(Code::E635, lock.span,
                       "the reaction on " + in_backticks(model.coordinates[lock.coordinate].name) +
                           " is not known where `[routh]` takes coordinates out",
                       "ask for it in a scene without `[routh]`");
  }
  for (const Cyclic& cyclic : model.cyclic) {
    const std::string name = in_backticks(model.coordinates[cyclic.coordinate].name);
    for (const CyclicObstacle& obstacle : obstacles_of(model, cyclic)) {
      context.report.add({Code::E635, cyclic.span, name + " is not cyclic: " + obstacle.reason, "",
                          obstacle.span, "here"});
    }
  }
}

std::vector<CyclicObstacle> obstacles_of(const Model& model, const Held& variable) {
  return ObstacleSearch(model, variable)();
}

Model reduced(Model model) {
  if (model.cyclic.empty()) return model;
  const auto moving = std::make_shared<const Model>(std::move(model));
  Model standing = *moving;
  standing.cyclic.clear();
  for (const Cyclic& cyclic : moving->cyclic) {
    standing.locks.push_back({Held(cyclic), {no_expression}, cyclic.span});
  }
  Model result = locked(std::move(standing));
  result.unlocked = moving->unlocked ? moving->unlocked : moving;
  result.moving = moving;
  result.may_drift = true;
  return result;
}

}  // namespace elgen
