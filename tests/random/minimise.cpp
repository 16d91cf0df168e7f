// Greedy reduction: every candidate is the system with one entry removed or one expression made
// simpler. The first candidate that still fails replaces the system.
#include "random/minimise.hpp"

#include <algorithm>
#include <cstddef>

namespace elgen::test::random {

namespace {

using Fails = std::function<bool(const System&)>;
/// Makes change k = 0, 1, ... of one kind. Returns false if this kind has at most k changes.
using Change = std::function<bool(System&, std::size_t)>;

template <class Entries>
bool erase_at(Entries& entries, std::size_t k) {
  if (k >= entries.size()) return false;
  entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(k));
  return true;
}

/// Removes a frame; its children move to its parent.
bool erase_frame(Model& model, std::size_t k) {
  if (k >= model.frames.size()) return false;
  const Frame gone = model.frames[k];
  const auto moved = [&](std::string& name) {
    if (name == gone.name) name = gone.parent;
  };
  for (Frame& frame : model.frames) moved(frame.parent);
  for (Body& body : model.bodies) moved(body.frame);
  for (Point& point : model.points) moved(point.frame);
  return erase_at(model.frames, k);
}

/// The optional lists of a model file: gravity, translate, com and inertia.
std::vector<std::vector<Expression>*> optional_lists(System& system) {
  Model& model = system.model;
  std::vector<std::vector<Expression>*> lists{&model.gravity};
  for (Frame& frame : model.frames) lists.push_back(&frame.translate);
  for (Body& body : model.bodies) lists.insert(lists.end(), {&body.com, &body.inertia});
  return lists;
}

/// Every expression of the files that may become simpler, null expressions included.
std::vector<Expression*> all_expressions(System& system) {
  Model& model = system.model;
  std::vector<Expression*> all{&model.T, &model.V, &model.D, &model.L};
  const auto add = [&](std::vector<Expression>& list) {
    for (Expression& expression : list) all.push_back(&expression);
  };
  for (auto& coordinate : model.coordinates) all.push_back(&coordinate.armature);
  for (auto& parameter : model.parameters) add(parameter.values);
  for (auto& definition : model.definitions) all.push_back(&definition.value);
  for (auto& function : model.prescribed) all.push_back(&function.value);
  for (auto& frame : model.frames) {
    add(frame.translate);
    add(frame.numbers);
    for (AxisTurn& turn : frame.turns) {
      add(turn.axis);
      all.push_back(&turn.angle);
    }
  }
  for (auto& point : model.points) {
    add(point.at);
    all.push_back(&point.mass);
  }
  for (auto& body : model.bodies) {
    all.push_back(&body.mass);
    for (auto* list : {&body.com, &body.inertia, &body.spin}) add(*list);
  }
  add(model.gravity);
  for (auto& force : model.forces) add(force.value);
  for (auto& output : model.outputs) add(output.value);
  for (auto& fixed : system.scene.fixed) all.push_back(&fixed.value);
  for (auto& lock : system.scene.locks) add(lock.value);
  return all;
}

/// Removes the k-th optional expression.
bool drop_expression(System& system, std::size_t k) {
  std::vector<Expression*> optional;
  Model& model = system.model;
  for (Expression* energy : {&model.T, &model.V, &model.D}) optional.push_back(energy);
  for (Coordinate& coordinate : model.coordinates) optional.push_back(&coordinate.armature);
  for (Point& point : model.points) optional.push_back(&point.mass);
  for (Body& body : model.bodies) optional.push_back(&body.mass);
  if (k >= optional.size()) return false;
  *optional[k] = nullptr;
  return true;
}

/// All simpler expressions: 0, 1, an operand, or the expression with one simpler operand.
std::vector<Expression> simplifications(const Expression& expression) {
  if (!expression || expression->kind == NodeKind::sum) return {};
  const Node& node = *expression;
  std::vector<Expression> results;
  const bool is_digit = node.kind == NodeKind::number && node.text.size() == 1;
  if (!is_digit) results.push_back(number(0));
  if (!is_digit) results.push_back(number(1));
  const bool keeps_operands = node.kind != NodeKind::rate;
  for (const Expression& operand : node.operands) {
    if (keeps_operands) results.push_back(operand);
  }
  for (std::size_t i = 0; i < node.operands.size() && keeps_operands; ++i) {
    for (const Expression& part : simplifications(node.operands[i])) {
      Node changed = node;
      changed.operands[i] = part;
      results.push_back(made(std::move(changed)));
    }
  }
  return results;
}

std::vector<Change> entry_changes() {
  return {
      [](System& s, std::size_t k) { return erase_at(s.model.outputs, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.forces, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.inputs, k); },
      [](System& s, std::size_t k) { return erase_at(s.scene.locks, k); },
      [](System& s, std::size_t k) { return erase_at(s.scene.fixed, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.bodies, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.points, k); },
      [](System& s, std::size_t k) { return erase_frame(s.model, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.coordinates, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.prescribed, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.definitions, k); },
      [](System& s, std::size_t k) { return erase_at(s.model.parameters, k); },
      [](System& s, std::size_t k) {
        return k < s.model.frames.size() && erase_at(s.model.frames[k].turns, 0);
      },
      [](System& s, std::size_t k) {
        if (k >= s.model.frames.size()) return false;
        s.model.frames[k].turn = Turn::none;
        return true;
      },
      drop_expression,
      [](System& s, std::size_t k) {
        const auto lists = optional_lists(s);
        if (k < lists.size()) lists[k]->clear();
        return k < lists.size();
      },
  };
}

std::vector<Change> scene_changes() {
  const auto once = [](const std::function<void(Scene&)>& change) {
    return [change](System& system, std::size_t k) {
      if (k == 0) change(system.scene);
      return k == 0;
    };
  };
  return {once([](Scene& s) { s = Scene{}; }),
          once([](Scene& s) { s.fixes_all = false; }),
          once([](Scene& s) { s.order = 0; }),
          once([](Scene& s) { s.order = std::min(s.order, 1); }),
          once([](Scene& s) { s.is_c99 = false; }),
          once([](Scene& s) { s.has_eigen = false; }),
          once([](Scene& s) { s.is_float = false; }),
          once([](Scene& s) { s.is_column_major = false; }),
          once([](Scene& s) { s.form.clear(); }),
          once([](Scene& s) { s.has_lone_sines = false; })};
}

std::string whole_text(const System& system) {
  return text_of(system.model) +
         (system.scene.is_present ? text_of(system.scene, system.model) : "");
}

/// Makes each `change` that alters the text of `system`, if the changed system still fails. Returns
/// true if `system` changed.
bool reduce_by(System& system, const Change& change, const Fails& fails) {
  bool reduced = false;
  for (std::size_t k = 0;;) {
    System candidate = system;
    if (!change(candidate, k)) return reduced;
    if (whole_text(candidate) != whole_text(system) && fails(candidate)) {
      system = candidate;
      reduced = true;
    } else {
      ++k;
    }
  }
}

bool reduce_expressions(System& system, const Fails& fails) {
  bool reduced = false;
  for (std::size_t slot = 0; slot < all_expressions(system).size(); ++slot) {
    bool again = true;
    while (again) {
      again = false;
      for (const Expression& part : simplifications(*all_expressions(system)[slot])) {
        System candidate = system;
        *all_expressions(candidate)[slot] = part;
        if (!fails(candidate)) continue;
        system = candidate;
        reduced = again = true;
        break;
      }
    }
  }
  return reduced;
}

}  // namespace

System minimised(System system, const Fails& fails) {
  for (bool reduced = true; reduced;) {
    reduced = false;
    for (const auto& changes : {scene_changes(), entry_changes()}) {
      for (const Change& change : changes) reduced = reduce_by(system, change, fails) || reduced;
    }
    reduced = reduce_expressions(system, fails) || reduced;
  }
  return system;
}

}  // namespace elgen::test::random
