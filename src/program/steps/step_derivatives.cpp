// step_jacobian_columns: one forward pass over the instructions of a step for each direction of the
// state and the inputs. Every pass has the same code, so dense passes become the repetitions of the
// function.
//
//     s = a b    ->    ds = da b + a db
//
// Directions of a rotation are rotation vectors in body axes, before and after the step:
//
//     dq = N(q) dx,    dx' = 4 N(q')^T dq'
//
// stage_jacobian_columns treats the accelerations of all stages as variables (open accelerations).
// A tangent is linear in the direction and in the tangents da_l of the accelerations. One pass over
// the step for each direction gives its part without da; one pass for each entry of da_l gives the
// factor of this entry. The derivatives of forces (elgen/compose.hpp) give a force at each stage:
//
//     f_k = f_k0 + sum_(l<k) F_kl da_l,   M_k da_k = f_k,   d(x, v)(t + h) = e_0 + sum_l E_l da_l
//
// These equations are the same instructions for every direction, and become the repetitions of the
// function. M^-1 multiplies only forces, not the matrices F_kl.
#include <fmt/format.h>

#include <numeric>
#include <optional>
#include <utility>

#include "base/function_slopes.hpp"
#include "elgen/compose.hpp"
#include "program/evaluate/subject.hpp"
#include "program/steps/methods.hpp"

namespace elgen {
namespace {

/// A derivative from the table of functions, as a tree over values of a composition. Its
/// instructions are added later, from left to right, because compilers evaluate operands in
/// different orders.
struct DerivativeTree {
  std::uint32_t place = 0;  ///< of a value, if there are no operands
  Opcode opcode = Opcode::constant;
  FunctionId function = FunctionId::sin;
  std::vector<DerivativeTree> operands = {};
  std::optional<int> number = {};

  [[nodiscard]] std::uint32_t emit(Composition& compose) const {
    if (number) return compose.add_number(*number);
    if (operands.empty()) return place;
    const std::uint32_t x = operands.front().emit(compose);
    const std::uint32_t y = operands.size() > 1 ? operands.back().emit(compose) : 0;
    return opcode == Opcode::call ? compose.add_call(function, x, y) : compose.add(opcode, x, y);
  }

  static DerivativeTree make_operation(Opcode opcode, std::vector<DerivativeTree> operands) {
    return {.opcode = opcode, .operands = std::move(operands)};
  }
  friend DerivativeTree operator+(const DerivativeTree& x, const DerivativeTree& y) {
    return make_operation(Opcode::add, {x, y});
  }
  friend DerivativeTree operator-(const DerivativeTree& x, const DerivativeTree& y) {
    return make_operation(Opcode::subtract, {x, y});
  }
  friend DerivativeTree operator*(const DerivativeTree& x, const DerivativeTree& y) {
    return make_operation(Opcode::multiply, {x, y});
  }
  friend DerivativeTree operator/(const DerivativeTree& x, const DerivativeTree& y) {
    return make_operation(Opcode::divide, {x, y});
  }
  friend DerivativeTree operator-(const DerivativeTree& x) {
    return DerivativeTree{.number = 0} - x;
  }
  friend DerivativeTree operator*(const DerivativeTree& x, int factor) {
    return x * DerivativeTree{.number = factor};
  }
};

DerivativeTree sqrt(const DerivativeTree& x) {
  return DerivativeTree::make_operation(Opcode::square_root, {x});
}

DerivativeTree called(FunctionId function, const DerivativeTree& x, const DerivativeTree& y) {
  return {.opcode = Opcode::call, .function = function, .operands = {x, y}};
}

/// The tangents of the leaves of a step along one direction: q, v, u and, if accelerations are
/// open, a. All others do not move.
using LeafTangents = LeafValues<std::uint32_t>;

/// The tangents of all instructions of a step along a direction.
class TangentPass {
 public:
  /// `places`: the values of the instructions in the composition.
  TangentPass(Composition& compose, const Function& step, const InstructionIndices& places,
              const LeafTangents& seeds)
      : compose_(compose), zero_(compose.add_number(0)) {
    for (std::size_t at = 0; at < step.instructions.size(); ++at) {
      const Instruction& i = step.instructions[at];
      tangents_.push_back(operand_count(i) == 0
                              ? leaf_tangent(i, seeds)
                              : compute_tangent(i, renumber_operands(i, places), places[at]));
    }
  }

