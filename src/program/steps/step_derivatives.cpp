// step_columns: one forward pass over the instructions of a step for each direction of the state
// and the inputs. Every pass has the same code, so dense passes become the repetitions of the
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
struct Slope {
  std::uint32_t place = 0;  ///< of a value, if there are no operands
  Opcode opcode = Opcode::constant;
  FunctionId function = FunctionId::sin;
  std::vector<Slope> operands = {};
  std::optional<int> number = {};

  [[nodiscard]] std::uint32_t composed(Composition& compose) const {
    if (number) return compose.number(*number);
    if (operands.empty()) return place;
    const std::uint32_t x = operands.front().composed(compose);
    const std::uint32_t y = operands.size() > 1 ? operands.back().composed(compose) : 0;
    return opcode == Opcode::call ? compose.add_call(function, x, y) : compose.add(opcode, x, y);
  }

  static Slope of(Opcode opcode, std::vector<Slope> operands) {
    return {.opcode = opcode, .operands = std::move(operands)};
  }
  friend Slope operator+(const Slope& x, const Slope& y) { return of(Opcode::add, {x, y}); }
  friend Slope operator-(const Slope& x, const Slope& y) { return of(Opcode::subtract, {x, y}); }
  friend Slope operator*(const Slope& x, const Slope& y) { return of(Opcode::multiply, {x, y}); }
  friend Slope operator/(const Slope& x, const Slope& y) { return of(Opcode::divide, {x, y}); }
  friend Slope operator-(const Slope& x) { return Slope{.number = 0} - x; }
  friend Slope operator*(const Slope& x, int factor) { return x * Slope{.number = factor}; }
};

Slope sqrt(const Slope& x) { return Slope::of(Opcode::square_root, {x}); }

Slope called(FunctionId function, const Slope& x, const Slope& y) {
  return {.opcode = Opcode::call, .function = function, .operands = {x, y}};
}

/// The tangents of the leaves of a step along one direction.
struct LeafTangents {
  Places q;
  Places v;
  Places u;
};

/// The tangents of all instructions of a step along a direction. The composed function must begin
/// with these instructions.
class Tangents {
 public:
  Tangents(Composition& compose, const Function& step, const LeafTangents& seeds)
      : compose_(compose), zero_(compose.number(0)) {
    for (std::uint32_t at = 0; at < step.instructions.size(); ++at) {
      tangents_.push_back(tangent(step.instructions[at], at, seeds));
    }
  }

  [[nodiscard]] Places of(const Places& values) const {
    Places result;
    for (const std::uint32_t value : values) result.push_back(tangents_[value]);
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t with(Opcode opcode, std::uint32_t a, std::uint32_t b = 0) {
    return compose_.add(opcode, a, b);
  }

  std::uint32_t tangent(const Instruction& i, std::uint32_t at, const LeafTangents& seeds) {
    if (operand_count(i) == 0) return of_leaf(i, seeds);
    const std::uint32_t da = tangents_[i.a];
    const std::uint32_t db = operand_count(i) > 1 ? tangents_[i.b] : zero_;
    if (da == zero_ && db == zero_) return zero_;
    switch (i.opcode) {
      case Opcode::negate:
        return with(i.opcode, da);
      case Opcode::add:
      case Opcode::subtract:
        return with(i.opcode, da, db);
      case Opcode::multiply: {
        const std::uint32_t left = with(Opcode::multiply, da, i.b);
        return with(Opcode::add, left, with(Opcode::multiply, db, i.a));
      }
      case Opcode::divide: {
        const std::uint32_t shrinking = with(Opcode::multiply, at, db);
        return with(Opcode::divide, with(Opcode::subtract, da, shrinking), i.b);
      }
      case Opcode::square_root:
        return with(Opcode::divide, da, with(Opcode::add, at, at));
      case Opcode::call:
        return of_call(i, at, da, db);
      case Opcode::constant:
#define ELGEN_LEAVES(kind, ...) case Opcode::kind:
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
        break;
    }
    return zero_;
  }

  [[nodiscard]] std::uint32_t of_leaf(const Instruction& i, const LeafTangents& seeds) const {
    if (i.opcode == Opcode::coordinate) return seeds.q[i.a];
    if (i.opcode == Opcode::velocity) return seeds.v[i.a];
    return i.opcode == Opcode::input ? seeds.u[i.a] : zero_;
  }

  [[nodiscard]] std::uint32_t of_call(const Instruction& i, std::uint32_t at, std::uint32_t da,
                                      std::uint32_t db) {
    const Slope y{.place = operand_count(i) > 1 ? i.b : i.a};
    const auto slopes =
        function_slopes(i.function, Slope{.place = i.a}, y, Slope{.place = at}, Slope{.number = 1});
    std::uint32_t sum = zero_;
    for (const auto& [slope, tangent] : {std::pair(slopes[0], da), std::pair(slopes[1], db)}) {
      if (tangent == zero_) continue;
      sum = with(Opcode::add, sum, with(Opcode::multiply, slope.composed(compose_), tangent));
    }
    return sum;
  }

  Composition& compose_;
  std::uint32_t zero_;
  Places tangents_ = {};
};

class Differentiation {
 public:
  Differentiation(const Model& model, const Program& calls, const Function& step,
                  Composition& compose)
      : model_(model), calls_(calls), step_(step), compose_(compose) {}

