// Which velocities move something: a search from every energy down to its rates. Below a time
// derivative (and in the position of a mass) a coordinate counts as its rate does.
#include <algorithm>

#include "check/judge/mechanics.hpp"
#include "elgen/references.hpp"

namespace elgen {
namespace {

/// Explicit stack: a chain of points is as deep as it is long.
class RateSearch {
 public:
  explicit RateSearch(const Model& model)
      : model_(model),
        plain_(model.expressions.size()),
        below_derivative_(model.expressions.size()),
        moving_(model.velocities.size()) {}

  void visit(ExpressionId id, bool differentiated) {
    push(id, differentiated);
    while (!stack_.empty()) {
      const Visit next = stack_.back();
      stack_.pop_back();
      expand(next);
    }
  }

  std::vector<bool> take() { return std::move(moving_); }

 private:
  struct Visit {
    ExpressionId id;
    bool differentiated;
  };

  void push(ExpressionId id, bool differentiated) {
    std::vector<bool>& seen = differentiated ? below_derivative_ : plain_;
    if (!seen[id]) {
      seen[id] = true;
      stack_.push_back({id, differentiated});
    }
  }

  /// All velocities that move the coordinate.
  void mark(const Coordinate& coordinate) {
    const std::uint32_t count = coordinate.rotation ? axis_count : 1;
    std::fill_n(moving_.begin() + coordinate.velocity, count, true);
  }

  void expand(const Visit& visit) {
    const Expression& node = model_.expressions[visit.id];
    switch (node.kind) {
      case ExpressionKind::rate:
      case ExpressionKind::acceleration:  // E502 says what is wrong with that
        moving_[node.index] = true;
        return;
      case ExpressionKind::coordinate:
        if (visit.differentiated) {
          mark(model_.coordinates[node.index]);
        }
        return;
      default:
        break;
    }
    const bool below = visit.differentiated || node.kind == ExpressionKind::time_derivative;
    for (const ExpressionId reference : references(model_, visit.id)) push(reference, below);
  }

  const Model& model_;
  std::vector<bool> plain_;
  std::vector<bool> below_derivative_;
  std::vector<bool> moving_;
  std::vector<Visit> stack_ = {};
};

void visit_body(RateSearch& search, const Body& body) {
  if (body.mass) {
    for (const ExpressionId component : body.com) {
      search.visit(component, true);
    }
  }
  for (const ExpressionId component : body.spin) {
    search.visit(component, false);
  }
}

}  // namespace

std::vector<bool> moving_velocities(const Model& model) {
  RateSearch search(model);
  for (const auto& energy : {model.energies.T, model.energies.L}) {
    if (energy) {
      search.visit(*energy, false);
    }
  }
  for (const Point& point : model.points) {
    for (const ExpressionId component : point.at) {
      if (has_energy(point)) {
        search.visit(component, true);
      }
    }
  }
  for (const Body& body : model.bodies) {
    visit_body(search, body);
  }
  std::vector<bool> moving = search.take();
  for (const Coordinate& coordinate : model.coordinates) {
    if (coordinate.armature) {
      moving[coordinate.velocity] = true;
    }
  }
  return moving;
}

}  // namespace elgen
