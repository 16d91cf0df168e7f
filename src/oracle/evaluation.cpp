// Evaluates operands first, without recursion. Each value is memoised to the highest time order
// that a caller requested.
#include "oracle/evaluation.hpp"

#include <algorithm>
#include <utility>

#include "elgen/opcodes.hpp"
#include "elgen/references.hpp"
#include "oracle/rotations.hpp"

namespace elgen::oracle {
namespace {

/// Lower generators belong to the caller's directions of differentiation.
constexpr unsigned first_time_generator = 8;

Generators time_generator(unsigned k) { return generator(first_time_generator + k); }

/// The time generators after the first `order`.
Generators later_time_generators(unsigned order) {
  return all_generators & ~(time_generator(order) - 1);
}

/// s = e_1 + ... + e_order
Jet elapsed_time(unsigned order) {
  Jet s;
  for (unsigned k = 0; k < order; ++k) s = s + Jet(time_generator(k), 1);
  return s;
}

/// True if two motions at the same parameters are equal; energies depend on leaves of states only.
bool is_same_motion(const Motion& x, const Motion& y) {
  bool result = true;
  const auto compare = [&](Opcode kind, std::uint32_t, const Jet& of_x, const Jet& of_y) {
    result = result && (!is_in_state(kind) || is_same(of_x, of_y));
  };
  for_each_leaf(compare, x, y);
  return result;
}

}  // namespace

Evaluation::Evaluation(const Model& model, const Motion& motion,
                       std::shared_ptr<JetFunctions> functions)
    : model_(model),
      motion_(motion),
      functions_(std::move(functions)),
      memoised_values_(model.expressions.size()) {}

Jet Evaluation::value(ExpressionId expression) { return evaluate(expression, 0); }

Jet Evaluation::rate(ExpressionId expression) {
  return evaluate(expression, 1).tangent(time_generator(0));
}

Jet Evaluation::second_rate(ExpressionId expression) {
  return evaluate(expression, 2).tangent(time_generator(0)).tangent(time_generator(1));
}

bool Evaluation::is_known(ExpressionId id, unsigned time_order) const {
  return memoised_values_[id] && memoised_values_[id]->time_order >= time_order;
}

/// The value of `root` with the first `time_order` time generators. Uses no recursion, because
/// chains of names may have thousands of links.
Jet Evaluation::evaluate(ExpressionId root, unsigned time_order) {
  struct Wanted {
    ExpressionId id = 0;
    unsigned time_order = 0;
    bool has_operands = false;
  };
  std::vector<Wanted> stack{{root, time_order}};
  while (!stack.empty()) {
    const auto [id, order, has_operands] = stack.back();
    const Expression& e = model_.expressions[id];
    if (has_operands) {
      memoised_values_[id] = {evaluate_operation(e, order), order};
      memoised_values_[id]->value.shorten();
    }
    if (is_known(id, order)) {
      stack.pop_back();
      continue;
    }
    stack.back().has_operands = true;
    const unsigned needed = order + (e.kind == ExpressionKind::time_derivative ? 1U : 0U);
    for (const ExpressionId reference : references(model_, id)) {
      if (!is_known(reference, needed)) stack.push_back({reference, needed});
    }
  }
  return memoised_value(root, time_order);
}

/// The memoised value, without time generators beyond `time_order`.
Jet Evaluation::memoised_value(ExpressionId id, unsigned time_order) const {
  const auto& [value, known_order] = *memoised_values_[id];
  return known_order == time_order ? value : value.without(later_time_generators(time_order));
}

Jet Evaluation::evaluate_operation(const Expression& e, unsigned time_order) {
  switch (e.kind) {
    case ExpressionKind::named:
      return memoised_value(*value_of_name(model_, e), time_order);
    case ExpressionKind::negate:
      return -memoised_value(e.operands[0], time_order);
    case ExpressionKind::add:
    case ExpressionKind::multiply:
      return sum_or_product(e, time_order);
    case ExpressionKind::divide:
      return memoised_value(e.operands[0], time_order) / memoised_value(e.operands[1], time_order);
    case ExpressionKind::power:
      return functions_->power(memoised_value(e.operands[0], time_order), e.number);
    case ExpressionKind::function:
      return function_value(e, time_order);
    case ExpressionKind::time_derivative:
      return memoised_value(e.operands[0], time_order + 1).tangent(time_generator(time_order));
    default:
      return is_leaf(e, Opcode::open_value) ? open_value(e, time_order) : leaf_value(e, time_order);
  }
}

/// An open function by Taylor's formula to second order. OutsideDomain if the state lacks a
/// derivative that would contribute.
Jet Evaluation::open_value(const Expression& e, unsigned time_order) const {
  const auto known = [this](std::uint32_t value, std::uint32_t argument) {
    const auto derivative = find_open_derivative(model_, value, argument);
    if (!derivative) throw OutsideDomain("a third derivative of an open function");
    return *derivative;
  };
  std::vector<Jet> displacements;
  for (const ExpressionId argument : e.operands) {
    displacements.push_back(memoised_value(argument, time_order).nilpotent_part());
  }
  const auto is_still = [](const Jet& x) { return x.is_zero(); };
  Jet result = motion_.f[e.index];
  for (std::uint32_t i = 0; i < displacements.size(); ++i) {
    if (is_still(displacements[i])) continue;
    const std::uint32_t slope = known(e.index, i);
    result = result + motion_.f[slope] * displacements[i];
    for (std::uint32_t j = 0; j <= i; ++j) {
      const Jet both = displacements[i] * displacements[j];
      if (is_still(both)) continue;
      const std::uint32_t curvature = known(slope, j);
      const Jet share = i == j ? Jet(cln::cl_RA(1) / 2) : Jet(1);
      result = result + motion_.f[curvature] * both * share;
      for (std::uint32_t k = 0; k <= j; ++k) {
        if (!is_still(both * displacements[k])) (void)known(curvature, k);
      }
    }
  }
  return result;
}

Jet Evaluation::leaf_value(const Expression& e, unsigned time_order) const {
  if (e.kind == ExpressionKind::number) return Jet(e.number);
  if (e.kind == ExpressionKind::pi) return Jet(real_pi());
  const Jet s = elapsed_time(time_order);
  if (e.leaf == Opcode::time) return motion_.t + s;
  if (e.leaf == Opcode::coordinate) return coordinate_at(e.index, s);
  if (e.leaf == Opcode::velocity) return motion_.v[e.index] + motion_.a[e.index] * s;
  return leaf_of(motion_, e.leaf, e.index);
}

/// q + dq/dt s + 1/2 d2q/dt2 s^2
Jet Evaluation::coordinate_at(std::uint32_t index, const Jet& s) const {
  const Coordinate& coordinate = model_.coordinates[index];
  const Jet half_square = s * s * Jet(cln::cl_RA(1) / 2);
  if (!coordinate.rotation) {
    const std::uint32_t rate = coordinate.velocity;
    return motion_.q[index] + motion_.v[rate] * s + motion_.a[rate] * half_square;
  }
  if (s.support() == 0) return motion_.q[index];
  const Rotation& rotation = model_.rotations[*coordinate.rotation];
  const std::uint32_t component = index - rotation.first_coordinate;
  const Quaternion e = quaternion_of(rotation, motion_.q);
  const Spin w = spin_of(rotation, motion_.v);
  const Quaternion rate = quaternion_derivative(e, w);
  if (half_square.terms().empty()) return e[component] + rate[component] * s;
  const Quaternion turning = quaternion_derivative(rate, w);
  const Quaternion accelerating = quaternion_derivative(e, spin_of(rotation, motion_.a));
  return e[component] + rate[component] * s +
         (turning[component] + accelerating[component]) * half_square;
}

Jet Evaluation::sum_or_product(const Expression& e, unsigned time_order) const {
  Jet result = memoised_value(e.operands.front(), time_order);
  for (std::size_t i = 1; i < e.operands.size(); ++i) {
    const Jet next = memoised_value(e.operands[i], time_order);
    result = e.kind == ExpressionKind::add ? result + next : result * next;
  }
  return result;
}

Jet Evaluation::function_value(const Expression& e, unsigned time_order) {
  const Jet x = memoised_value(e.operands[0], time_order);
  const Jet y = e.operands.size() > 1 ? memoised_value(e.operands[1], time_order) : Jet();
  return functions_->value(e.function, x, y);
}

RecentEvaluations::Entry::Entry(const Model& model, Motion of,
                                const std::shared_ptr<JetFunctions>& functions)
    : motion(std::move(of)), evaluation(model, motion, functions) {}

RecentEvaluations::RecentEvaluations(const Model& model, std::size_t count)
    : model_(model), count_(count) {}

Evaluation& RecentEvaluations::at(const Motion& motion) {
  const auto known = std::ranges::find_if(
      entries_, [&](const Entry& entry) { return is_same_motion(entry.motion, motion); });
  if (known != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, known);
    return known->evaluation;
  }
  if (entries_.size() == count_) entries_.pop_back();
  return entries_.emplace_front(model_, motion, functions_).evaluation;
}

}  // namespace elgen::oracle
