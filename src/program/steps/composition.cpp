// Composition copies instruction by instruction; two calls share the values that both compute.
// L D L^T and its substitutions are computed entry by entry, without operations on zeros.
#include "program/steps/composition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "elgen/compose.hpp"
#include "elgen/leaf_names.hpp"
#include "model/elimination.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

/// With fewer columns, code without a loop is as fast: a vector register holds up to 16 numbers.
constexpr std::size_t least_columns = 16;

/// value - x y
std::uint32_t subtract_product(Composition& compose, std::uint32_t value, std::uint32_t x,
                               std::uint32_t y) {
  return compose.add(Opcode::subtract, value, compose.add(Opcode::multiply, x, y));
}

/// 4 (N e_j).dq
std::uint32_t rotation_tangent(Composition& compose, const InstructionIndices& move,
                               const InstructionIndices& dq) {
  std::uint32_t sum = compose.add_number(0);
  for (std::size_t c = 0; c < dq.size(); ++c) {
    sum = compose.add(Opcode::add, sum, compose.add(Opcode::multiply, move[c], dq[c]));
  }
  return compose.add(Opcode::multiply, compose.add_number(4), sum);
}

}  // namespace

std::uint32_t Composition::add_leaf(Opcode kind, std::uint32_t number) {
  return instructions_.add(Instruction{.opcode = kind, .a = number});
}

InstructionIndices Composition::add_leaves(Opcode kind, std::size_t count) {
  InstructionIndices places;
  for (std::uint32_t i = 0; i < count; ++i) places.push_back(add_leaf(kind, i));
  return places;
}

std::uint32_t Composition::add_number(const cln::cl_RA& value) {
  const std::uint32_t constant = intern_constant(rational_constant(value), program_.constants);
  return instructions_.add(Instruction{.opcode = Opcode::constant, .a = constant});
}

bool Composition::is_zero(std::uint32_t place) const {
  return loads_zero(program_, function_.instructions[place]);
}

bool Composition::is_one(std::uint32_t place) const {
  const Instruction& i = function_.instructions[place];
  return i.opcode == Opcode::constant && program_.constants[i.a].value == 1;
}

/// The simpler value to which the instruction reduces: an operand, 0 or a negation. None if it does
/// not reduce.
std::optional<std::uint32_t> Composition::simplified_value(const Instruction& i) {
  switch (i.opcode) {
    case Opcode::add:
      if (is_zero(i.a)) return i.b;
      return is_zero(i.b) ? std::optional(i.a) : std::nullopt;
    case Opcode::subtract:
      if (is_zero(i.b)) return i.a;
      if (!is_zero(i.a)) return std::nullopt;
      return add(Instruction{.opcode = Opcode::negate, .a = i.b, .is_inner = i.is_inner});
    case Opcode::multiply:
      if (is_zero(i.a) || is_one(i.b)) return i.a;
      return is_zero(i.b) || is_one(i.a) ? std::optional(i.b) : std::nullopt;
    case Opcode::divide:
      return is_zero(i.a) || is_one(i.b) ? std::optional(i.a) : std::nullopt;
    case Opcode::negate:
      return is_zero(i.a) ? std::optional(i.a) : std::nullopt;
    case Opcode::constant:
    case Opcode::square_root:
    case Opcode::call:
#define ELGEN_LEAVES(kind, ...) case Opcode::kind:
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
      break;
  }
  return std::nullopt;
}

std::uint32_t Composition::add(const Instruction& instruction) {
  const std::optional<std::uint32_t> known = simplified_value(instruction);
  return known ? *known : instructions_.add(instruction);
}

std::uint32_t Composition::add(Opcode opcode, std::uint32_t a, std::uint32_t b) {
  return add(Instruction{.opcode = opcode, .a = a, .b = b});
}

std::uint32_t Composition::add_call(FunctionId function, std::uint32_t x, std::uint32_t y) {
  const bool is_binary = function_row(function).arity == 2;
  return add({.opcode = Opcode::call, .function = function, .a = x, .b = is_binary ? y : 0});
}

InstructionIndices Composition::add(Opcode opcode, const InstructionIndices& x,
                                    const InstructionIndices& y) {
  InstructionIndices result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(add(opcode, x[i], y[i]));
  return result;
}

InstructionIndices Composition::add_scaled(const InstructionIndices& x, std::uint32_t c,
                                           const InstructionIndices& y) {
  InstructionIndices sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum.push_back(add(Opcode::add, x[i], add(Opcode::multiply, c, y[i])));
  }
  return sum;
}

std::uint32_t Composition::substitute_leaf(const Instruction& leaf, const CallPoint& at) {
  if (leaf.opcode == Opcode::coordinate) return at.q[leaf.a];
  if (leaf.opcode == Opcode::velocity) return at.v[leaf.a];
  if (leaf.opcode == Opcode::time) return at.t;
  if (leaf.opcode == Opcode::acceleration) return at.a[leaf.a];
  return instructions_.add(leaf);
}

