// [approximate]: an order, an expansion point, and the small coordinates.
//
//     order = 3                      ->   order 3
//     about = { q1 = "pi/2", q2 = 0 }     q1 and q2 are pi/2 and 0 at the point
//     small = ["q2"]                      q2 is small; q1 and the inputs are arbitrary
//
// `about = "hanging"` uses the values of an equilibrium of the model.
#include <cln/integer.h>

#include <algorithm>

#include "base/reason.hpp"
#include "check/entries/stated_point.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"
#include "check/scene/scene.hpp"
#include "model/requests.hpp"

namespace elgen {
namespace {

constexpr PointTable about_table{
    {"a value of `about`", place::parameters_only}, true, true, Reason::not_a_coordinate};
constexpr PointTable small_table{{}, true, false, Reason::not_a_coordinate};

class ApproximationReader {
 public:
  ApproximationReader(Context& context, const EntrySyntax& entry)
      : context_(context),
        model_(context.model),
        entry_(entry),
        errors_(context.report.error_count()) {
    result_.coordinates.resize(model_.coordinates.size());
    result_.inputs.resize(model_.inputs.size());
    result_.small.resize(model_.coordinates.size(), false);
  }

  void read() {
    const KeySyntax& about = *entry_.find("about");
    result_.span = about.key_span;
    read_order(entry_.find("order")->value);
    read_point(about.value);
    const KeySyntax* small = entry_.find("small");
    read_small_coordinates(small);
    if (context_.report.error_count() == errors_) check_small(small);
    check_forces();
    check_functions();
    check_reactions();
    result_.has_small_inputs = has_only_small_coordinates();
    model_.approximation = std::move(result_);
  }

 private:
  void read_order(const ValueSyntax& value) {
    const cln::cl_RA& order = value.expression.value;
    if (order < 1 || order > max_expansion_order) {
      context_.report.add(Reason::bad_order, value.span,
                          "order " + in_backticks(value.span) + " is not one of 1 to " +
                              std::to_string(max_expansion_order));
      return;
    }
    result_.order = cln::cl_I_to_uint(cln::floor1(order));
  }

  /// Reads the values in `about`, or copies the equilibrium that `about` names.
  void read_point(const ValueSyntax& about) {
    if (about.kind == ValueKind::text) return copy_equilibrium(about);
    ValueReader values(context_);
    for (const KeySyntax& key : about.entries) {
      const NamedVariables found = read_point_value(values, about_table, key, result_);
      for (const std::uint32_t i : found.coordinates) {
        const std::string name = quote_text(model_.coordinates[i].name);
        if (is_locked(i))
          context_.report.add(Reason::locked_coordinate, key.key_span, name + " is locked");
        if (!is_cyclic(i)) continue;
        context_.report.add(Reason::expanded_cyclic, key.key_span,
                            name + " is removed by `[routh]`, so nothing is expanded in it");
      }
    }
  }

  /// Copies an equilibrium, except the values of locked coordinates (set by the lock) and of cyclic
  /// coordinates (arbitrary).
  void copy_equilibrium(const ValueSyntax& name) {
    const auto found = std::ranges::find(model_.equilibria, name.text, &Equilibrium::name);
    if (found == model_.equilibria.end()) {
      const SymbolTable& known = context_.equilibria;
      context_.report.add(Reason::no_such_equilibrium, name.span,
                          "the model has no equilibrium " + quote_text(name.text),
                          known.suggest(name.text, known.names()));
      return;
    }
    static_cast<OperatingPoint&>(result_) = *found;
    for (std::uint32_t i = 0; i < result_.coordinates.size(); ++i) {
      if (is_locked(i) || is_cyclic(i)) result_.coordinates[i].reset();
    }
  }

  void read_small_coordinates(const KeySyntax* small) {
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
    context_.report.add(Reason::no_small_coordinate,
                        small == nullptr ? result_.span : small->key_span, "no coordinate is small",
                        "`about` gives the small coordinates");
  }

  void read_small_coordinate(const ValueSyntax& item) {
    const NamedVariables found = find_variables(context_, small_table, item.text, item.span);
    for (const std::uint32_t i : found.coordinates) {
      result_.small[i] = true;
      if (!result_.coordinates[i]) {
        context_.report.add(
            Reason::no_small_coordinate, item.span,
            quote_text(model_.coordinates[i].name) + " is small, but `about` gives no value for it",
            "add its value to `about`");
      }
    }
  }

  [[nodiscard]] bool is_locked(std::uint32_t coordinate) const {
    return std::ranges::any_of(model_.reduction.locks, [&](const LockedCoordinate& lock) {
      return lock.has_coordinate(coordinate);
    });
  }

  [[nodiscard]] bool is_cyclic(std::uint32_t coordinate) const {
    return std::ranges::count(model_.reduction.cyclic, coordinate, &CyclicCoordinate::coordinate) >
           0;
  }

  [[nodiscard]] bool has_only_small_coordinates() const {
    for (std::uint32_t i = 0; i < result_.small.size(); ++i) {
      if (!result_.small[i] && !is_locked(i) && !is_cyclic(i)) return false;
    }
    return true;
  }

  void check_reactions() {
    for (const LockedCoordinate& lock : model_.reduction.locks) {
      if (!lock.has_reaction) continue;
      context_.report.add(Reason::approximated_reaction, lock.span,
                          "the reaction on " + in_backticks(lock.span) + " is not expanded",
                          "request it in a scene without `[approximate]`");
    }
  }

  void check_forces() {
    const Expression* kink = find_kink(model_);
    if (kink == nullptr) return;
    context_.report.add({Reason::kinked_force, entry_.span,
                         "`abs`, `sign`, `min` and `max` in a force have no expansion",
                         "a smooth approximation is tanh(x/width)", kink->span, "a kink is here"});
  }

  void check_functions() {
    for (const OpenFunction& function : model_.functions) {
      context_.report.add({Code::E633, entry_.span,
                           quote_text(function.name) + " is left open, so it has no expansion",
                           "give it an expression in `[functions]`", function.span,
                           "left open here"});
    }
  }

  Context& context_;
  Model& model_;
  const EntrySyntax& entry_;
  std::size_t errors_;  ///< number of errors before this table
  Approximation result_ = {};
};

}  // namespace

void read_approximation(Context& context, const FileSyntax* scene) {
  const EntrySyntax* found = find_entry(scene, "approximate");
  if (found != nullptr) ApproximationReader(context, *found).read();
}

}  // namespace elgen
