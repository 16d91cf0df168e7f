// finish: see finish.hpp. A guard takes two instructions per pivot. A pivot needs no guard if M_ii
// is a number or if the pivot is already divided by M_ii. The guard multiplies by 1/M_ii if the
// function computes 1/M_ii. All components of a quaternion share the instructions that compute its
// length.
#include "choose/finish.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "elgen/model.hpp"
#include "program/network/instructions.hpp"

namespace elgen {
namespace {

bool has_diagonal(const Function& function) {
  return output_row(function.kind).gives_pivots && !function.fields.empty() &&
         function.fields.back().name == diagonal_field;
}

/// The index of the instruction 1/`value`; none if `function` has no such instruction.
std::optional<std::uint32_t> find_reciprocal(std::uint32_t value, const Function& function,
                                             const std::vector<Constant>& constants) {
  const std::vector<Instruction>& all = function.instructions;
  const auto is_reciprocal = [&](const Instruction& i) {
    if (i.opcode != Opcode::divide || i.b != value) return false;
    const Instruction& above = all[i.a];
    return above.opcode == Opcode::constant && constants[above.a].form == rational_form(1);
  };
  const auto found = std::ranges::find_if(all, is_reciprocal);
  if (found == all.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - all.begin());
}

class QuaternionScaler {
 public:
  explicit QuaternionScaler(Function& function) : function_(function), instructions_(function) {}

  void scale(Field& field) {
    for (std::size_t i = 0; i < field.entries.size();) {
      const Opcode opcode = function_.instructions[field.entries[i]].opcode;
      if (opcode == Opcode::coordinate) {
        ++i;
        continue;
      }
      const std::vector<std::uint32_t> unit = append_unit_quaternion(static_cast<std::uint32_t>(i));
      std::copy(unit.begin(), unit.end(), field.entries.begin() + static_cast<std::ptrdiff_t>(i));
      i += quaternion_size;
    }
  }

 private:
  std::uint32_t append_sum(const std::vector<std::uint32_t>& terms) {
    std::uint32_t result = terms[0];
    for (std::size_t i = 1; i < terms.size(); ++i)
      result = instructions_.add(Opcode::add, result, terms[i]);
    return result;
  }

  /// Adds instructions for the components of the unit quaternion. Coordinate `first` is the scalar
  /// part.
  std::vector<std::uint32_t> append_unit_quaternion(std::uint32_t first) {
    std::vector<std::uint32_t> values;
    std::vector<std::uint32_t> magnitudes;
    for (std::uint32_t i = 0; i < quaternion_size; ++i) {
      values.push_back(instructions_.add(Opcode::coordinate, first + i));
      magnitudes.push_back(instructions_.add(
          {.opcode = Opcode::call, .function = FunctionId::abs, .a = values.back()}));
    }
    const std::uint32_t size = append_sum(magnitudes);
    std::vector<std::uint32_t> squares;
    for (std::uint32_t& value : values) {
      value = instructions_.add(Opcode::divide, value, size);
      squares.push_back(instructions_.add(Opcode::multiply, value, value));
    }
    const std::uint32_t length = instructions_.add(Opcode::square_root, append_sum(squares));
    for (std::uint32_t& value : values) value = instructions_.add(Opcode::divide, value, length);
    return values;
  }

  Function& function_;
  InstructionBuilder instructions_;
};

using InstructionNumbers = std::vector<std::uint32_t>;
using SineAndCosine = std::array<std::optional<std::uint32_t>, 2>;

bool is_sine(const Instruction& i) {
  return i.opcode == Opcode::call && i.function == FunctionId::sin;
}

bool is_cosine(const Instruction& i) {
  return i.opcode == Opcode::call && i.function == FunctionId::cos;
}

class TrigonometryOrder {
 public:
  explicit TrigonometryOrder(const Function& function)
      : function_(function), placed_(size(), false) {
    InstructionNumbers calls;
    for (std::uint32_t at = 0; at < size(); ++at) {
      const Instruction& i = function.instructions[at];
      if (!is_sine(i) && !is_cosine(i)) continue;
      calls.push_back(at);
      calls_by_angle_[i.a][is_sine(i) ? 0 : 1] = at;
    }
    const std::vector<bool> needed = needed_instructions(function, calls);
    for (std::uint32_t at = 0; at < size(); ++at) {
      if (needed[at]) place_instruction(at);
    }
    for (std::uint32_t at = 0; at < size(); ++at) place_instruction(at);
  }

  /// Old instruction numbers in the new order: first sines and cosines with their operands, then
  /// all other instructions in their old order.
  InstructionNumbers order = {};

 private:
  [[nodiscard]] std::size_t size() const { return function_.instructions.size(); }

  void place_instruction(std::uint32_t at) {
    const Instruction& i = function_.instructions[at];
    if (!is_sine(i) && !is_cosine(i)) return place_single(at);
    for (const std::optional<std::uint32_t>& call : calls_by_angle_.at(i.a)) {
      if (call) place_single(*call);
    }
  }

  void place_single(std::uint32_t at) {
    if (!placed_[at]) order.push_back(at);
    placed_[at] = true;
  }

  const Function& function_;
  std::vector<bool> placed_;
  std::map<std::uint32_t, SineAndCosine> calls_by_angle_ = {};
};

}  // namespace

Function without_diagonal(Function function) {
  if (!has_diagonal(function)) return function;
  function.fields.pop_back();
  const auto count = static_cast<std::uint32_t>(entry_count(function));
  std::erase_if(function.sampled_zeros, [count](std::uint32_t entry) { return entry >= count; });
  return eliminate_dead_code(function);
}

Function with_guarded_pivots(Function forward_dynamics, std::vector<Constant>& constants) {
  if (!has_diagonal(forward_dynamics)) return forward_dynamics;
  const std::vector<std::uint32_t> diagonal = forward_dynamics.fields.back().entries;
  std::vector<std::uint32_t>& pivots = forward_dynamics.fields[1].entries;
  InstructionBuilder instructions(forward_dynamics);
  const Instruction zero{.opcode = Opcode::constant,
                         .a = intern_constant(rational_constant(0), constants)};
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const Instruction pivot = forward_dynamics.instructions[pivots[i]];
    const bool is_guarded = pivot.opcode == Opcode::divide && pivot.b == diagonal[i];
    const bool is_number = forward_dynamics.instructions[diagonal[i]].opcode == Opcode::constant;
    if (is_guarded || is_number) continue;
    const std::optional<std::uint32_t> reciprocal =
        find_reciprocal(diagonal[i], forward_dynamics, constants);
    const std::uint32_t guard =
        instructions.add(reciprocal ? Opcode::multiply : Opcode::divide, instructions.add(zero),
                         reciprocal.value_or(diagonal[i]));
    pivots[i] = instructions.add(Opcode::add, pivots[i], guard);
  }
  return without_diagonal(std::move(forward_dynamics));
}

Function with_scaled_lengths(Function function, const std::string& name) {
  for (Field& field : function.fields) {
    if (function.name == name || field.name == name) QuaternionScaler(function).scale(field);
  }
  return eliminate_dead_code(function);
}

Function with_trigonometry_first(const Function& function) {
  return reorder_instructions(function, TrigonometryOrder(function).order);
}

}  // namespace elgen
