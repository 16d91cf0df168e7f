// The explicit methods. They call only accelerations, and coordinate rates if there are rotations.
// If accelerations are open (StepContext), they are leaves, and the caller computes them at
// NextState::stages.
// If the step has directions (StepContext), all values have tangents. The tangents of accelerations
// come from a call of the derivatives of accelerations:
//
//     da = (da/dq) dq + (da/dv) dv + (da/du) du
#include <algorithm>
#include <utility>

#include "program/evaluate/subject.hpp"
#include "program/steps/methods.hpp"

namespace elgen {
namespace {

/// Values, and their tangents along every direction of the step.
struct DualValues {
  InstructionIndices value = {};
  std::vector<InstructionIndices> tangents = {};
};

/// A state, or its rates.
struct DualState {
  DualValues q = {};
  DualValues v = {};
};

/// x + c k
DualValues add_scaled(Composition& compose, const DualValues& x, std::uint32_t c,
                      const DualValues& k) {
  DualValues result{compose.add_scaled(x.value, c, k.value)};
  for (std::size_t j = 0; j < x.tangents.size(); ++j) {
    result.tangents.push_back(compose.add_scaled(x.tangents[j], c, k.tangents[j]));
  }
  return result;
}

DualValues sum(Composition& compose, const DualValues& x, const DualValues& y) {
  DualValues result{compose.add(Opcode::add, x.value, y.value)};
  for (std::size_t j = 0; j < x.tangents.size(); ++j) {
    result.tangents.push_back(compose.add(Opcode::add, x.tangents[j], y.tangents[j]));
  }
  return result;
}

/// q with every quaternion divided by its length.
InstructionIndices normalise_quaternions(const StepContext& step, InstructionIndices q) {
  for (const Rotation& rotation : step.model.rotations) {
    std::uint32_t* const e = &q[rotation.first_coordinate];
    std::uint32_t square = step.composition.add(Opcode::multiply, e[0], e[0]);
    for (std::size_t i = 1; i < quaternion_size; ++i) {
      square = step.composition.add(Opcode::add, square,
                                    step.composition.add(Opcode::multiply, e[i], e[i]));
    }
    const std::uint32_t length = step.composition.add(Opcode::square_root, square);
    for (std::size_t i = 0; i < quaternion_size; ++i) {
      e[i] = step.composition.add(Opcode::divide, e[i], length);
    }
  }
  return q;
}

class ExplicitStepComposer {
 public:
  explicit ExplicitStepComposer(const StepContext& step)
      : step_(step), compose_(step.composition) {}

  NextState rk4() {
    const DualState start = initial_dual_state();
    std::vector<DualState> k{rates_at(step_.start, start)};
    k.push_back(rates_after(start, step_.half_step, k[0], 2));
    k.push_back(rates_after(start, step_.half_step, k[1], 3));
    k.push_back(rates_after(start, step_.h, k[2], 4));
    const std::uint32_t sixth = compose_.add(Opcode::divide, step_.h, compose_.add_number(6));
    DualState end{add_scaled(compose_, start.q, sixth, weighted_rates(k, &DualState::q))};
    end.q.value = normalise_quaternions(step_, std::move(end.q.value));
    end.v = add_scaled(compose_, start.v, sixth, weighted_rates(k, &DualState::v));
    return next_state(end);
  }

  /// The state after a step. A single kick ends a part of the step and begins the next part.
  NextState verlet() {
    CallPoint at = step_.start;
    DualState x = initial_dual_state();
    cln::cl_RA before = 0;
    cln::cl_RA time = 0;
    for (const cln::cl_RA& part : step_.parts) {
      const std::uint32_t kick = step_.step_multiple((before + part) / 2);
      x.v = add_scaled(compose_, x.v, kick, acceleration(at, x));
      x.q = add_scaled(compose_, x.q, step_.step_multiple(part), x.v);
      at.q = x.q.value;
      at.v = x.v.value;
      time = time + part;
      at.t = step_.time_at_fraction(time);
      ++at.number;
      step_.name_entries(at);
      before = part;
    }
    const std::uint32_t kick = step_.step_multiple(before / 2);
    x.v = add_scaled(compose_, x.v, kick, acceleration(at, x));
    return next_state(x);
  }

 private:
  [[nodiscard]] std::size_t size() const { return step_.model.velocities.size(); }

  [[nodiscard]] NextState next_state(const DualState& end) const {
    NextState next{.q = end.q.value, .v = end.v.value, .stages = stages_};
    for (std::size_t j = 0; j < end.q.tangents.size(); ++j) {
      InstructionIndices& column = next.columns.emplace_back(end.q.tangents[j]);
      column.insert(column.end(), end.v.tangents[j].begin(), end.v.tangents[j].end());
    }
    return next;
  }