InstructionIndices Composition::inline_call(const Program& from, const Function& callee,
                                            const Field& field, const CallPoint& at,
                                            bool is_inner) {
  const std::vector<bool> needed = needed_instructions(callee, field.entries);
  // Names that are spelt from operands are not kept, because the operands differ here from the
  // operands in the callee.
  const std::vector<std::string> names = context_free_names(from, callee);
  const std::string suffix = at.number > 1 ? fmt::format("_{}", at.number) : "";
  InstructionIndices places(callee.instructions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!needed[i]) continue;
    Instruction instruction = callee.instructions[i];
    if (is_leaf(instruction.opcode)) {
      places[i] = substitute_leaf(instruction, at);
      continue;
    }
    if (instruction.opcode == Opcode::constant) {
      instruction.a = intern_constant(from.constants[instruction.a], program_.constants);
    }
    instruction.is_inner = is_inner && operand_count(instruction) > 0;
    places[i] = add(renumber_operands(instruction, places));
    const bool is_computed = operand_count(function_.instructions[places[i]]) > 0;
    const bool is_marked = names[i].empty() && callee.names[i].starts_with(intermediate_mark);
    const std::string& own = is_marked ? callee.names[i] : names[i];
    if (is_computed && !own.empty()) merge_name(function_.names[places[i]], own + suffix);
  }
  InstructionIndices result;
  for (const std::uint32_t entry : field.entries) result.push_back(places[entry]);
  return result;
}

void Composition::set_name(const InstructionIndices& values, Opcode kind, std::uint32_t number) {
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const std::string of = identifier_of(leaf_of(program_.leaves, kind, i));
    const std::string leaf = fmt::format(fmt::runtime(leaf_row(kind).identifier), of);
    name(values[i], fmt::format("{}_{}", leaf, number));
  }
}

void Composition::name(std::uint32_t value, const std::string& name) {
  std::string& known = function_.names[value];
  if (operand_count(function_.instructions[value]) > 0 && known.empty()) known = name;
}

void Composition::name(const InstructionIndices& values, const std::string& prefix) {
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    name(values[i], prefix + identifier_of(leaf_of(program_.leaves, Opcode::velocity, i)));
  }
}

std::vector<std::size_t> Composition::columns_to_repeat(
    const std::vector<InstructionIndices>& columns, const Body& body, std::size_t length) const {
  Function straight = function_;
  Composition trial(program_, straight);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::size_t before = straight.instructions.size();
    (void)body(trial, columns[i]);
    if (3 * (straight.instructions.size() - before) > 2 * length) result.push_back(i);
  }
  if (result.size() < least_columns) result.clear();
  return result;
}

/// Composes `body` once, on leaves that no function has, in a copy of the function.
std::vector<InstructionIndices> Composition::repeat_for_columns(
    const std::vector<InstructionIndices>& columns, const Body& body) {
  Function pattern = function_;
  Composition trial(program_, pattern);
  const auto first = static_cast<std::uint32_t>(pattern.instructions.size());
  const std::size_t rows = columns.empty() ? 0 : columns.front().size();
  const InstructionIndices inner = body(trial, trial.add_leaves(Opcode::energy, rows));
  const auto begin = static_cast<std::uint32_t>(first + rows);
  const auto end = static_cast<std::uint32_t>(pattern.instructions.size());
  const std::vector<std::size_t> repeated = columns_to_repeat(columns, body, end - begin);
  std::vector<InstructionIndices> results(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!std::ranges::binary_search(repeated, i)) results[i] = body(*this, columns[i]);
  }
  for (const std::size_t i : repeated) {
    InstructionIndices places(end);
    std::iota(places.begin(), places.begin() + first, 0U);
    std::ranges::copy(columns[i], places.begin() + first);
    const std::string suffix = i == repeated.front() ? "" : fmt::format("_{}", i + 1);
    for (std::uint32_t at = begin; at < end; ++at) {
      places[at] = instructions_.append(renumber_operands(pattern.instructions[at], places));
      const std::string& name = pattern.names[at];
      if (!name.empty()) function_.names[places[at]] = name + suffix;
    }
    for (const std::uint32_t place : inner) results[i].push_back(places[place]);
  }
  if (!repeated.empty()) {
    function_.repeated = {end - begin, static_cast<std::uint32_t>(repeated.size())};
  }
  return results;
}