  [[nodiscard]] InstructionIndices tangents_of(const InstructionIndices& values) const {
    InstructionIndices result;
    for (const std::uint32_t value : values) result.push_back(tangents_[value]);
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t add_instruction(Opcode opcode, std::uint32_t a, std::uint32_t b = 0) {
    return compose_.add(opcode, a, b);
  }

  /// The tangent of the value `at` of the instruction `i`, whose operands are the instructions of
  /// the step in `own`.
  std::uint32_t compute_tangent(const Instruction& own, const Instruction& i, std::uint32_t at) {
    const std::uint32_t da = tangents_[own.a];
    const std::uint32_t db = operand_count(i) > 1 ? tangents_[own.b] : zero_;
    if (da == zero_ && db == zero_) return zero_;
    switch (i.opcode) {
      case Opcode::negate:
        return add_instruction(i.opcode, da);
      case Opcode::add:
      case Opcode::subtract:
        return add_instruction(i.opcode, da, db);
      case Opcode::multiply: {
        const std::uint32_t left = add_instruction(Opcode::multiply, da, i.b);
        return add_instruction(Opcode::add, left, add_instruction(Opcode::multiply, db, i.a));
      }
      case Opcode::divide: {
        const std::uint32_t shrinking = add_instruction(Opcode::multiply, at, db);
        return add_instruction(Opcode::divide, add_instruction(Opcode::subtract, da, shrinking),
                               i.b);
      }
      case Opcode::square_root:
        return add_instruction(Opcode::divide, da, add_instruction(Opcode::add, at, at));
      case Opcode::call:
        return call_tangent(i, at, da, db);
      case Opcode::constant:
#define ELGEN_LEAVES(kind, ...) case Opcode::kind:
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
        break;
    }
    return zero_;
  }

  [[nodiscard]] std::uint32_t leaf_tangent(const Instruction& i, const LeafTangents& seeds) const {
    if (!is_leaf(i.opcode)) return zero_;
    const InstructionIndices* const list = leaf_list(seeds, i.opcode);
    return list != nullptr && i.a < list->size() ? (*list)[i.a] : zero_;
  }

  [[nodiscard]] std::uint32_t call_tangent(const Instruction& i, std::uint32_t at, std::uint32_t da,
                                           std::uint32_t db) {
    const DerivativeTree y{.place = operand_count(i) > 1 ? i.b : i.a};
    const auto slopes = function_slopes(i.function, DerivativeTree{.place = i.a}, y,
                                        DerivativeTree{.place = at}, DerivativeTree{.number = 1});
    std::uint32_t sum = zero_;
    for (const auto& [slope, tangent] : {std::pair(slopes[0], da), std::pair(slopes[1], db)}) {
      if (tangent == zero_) continue;
      sum = add_instruction(Opcode::add, sum,
                            add_instruction(Opcode::multiply, slope.emit(compose_), tangent));
    }
    return sum;
  }

  Composition& compose_;
  std::uint32_t zero_;
  InstructionIndices tangents_ = {};
};

class StepDifferentiator {
 public:
  StepDifferentiator(const Model& model, const Program& calls, const Function& step,
                     Composition& compose)
      : model_(model), calls_(calls), step_(step), compose_(compose) {
    places_.resize(step.instructions.size());
    std::iota(places_.begin(), places_.end(), 0U);
  }

  /// The columns of A, then the columns of B.
  [[nodiscard]] std::vector<InstructionIndices> compose_columns() {
    const std::vector<InstructionIndices> moves = coordinate_directions(
        compose_, model_, calls_, compose_.add_leaves(Opcode::coordinate, coordinate_count()));
    const std::vector<InstructionIndices> moves_after =
        coordinate_directions(compose_, model_, calls_, step_.fields[0].entries);
    std::vector<InstructionIndices> directions = moves;
    for (InstructionIndices& direction : directions)
      direction.resize(coordinate_count() + velocity_count() + input_count(), zero());
    for (std::size_t j = 0; j < velocity_count() + input_count(); ++j) {
      InstructionIndices& direction =
          directions.emplace_back(coordinate_count() + velocity_count() + input_count(), zero());
      direction[coordinate_count() + j] = compose_.add_number(1);
    }
    return compose_.repeat_for_columns(
        directions, [&](Composition& compose, const InstructionIndices& direction) {
          return tangent(compose, moves_after, direction);
        });
  }