  /// The columns of A, then the columns of B.
  [[nodiscard]] std::vector<Places> columns() {
    const std::vector<Places> moves = moves_at(compose_.leaves(Opcode::coordinate, size_of_q()));
    const std::vector<Places> moves_after = moves_at(step_.fields[0].entries);
    std::vector<Places> directions = moves;
    for (Places& direction : directions) direction.resize(size_of_q() + size() + inputs(), zero());
    for (std::size_t j = 0; j < size() + inputs(); ++j) {
      Places& direction = directions.emplace_back(size_of_q() + size() + inputs(), zero());
      direction[size_of_q() + j] = compose_.number(1);
    }
    return compose_.repeat(directions, [&](Composition& compose, const Places& direction) {
      return tangent(compose, moves_after, direction);
    });
  }

 private:
  [[nodiscard]] std::size_t size() const { return model_.velocities.size(); }
  [[nodiscard]] std::size_t size_of_q() const { return model_.coordinates.size(); }
  [[nodiscard]] std::size_t inputs() const { return model_.inputs.size(); }
  [[nodiscard]] std::uint32_t zero() const { return compose_.number(0); }

  /// N e_j at a position, for each velocity.
  [[nodiscard]] std::vector<Places> moves_at(const Places& q) {
    std::vector<Places> result;
    for (std::size_t j = 0; j < size(); ++j) {
      Places unit(size(), zero());
      unit[j] = compose_.number(1);
      if (model_.rotations.empty()) {
        result.push_back(std::move(unit));
        continue;
      }
      const Function& rates = *find_function(calls_, OutputKind::coordinate_rates);
      result.push_back(
          compose_.call(calls_, rates, rates.fields.front(), {.q = q, .v = std::move(unit)}));
    }
    return result;
  }

  /// dx', then dv', along one direction of q, v, u.
  [[nodiscard]] Places tangent(Composition& compose, const std::vector<Places>& moves_after,
                               const Places& direction) const {
    const auto part = [&](std::size_t first, std::size_t count) {
      const auto begin = direction.begin() + static_cast<std::ptrdiff_t>(first);
      return Places(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    const LeafTangents seeds{part(0, size_of_q()), part(size_of_q(), size()),
                             part(size_of_q() + size(), inputs())};
    const Tangents tangents(compose, step_, seeds);
    const Places of_q = tangents.of(step_.fields[0].entries);
    Places result;
    for (std::size_t j = 0; j < size(); ++j) {
      const bool turns = model_.velocities[j].rotation.has_value();
      result.push_back(turns ? turned(compose, moves_after[j], of_q)
                             : of_q[model_.velocities[j].coordinate]);
    }
    const Places of_v = tangents.of(step_.fields[1].entries);
    result.insert(result.end(), of_v.begin(), of_v.end());
    return result;
  }

  /// 4 (N e_j).dq
  [[nodiscard]] static std::uint32_t turned(Composition& compose, const Places& move,
                                            const Places& dq) {
    std::uint32_t sum = compose.number(0);
    for (std::size_t c = 0; c < dq.size(); ++c) {
      sum = compose.add(Opcode::add, sum, compose.add(Opcode::multiply, move[c], dq[c]));
    }
    return compose.add(Opcode::multiply, compose.number(4), sum);
  }

  const Model& model_;
  const Program& calls_;
  const Function& step_;
  Composition& compose_;
};

}  // namespace

std::vector<Places> step_columns(const Model& model, const Program& calls, const Function& step,
                                 Composition& compose) {
  return Differentiation(model, calls, step, compose).columns();
}

}  // namespace elgen