std::vector<InstructionIndices> coordinate_directions(Composition& compose, const Model& model,
                                                      const Program& calls,
                                                      const InstructionIndices& q) {
  std::vector<InstructionIndices> result;
  for (std::size_t j = 0; j < model.velocities.size(); ++j) {
    InstructionIndices unit(model.velocities.size(), compose.add_number(0));
    unit[j] = compose.add_number(1);
    if (model.rotations.empty()) {
      result.push_back(std::move(unit));
      continue;
    }
    const Function& rates = *find_function(calls, OutputKind::coordinate_rates);
    result.push_back(
        compose.inline_call(calls, rates, rates.fields.front(), {.q = q, .v = std::move(unit)}));
  }
  return result;
}

InstructionIndices velocity_tangents(Composition& compose, const Model& model,
                                     const std::vector<InstructionIndices>& moves,
                                     const InstructionIndices& dq) {
  InstructionIndices result;
  for (std::size_t j = 0; j < model.velocities.size(); ++j) {
    const Velocity& velocity = model.velocities[j];
    result.push_back(velocity.rotation ? rotation_tangent(compose, moves[j], dq)
                                       : dq[velocity.coordinate]);
  }
  return result;
}

InstructionIndices elimination_order(const Model& model) {
  InstructionIndices order(model.velocities.size());
  std::iota(order.begin(), order.end(), 0U);
  if (eliminates_backward(model)) std::reverse(order.begin(), order.end());
  return order;
}

MassFactorisation::MassFactorisation(Composition& compose, InstructionIndices order,
                                     const InstructionIndices& mass)
    : compose_(compose), order_(std::move(order)) {
  const std::size_t n = order_.size();
  lower_.resize(n);
  std::vector<InstructionIndices> unscaled(n);  // W = L D
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      std::uint32_t w = mass[order_[i] * n + order_[j]];
      for (std::size_t k = 0; k < j; ++k)
        w = subtract_product(compose_, w, lower_[j][k], unscaled[i][k]);
      unscaled[i].push_back(w);
      if (i == j) {
        reciprocals_.push_back(compose_.add(Opcode::divide, compose_.add_number(1), w));
        continue;
      }
      lower_[i].push_back(compose_.add(Opcode::multiply, w, reciprocals_[j]));
      compose_.name(lower_[i].back(), fmt::format("lower_{}_{}", order_[i] + 1, order_[j] + 1));
    }
  }
}

/// L^-1 r, indexed by row of M.
InstructionIndices MassFactorisation::forward_substitute(Composition& compose,
                                                         const InstructionIndices& r) const {
  InstructionIndices z = r;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    std::uint32_t& value = z[order_[i]];
    for (std::size_t k = 0; k < i; ++k)
      value = subtract_product(compose, value, lower_[i][k], z[order_[k]]);
  }
  return z;
}

/// L^-T D^-1 z, indexed by row of M.
InstructionIndices MassFactorisation::back_substitute(Composition& compose,
                                                      const InstructionIndices& z) const {
  const std::size_t n = order_.size();
  InstructionIndices x(n);
  for (std::size_t i = n; i-- > 0;) {
    std::uint32_t value = compose.add(Opcode::multiply, z[order_[i]], reciprocals_[i]);
    for (std::size_t k = i + 1; k < n; ++k)
      value = subtract_product(compose, value, lower_[k][i], x[order_[k]]);
    x[order_[i]] = value;
  }
  return x;
}

std::vector<InstructionIndices> MassFactorisation::solve_columns(
    const std::vector<InstructionIndices>& columns) const {
  return compose_.repeat_for_columns(columns,
                                     [this](Composition& compose, const InstructionIndices& r) {
                                       const InstructionIndices z = forward_substitute(compose, r);
                                       compose.name(z, "reduced_");
                                       InstructionIndices x = back_substitute(compose, z);
                                       compose.name(x, "response_");
                                       return x;
                                     });
}

AccelerationParts::AccelerationParts(Composition& compose, const Program& from,
                                     const Function& parts, CallPoint at)
    : compose_(compose),
      from_(from),
      parts_(parts),
      at_(std::move(at)),
      dynamics_(call({mass_part, force_part})),
      mass_(compose, parts.elimination_order, dynamics_[0].entries) {
  at_.a = mass_.solve(dynamics_[1].entries);
}

std::vector<ValueMatrix> AccelerationParts::call(const std::vector<std::string_view>& names) const {
  Field all;
  std::vector<ValueMatrix> result;
  for (const std::string_view name : names) {
    const auto field = std::ranges::find(parts_.fields, name, &Field::name);
    if (field == parts_.fields.end()) continue;
    all.entries.insert(all.entries.end(), field->entries.begin(), field->entries.end());
    result.push_back({InstructionIndices(field->entries.size()), field->columns});
  }
  if (result.empty()) return result;
  const InstructionIndices values = compose_.inline_call(from_, parts_, all, at_);
  auto next = values.begin();
  for (ValueMatrix& matrix : result) {
    const auto end = next + static_cast<std::ptrdiff_t>(matrix.entries.size());
    matrix.entries.assign(std::exchange(next, end), end);
  }
  return result;
}

}  // namespace elgen
