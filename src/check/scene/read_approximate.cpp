// [approximate]: an order, a point, and which coordinates are small.
//
//     order = 3                      ->   order 3
//     about = { q1 = "pi/2", q2 = 0 }     q1 and q2 are pi/2 and 0 at the point
//     small = ["q2"]                      q2 is small; q1 is any angle, and inputs are any forces
#include <cln/integer.h>

#include <algorithm>

#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/names/requests.hpp"
#include "check/scene/scene.hpp"

namespace elgen {
namespace {

constexpr Place at_point{"a value of `about`", place::parameters_only};

/// "q" and "q[2]" both name q[2].
bool is_named(const std::string& full_name, std::string_view name) {
  return full_name == name || full_name.substr(0, full_name.find('[')) == name;
}

template <class Entries>
std::vector<std::uint32_t> named(const Entries& entries, std::string_view name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    if (is_named(entries[i].name, name)) found.push_back(i);
  }
  return found;
}

class ApproximationReader {
 public:
  ApproximationReader(Context& context, const EntrySyntax& entry)
      : context_(context), model_(context.model), entry_(entry), errors_(context.report.errors()) {
    result_.coordinates.resize(model_.coordinates.size());
    result_.inputs.resize(model_.inputs.size());
    result_.small.resize(model_.coordinates.size(), false);
  }

  void read() {
    const KeySyntax& about = *entry_.find("about");
    result_.span = about.key_span;
    read_order(entry_.find("order")->value);
    for (const KeySyntax& key : about.value.entries) read_value(key);
    const KeySyntax* small = entry_.find("small");
    read_small(small);
    if (context_.report.errors() == errors_) check_small(small);
    check_forces();
    check_reactions();
    result_.small_inputs = all_free_are_small();
    model_.approximation = std::move(result_);
  }

 private:
  void read_order(const ValueSyntax& value) {
    const cln::cl_RA& order = value.expression.value;
    if (order < 1 || order > highest_order) {
      context_.report.add(Code::E614, value.span,
                          "order " + in_backticks(value.span) + " is not one of 1 to " +
                              std::to_string(highest_order));
      return;
    }
    result_.order = cln::cl_I_to_uint(cln::floor1(order));
  }

  void read_value(const KeySyntax& key) {
    const std::vector<std::uint32_t> coordinates = named(model_.coordinates, key.key);
    const std::vector<std::uint32_t> inputs = named(model_.inputs, key.key);
    if (!is_expandable(key.key, key.key_span, coordinates.empty() && inputs.empty())) return;
    RootRequest request{at_point};
    request.unit = coordinates.empty() ? model_.inputs[inputs.front()].unit
                                       : model_.coordinates[coordinates.front()].unit;
    const ExpressionId value =
        ValueReader(context_, Scope(context_.sizes)).scene_value(key.value, request);
    for (const std::uint32_t i : coordinates) {
      if (is_locked(i)) {
        context_.report.add(Code::E614, key.key_span,
                            in_backticks(model_.coordinates[i].name) + " is locked");
      }
      result_.coordinates[i] = value;
    }
    for (const std::uint32_t i : inputs) result_.inputs[i] = value;
  }

  /// Neither unknown nor of a rotation.
  bool is_expandable(const std::string& name, const Span& span, bool is_unknown) {
    const DeclaredName* symbol = context_.symbols.find(name.substr(0, name.find('[')));
    if (symbol != nullptr && (symbol->kind == SymbolKind::rotation ||
                              symbol->kind == SymbolKind::quaternion_component)) {
      context_.report.add(Code::E614, span,
                          in_backticks(name) + " is of a rotation, which is never small",
                          "leave it out: the equations stay exact in it");
      return false;
    }
    if (!is_unknown) return true;
    const auto names = context_.symbols.names({SymbolKind::coordinate, SymbolKind::input});
    context_.report.add(Code::E614, span, in_backticks(name) + " is no coordinate or input",
                        context_.symbols.suggest(name, names));
    return false;
  }

  void read_small(const KeySyntax* small) {
    if (small == nullptr) {
      for (std::size_t i = 0; i < result_.small.size(); ++i) {
        result_.small[i] = result_.coordinates[i].has_value();
      }
    } else {
      for (const ValueSyntax& item : small->value.items) read_small_coordinate(item);
    }
  }

  void check_small(const KeySyntax* small) {
    const auto& flags = result_.small;
    if (std::find(flags.begin(), flags.end(), true) != flags.end()) return;
    context_.report.add(Code::E614, small == nullptr ? result_.span : small->key_span,
                        "no coordinate is small", "`about` gives the coordinates that are");
  }

  void read_small_coordinate(const ValueSyntax& item) {
    const std::vector<std::uint32_t> coordinates = named(model_.coordinates, item.text);
    if (!is_expandable(item.text, item.span, coordinates.empty())) return;
    for (const std::uint32_t i : coordinates) {
      result_.small[i] = true;
      if (!result_.coordinates[i]) {
        context_.report.add(Code::E614, item.span,
                            in_backticks(model_.coordinates[i].name) + " is small, but about what?",
                            "give its value in `about`");
      }
    }
  }

  [[nodiscard]] bool is_locked(std::uint32_t coordinate) const {
    return std::any_of(model_.locks.begin(), model_.locks.end(), [&](const Lock& lock) {
      return lock.coordinate <= coordinate && coordinate < lock.coordinate + lock.values.size();
    });
  }

  [[nodiscard]] bool all_free_are_small() const {
    for (std::uint32_t i = 0; i < result_.small.size(); ++i) {
      if (!result_.small[i] && !is_locked(i)) return false;
    }
    return true;
  }

  void check_reactions() {
    for (const Lock& lock : model_.locks) {
      if (!lock.reaction) continue;
      context_.report.add(Code::E614, lock.span,
                          "the reaction on " + in_backticks(lock.span) + " is not expanded",
                          "ask for it in a scene without `[approximate]`");
    }
  }

  void check_forces() {
    const Expression* kink = find_kink(model_);
    if (kink == nullptr) return;
    context_.report.add({Code::E614, entry_.span,
                         "`abs`, `sign`, `min` and `max` in a force have no expansion",
                         "a smooth stand-in is tanh(x/width)", kink->span, "one is here"});
  }

  Context& context_;
  Model& model_;
  const EntrySyntax& entry_;
  std::size_t errors_;  ///< before this table was read
  Approximation result_ = {};
};

}  // namespace

void read_approximation(Context& context, const FileSyntax* scene) {
  const EntrySyntax* found = find_entry(scene, "approximate");
  if (found != nullptr) ApproximationReader(context, *found).read();
}

}  // namespace elgen
