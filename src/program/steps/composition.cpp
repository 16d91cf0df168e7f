// Composition: instruction by instruction; what two calls compute alike is one value. L D L^T and
// its substitutions value by value: what is 0 is left out.
#include "program/steps/composition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "elgen/leaf_names.hpp"
#include "model/elimination.hpp"

namespace elgen {

std::uint32_t Composition::leaf(Opcode kind, std::uint32_t number) {
  return instructions_.add(Instruction{.opcode = kind, .a = number});
}

Places Composition::leaves(Opcode kind, std::size_t count) {
  Places places;
  for (std::uint32_t i = 0; i < count; ++i) places.push_back(leaf(kind, i));
  return places;
}

std::uint32_t Composition::number(const cln::cl_RA& value) {
  const std::uint32_t constant = position_of(rational_constant(value), program_.constants);
  return instructions_.add(Instruction{.opcode = Opcode::constant, .a = constant});
}

bool Composition::is_zero(std::uint32_t place) const {
  return loads_zero(program_, function_.instructions[place]);
}

bool Composition::is_one(std::uint32_t place) const {
  const Instruction& i = function_.instructions[place];
  return i.opcode == Opcode::constant && program_.constants[i.a].value == 1;
}

/// A value that is there already, or 0 or a change of sign.
std::optional<std::uint32_t> Composition::trivial(const Instruction& i) {
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
  const std::optional<std::uint32_t> known = trivial(instruction);
  return known ? *known : instructions_.add(instruction);
}

std::uint32_t Composition::add(Opcode opcode, std::uint32_t a, std::uint32_t b) {
  return add(Instruction{.opcode = opcode, .a = a, .b = b});
}

Places Composition::add(Opcode opcode, const Places& x, const Places& y) {
  Places result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(add(opcode, x[i], y[i]));
  return result;
}

Places Composition::moved(const Places& x, std::uint32_t c, const Places& y) {
  Places sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum.push_back(add(Opcode::add, x[i], add(Opcode::multiply, c, y[i])));
  }
  return sum;
}

std::uint32_t Composition::leaf_at(const Instruction& leaf, const CallPoint& at) {
  if (leaf.opcode == Opcode::coordinate) return at.q[leaf.a];
  if (leaf.opcode == Opcode::velocity) return at.v[leaf.a];
  if (leaf.opcode == Opcode::time) return at.t;
  return instructions_.add(leaf);
}

Places Composition::call(const Program& from, const Function& callee, const Field& field,
                         const CallPoint& at, bool is_inner) {
  const std::vector<bool> needed = needed_for(callee, field.entries);
  // The other names say of what a value is computed, which is another one here.
  const std::vector<std::string> names = own_names(from, callee);
  const std::string suffix = at.number > 1 ? fmt::format("_{}", at.number) : "";
  Places places(callee.instructions.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!needed[i]) continue;
    Instruction instruction = callee.instructions[i];
    if (is_leaf(instruction.opcode)) {
      places[i] = leaf_at(instruction, at);
      continue;
    }
    if (instruction.opcode == Opcode::constant) {
      instruction.a = position_of(from.constants[instruction.a], program_.constants);
    }
    instruction.is_inner = is_inner && operand_count(instruction) > 0;
    places[i] = add(with_operands(instruction, places));
    const bool is_computed = operand_count(function_.instructions[places[i]]) > 0;
    std::string& name = function_.names[places[i]];
    if (is_computed && !names[i].empty() && name.empty()) name = names[i] + suffix;
  }
  Places result;
  for (const std::uint32_t entry : field.entries) result.push_back(places[entry]);
  return result;
}

void Composition::name(const Places& values, Opcode kind, std::uint32_t number) {
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    if (operand_count(function_.instructions[values[i]]) == 0) continue;
    std::string& name = function_.names[values[i]];
    if (!name.empty()) continue;
    const std::string of = identifier_of(leaf_of(program_.leaves, kind, i));
    name = fmt::format("{}_{}", fmt::format(fmt::runtime(leaf_row(kind).identifier), of), number);
  }
}

Factorised::Factorised(Composition& compose, const Model& model, const Places& mass)
    : compose_(compose), order_(model.velocities.size()) {
  const std::size_t n = order_.size();
  std::iota(order_.begin(), order_.end(), 0U);
  if (eliminates_last_first(model)) std::reverse(order_.begin(), order_.end());
  lower_.resize(n);
  std::vector<Places> unscaled(n);  // W = L D
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      std::uint32_t w = mass[order_[i] * n + order_[j]];
      for (std::size_t k = 0; k < j; ++k) w = less(w, lower_[j][k], unscaled[i][k]);
      unscaled[i].push_back(w);
      if (i == j) reciprocals_.push_back(compose_.add(Opcode::divide, compose_.number(1), w));
      if (i > j) lower_[i].push_back(compose_.add(Opcode::multiply, w, reciprocals_[j]));
    }
  }
}

/// value - x y
std::uint32_t Factorised::less(std::uint32_t value, std::uint32_t x, std::uint32_t y) {
  return compose_.add(Opcode::subtract, value, compose_.add(Opcode::multiply, x, y));
}

Places Factorised::solve(const Places& r) {
  const std::size_t n = order_.size();
  Places z;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t value = r[order_[i]];
    for (std::size_t k = 0; k < i; ++k) value = less(value, lower_[i][k], z[k]);
    z.push_back(value);
  }
  Places x(n);
  for (std::size_t i = n; i-- > 0;) {
    std::uint32_t value = compose_.add(Opcode::multiply, z[i], reciprocals_[i]);
    for (std::size_t k = i + 1; k < n; ++k) value = less(value, lower_[k][i], x[order_[k]]);
    x[order_[i]] = value;
  }
  return x;
}

}  // namespace elgen
