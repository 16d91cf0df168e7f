// step_jacobian_columns: one forward pass over the instructions of a step for each direction of the
// state and the inputs. Every pass has the same code, so dense passes become the repetitions of the
// function.
//
//     s = a b    ->    ds = da b + a db
//
// Directions of a rotation are rotation vectors in body axes, before and after the step:
//
//     dq = N(q) dx,    dx' = 4 N(q')^T dq'
#include <optional>
#include <utility>

#include "base/function_slopes.hpp"
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

/// The tangents of the leaves of a step along one direction.
struct LeafTangents {
  InstructionIndices q;
  InstructionIndices v;
  InstructionIndices u;
};

/// The tangents of all instructions of a step along a direction. The composed function must begin
/// with these instructions.
class TangentPass {
 public:
  TangentPass(Composition& compose, const Function& step, const LeafTangents& seeds)
      : compose_(compose), zero_(compose.add_number(0)) {
    for (std::uint32_t at = 0; at < step.instructions.size(); ++at) {
      tangents_.push_back(compute_tangent(step.instructions[at], at, seeds));
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

  std::uint32_t compute_tangent(const Instruction& i, std::uint32_t at, const LeafTangents& seeds) {
    if (operand_count(i) == 0) return leaf_tangent(i, seeds);
    const std::uint32_t da = tangents_[i.a];
    const std::uint32_t db = operand_count(i) > 1 ? tangents_[i.b] : zero_;
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
    if (i.opcode == Opcode::coordinate) return seeds.q[i.a];
    if (i.opcode == Opcode::velocity) return seeds.v[i.a];
    return i.opcode == Opcode::input ? seeds.u[i.a] : zero_;
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
      : model_(model), calls_(calls), step_(step), compose_(compose) {}

  /// The columns of A, then the columns of B.
  [[nodiscard]] std::vector<InstructionIndices> compose_columns() {
    const std::vector<InstructionIndices> moves =
        coordinate_directions(compose_.add_leaves(Opcode::coordinate, coordinate_count()));
    const std::vector<InstructionIndices> moves_after =
        coordinate_directions(step_.fields[0].entries);
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

  /// N e_j at a position, for each velocity.
  [[nodiscard]] std::vector<InstructionIndices> coordinate_directions(const InstructionIndices& q) {
    std::vector<InstructionIndices> result;
    for (std::size_t j = 0; j < velocity_count(); ++j) {
      InstructionIndices unit(velocity_count(), zero());
      unit[j] = compose_.add_number(1);
      if (model_.rotations.empty()) {
        result.push_back(std::move(unit));
        continue;
      }
      const Function& rates = *find_function(calls_, OutputKind::coordinate_rates);
      result.push_back(compose_.inline_call(calls_, rates, rates.fields.front(),
                                            {.q = q, .v = std::move(unit)}));
    }
    return result;
  }

  /// dx', then dv', along one direction of q, v, u.
  [[nodiscard]] InstructionIndices tangent(Composition& compose,
                                           const std::vector<InstructionIndices>& moves_after,
                                           const InstructionIndices& direction) const {
    const auto part = [&](std::size_t first, std::size_t count) {
      const auto begin = direction.begin() + static_cast<std::ptrdiff_t>(first);
      return InstructionIndices(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    const LeafTangents seeds{part(0, coordinate_count()),
                             part(coordinate_count(), velocity_count()),
                             part(coordinate_count() + velocity_count(), input_count())};
    const TangentPass tangents(compose, step_, seeds);
    const InstructionIndices of_q = tangents.tangents_of(step_.fields[0].entries);
    InstructionIndices result;
    for (std::size_t j = 0; j < velocity_count(); ++j) {
      const bool turns = model_.velocities[j].rotation.has_value();
      result.push_back(turns ? rotation_tangent(compose, moves_after[j], of_q)
                             : of_q[model_.velocities[j].coordinate]);
    }
    const InstructionIndices of_v = tangents.tangents_of(step_.fields[1].entries);
    result.insert(result.end(), of_v.begin(), of_v.end());
    return result;
  }

  /// 4 (N e_j).dq
  [[nodiscard]] static std::uint32_t rotation_tangent(Composition& compose,
                                                      const InstructionIndices& move,
                                                      const InstructionIndices& dq) {
    std::uint32_t sum = compose.add_number(0);
    for (std::size_t c = 0; c < dq.size(); ++c) {
      sum = compose.add(Opcode::add, sum, compose.add(Opcode::multiply, move[c], dq[c]));
    }
    return compose.add(Opcode::multiply, compose.add_number(4), sum);
  }

  const Model& model_;
  const Program& calls_;
  const Function& step_;
  Composition& compose_;
};

}  // namespace

std::vector<InstructionIndices> step_jacobian_columns(const Model& model, const Program& calls,
                                                      const Function& step, Composition& compose) {
  return StepDifferentiator(model, calls, step, compose).compose_columns();
}

}  // namespace elgen