 private:
  [[nodiscard]] std::size_t velocity_count() const { return model_.velocities.size(); }
  [[nodiscard]] std::size_t coordinate_count() const { return model_.coordinates.size(); }
  [[nodiscard]] std::size_t input_count() const { return model_.inputs.size(); }
  [[nodiscard]] std::uint32_t zero() const { return compose_.add_number(0); }

  /// dx', then dv', along one direction of q, v, u.
  [[nodiscard]] InstructionIndices tangent(Composition& compose,
                                           const std::vector<InstructionIndices>& moves_after,
                                           const InstructionIndices& direction) const {
    const auto part = [&](std::size_t first, std::size_t count) {
      const auto begin = direction.begin() + static_cast<std::ptrdiff_t>(first);
      return InstructionIndices(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    LeafTangents seeds;
    seeds.q = part(0, coordinate_count());
    seeds.v = part(coordinate_count(), velocity_count());
    seeds.u = part(coordinate_count() + velocity_count(), input_count());
    const TangentPass tangents(compose, step_, places_, seeds);
    InstructionIndices result = velocity_tangents(compose, model_, moves_after,
                                                  tangents.tangents_of(step_.fields[0].entries));
    const InstructionIndices of_v = tangents.tangents_of(step_.fields[1].entries);
    result.insert(result.end(), of_v.begin(), of_v.end());
    return result;
  }

  const Model& model_;
  const Program& calls_;
  const Function& step_;
  Composition& compose_;
  InstructionIndices places_ = {};  ///< the composed function begins with the instructions of step_
};

/// Appends `more` to `all`.
void append(InstructionIndices& all, const InstructionIndices& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// sum + m x
InstructionIndices add_product(Composition& compose, InstructionIndices sum, const ValueMatrix& m,
                               const InstructionIndices& x) {
  for (std::size_t at = 0; at < m.entries.size(); ++at) {
    std::uint32_t& entry = sum[at / m.columns];
    const std::uint32_t term = compose.add(Opcode::multiply, m.entries[at], x[at % m.columns]);
    entry = compose.add(Opcode::add, entry, term);
  }
  return sum;
}

class StageDifferentiator {
 public:
  /// Adds the instructions of `step` to `compose`, with accelerations from the parts.
  StageDifferentiator(const Model& model, const StepCallees& calls, const Function& step,
                      const std::vector<CallPoint>& stages, Composition& compose)
      : model_(model),
        step_(step),
        stages_(stages),
        compose_(compose),
        zeros_(model.velocities.size(), compose.add_number(0)) {
    for (std::size_t at = 0; at < step.instructions.size(); ++at) {
      const Instruction& i = step.instructions[at];
      if (i.opcode == Opcode::acceleration) {
        if (i.a == accelerations_.size()) call_parts(calls.acceleration_parts);
        places_.push_back(accelerations_[i.a]);
        continue;
      }
      places_.push_back(compose.add(renumber_operands(i, places_)));
      compose.name(places_.back(), step.names[at]);
    }
    for (const CallPoint& stage : stages)
      moves_.push_back(coordinate_directions(compose, model, calls.outputs, values_of(stage.q)));
    moves_.push_back(
        coordinate_directions(compose, model, calls.outputs, values_of(step.fields[0].entries)));
  }

  [[nodiscard]] std::vector<InstructionIndices> compose_columns() const {
    const std::uint32_t one = compose_.add_number(1);
    std::vector<InstructionIndices> directions;
    for (std::size_t j = 0; j < 2 * size() + model_.inputs.size(); ++j) {
      LeafTangents seeds = zero_seeds();
      if (j < size()) seeds.q = moves_.front()[j];
      if (j >= size()) (j < 2 * size() ? seeds.v[j - size()] : seeds.u[j - 2 * size()]) = one;
      directions.push_back(forces_and_end(seeds));
    }
    std::vector<InstructionIndices> effects;
    for (std::size_t i = 0; i < accelerations_.size(); ++i) {
      LeafTangents seeds = zero_seeds();
      seeds.a[i] = one;
      effects.push_back(forces_and_end(seeds));
    }
    return compose_.repeat_for_columns(
        directions, [&](Composition& compose, const InstructionIndices& direction) {
          return add_accelerations(compose, direction, effects);
        });
  }

 private:
  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }

  [[nodiscard]] InstructionIndices values_of(const InstructionIndices& instructions) const {
    InstructionIndices values;
    for (const std::uint32_t at : instructions) values.push_back(places_[at]);
    return values;
  }

  /// The accelerations and the derivatives of the forces at the next stage.
  void call_parts(const Program& parts) {
    const CallPoint& stage = stages_[dynamics_.size()];
    const CallPoint at{.q = values_of(stage.q),
                       .v = values_of(stage.v),
                       .t = model_.uses_time ? places_[stage.t] : 0,
                       .number = stage.number};
    dynamics_.emplace_back(compose_, parts, parts.functions.front(), at);
    compose_.set_name(dynamics_.back().accelerations(), Opcode::acceleration, at.number);
    append(accelerations_, dynamics_.back().accelerations());
    forces_.push_back(dynamics_.back().call({position_part, velocity_part, input_part}));
  }

  [[nodiscard]] LeafTangents zero_seeds() const {
    const auto zeros = [&](std::size_t count) { return InstructionIndices(count, zeros_.front()); };
    LeafTangents seeds;
    seeds.q = zeros(model_.coordinates.size());
    seeds.v = zeros_;
    seeds.u = zeros(model_.inputs.size());
    seeds.a = zeros(accelerations_.size());
    return seeds;
  }

  /// f_k0 or F_kl for all stages, then e_0 or E_l, along one direction.
  [[nodiscard]] InstructionIndices forces_and_end(const LeafTangents& seeds) const {
    const TangentPass tangents(compose_, step_, places_, seeds);
    const auto dx_of = [&](std::size_t k, const InstructionIndices& q) {
      return velocity_tangents(compose_, model_, moves_[k], tangents.tangents_of(q));
    };
    InstructionIndices result;
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      const std::vector<ValueMatrix>& by = forces_[k];
      InstructionIndices force = add_product(compose_, zeros_, by[0], dx_of(k, stages_[k].q));
      force = add_product(compose_, force, by[1], tangents.tangents_of(stages_[k].v));
      if (by.size() > 2) force = add_product(compose_, force, by[2], seeds.u);
      append(result, force);
    }
    append(result, dx_of(stages_.size(), step_.fields[0].entries));
    append(result, tangents.tangents_of(step_.fields[1].entries));
    return result;
  }

  /// A column. `sums`: f_k0 for all stages, then e_0; `effects`: F_kl and E_l for each da.
  [[nodiscard]] InstructionIndices add_accelerations(
      Composition& compose, InstructionIndices sums,
      const std::vector<InstructionIndices>& effects) const {
    const std::size_t n = size();
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      const auto force = sums.begin() + static_cast<std::ptrdiff_t>(k * n);
      const InstructionIndices a =
          dynamics_[k].mass().solve(compose, {force, force + static_cast<std::ptrdiff_t>(n)});
      compose.name(a, fmt::format("response_{}_", k + 1));
      for (std::size_t j = 0; j < n; ++j) sums = compose.add_scaled(sums, a[j], effects[k * n + j]);
    }
    return {sums.end() - static_cast<std::ptrdiff_t>(2 * n), sums.end()};
  }

  const Model& model_;
  const Function& step_;
  const std::vector<CallPoint>& stages_;
  Composition& compose_;
  InstructionIndices zeros_;                           ///< one for each velocity
  InstructionIndices places_ = {};                     ///< the values of the instructions of step_
  std::vector<AccelerationParts> dynamics_ = {};       ///< of each stage
  std::vector<std::vector<ValueMatrix>> forces_ = {};  ///< -dr/dq, -dr/dv, B of each stage
  InstructionIndices accelerations_ = {};              ///< of all stages
  std::vector<std::vector<InstructionIndices>> moves_ = {};  ///< of each stage and of the end
};

}  // namespace

std::vector<InstructionIndices> stage_jacobian_columns(const Model& model, const StepCallees& calls,
                                                       const Function& step,
                                                       const std::vector<CallPoint>& stages,
                                                       Composition& compose) {
  return StageDifferentiator(model, calls, step, stages, compose).compose_columns();
}

std::vector<InstructionIndices> step_jacobian_columns(const Model& model, const Program& calls,
                                                      const Function& step, Composition& compose) {
  return StepDifferentiator(model, calls, step, compose).compose_columns();
}

}  // namespace elgen