  /// The state at the start of the step; its directions are q, v and u.
  DualState initial_dual_state() {
    DualState start{{step_.start.q}, {step_.start.v}};
    const std::uint32_t zero = compose_.add_number(0);
    for (std::size_t j = 0; j < step_.direction_count; ++j) {
      for (DualValues* const part : {&start.q, &start.v}) {
        part->tangents.emplace_back(part->value.size(), zero);
      }
      if (j < size()) start.q.tangents[j][j] = compose_.add_number(1);
      if (j >= size() && j < 2 * size()) start.v.tangents[j][j - size()] = compose_.add_number(1);
    }
    return start;
  }

  InstructionIndices call_output(OutputKind kind, const CallPoint& at, bool is_inner = false) {
    const Function& function = *find_function(step_.callees, kind);
    return compose_.inline_call(step_.callees, function, function.fields.front(), at, is_inner);
  }

  DualValues acceleration(const CallPoint& at, const DualState& x) {
    if (step_.has_open_accelerations) {
      InstructionIndices a;
      for (std::size_t i = 0; i < size(); ++i) {
        const std::size_t number = stages_.size() * size() + i;
        a.push_back(compose_.add_leaf(Opcode::acceleration, static_cast<std::uint32_t>(number)));
      }
      stages_.push_back(at);
      return {std::move(a)};
    }
    DualValues a{call_output(OutputKind::forward_dynamics, at, step_.has_float_accelerations)};
    compose_.set_name(a.value, Opcode::acceleration, at.number);
    if (step_.direction_count > 0) a.tangents = tangents_of_acceleration(at, x);
    return a;
  }

  std::vector<InstructionIndices> tangents_of_acceleration(const CallPoint& at,
                                                           const DualState& x) {
    const Function& slopes =
        *find_function(step_.callees, OutputKind::forward_dynamics_derivatives);
    Field all;
    for (const Field& field : slopes.fields) {
      all.entries.insert(all.entries.end(), field.entries.begin(), field.entries.end());
    }
    const InstructionIndices entries = compose_.inline_call(step_.callees, slopes, all, at);
    const std::size_t n = size();
    std::vector<InstructionIndices> result;
    for (std::size_t j = 0; j < step_.direction_count; ++j) {
      InstructionIndices column;
      for (std::size_t i = 0; i < n; ++i) {
        const bool is_input = j >= 2 * n;
        const std::size_t inputs = step_.direction_count - 2 * n;
        std::uint32_t sum =
            is_input ? entries[2 * n * n + i * inputs + j - 2 * n] : compose_.add_number(0);
        for (std::size_t l = 0; l < n; ++l) {
          sum = add_product(sum, entries[i * n + l], x.q.tangents[j][l]);
          sum = add_product(sum, entries[n * n + i * n + l], x.v.tangents[j][l]);
        }
        column.push_back(sum);
      }
      result.push_back(std::move(column));
    }
    return result;
  }

  std::uint32_t add_product(std::uint32_t sum, std::uint32_t x, std::uint32_t y) {
    return compose_.add(Opcode::add, sum, compose_.add(Opcode::multiply, x, y));
  }

  DualState rates_at(const CallPoint& at, const DualState& x) {
    DualState rates;
    rates.q = x.v;
    if (!step_.model.rotations.empty()) rates.q = {call_output(OutputKind::coordinate_rates, at)};
    rates.v = acceleration(at, x);
    return rates;
  }

  /// The rates at start + c k, for call `number`.
  DualState rates_after(const DualState& start, std::uint32_t c, const DualState& k,
                        std::uint32_t number) {
    DualState x{add_scaled(compose_, start.q, c, k.q)};
    x.q.value = normalise_quaternions(step_, std::move(x.q.value));
    x.v = add_scaled(compose_, start.v, c, k.v);
    CallPoint at{.q = x.q.value, .v = x.v.value};
    at.t = step_.time_after(c);
    at.number = number;
    step_.name_entries(at);
    return rates_at(at, x);
  }

  /// k1 + 2 (k2 + k3) + k4
  DualValues weighted_rates(const std::vector<DualState>& k, DualValues DualState::*part) {
    const std::uint32_t two = compose_.add_number(2);
    const DualValues middle = sum(compose_, k[1].*part, k[2].*part);
    return sum(compose_, add_scaled(compose_, k[0].*part, two, middle), k[3].*part);
  }

  const StepContext& step_;
  Composition& compose_;
  std::vector<CallPoint> stages_ = {};  ///< if the accelerations are open
};

}  // namespace

NextState compose_rk4(const StepContext& step) { return ExplicitStepComposer(step).rk4(); }

NextState compose_verlet(const StepContext& step) { return ExplicitStepComposer(step).verlet(); }

}  // namespace elgen
