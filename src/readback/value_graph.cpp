// value_graph: nodes are instructions whose operands carry signs; each is kept once.
#include "readback/value_graph.hpp"

#include <fmt/format.h>

#include <array>

#include "base/number_text.hpp"
#include "readback/literal.hpp"

namespace elgen {
namespace {

constexpr int deepest_text = 5;

std::uint32_t packed(SignedNode x) { return 2 * x.node + (x.is_negative ? 1 : 0); }
SignedNode unpacked(std::uint32_t operand) { return {operand / 2, operand % 2 == 1}; }

char sign_of(Opcode opcode) {
  switch (opcode) {
    case Opcode::add:
      return '+';
    case Opcode::subtract:
      return '-';
    case Opcode::multiply:
      return '*';
    default:
      return '/';
  }
}

/// "m", "q[1]", "t"
std::string code_text(const LeafNames& leaves, Opcode kind, std::uint32_t number) {
  if (kind == Opcode::parameter) return leaves.parameters[number];
  const std::string_view symbol = leaf_row(kind).symbol;
  return is_single(kind) ? std::string(symbol) : fmt::format("{}[{}]", symbol, number);
}

std::string bracketed(bool is_operand, const std::string& text) {
  return is_operand ? "(" + text + ")" : text;
}

}  // namespace

SignedNode negated(SignedNode x) {
  x.is_negative = !x.is_negative;
  return x;
}

SignedNode ValueGraph::node(const Instruction& instruction) {
  const auto next = static_cast<std::uint32_t>(nodes_.size());
  const auto [known, is_new] = known_.emplace(instruction, next);
  if (is_new) nodes_.push_back(instruction);
  return {known->second, false};
}

SignedNode ValueGraph::constant(const Constant& constant) {
  return this->constant(scalar_ ? rounded(constant.value, *scalar_) : constant.value);
}

SignedNode ValueGraph::constant(const cln::cl_R& value) {
  const cln::cl_R magnitude = cln::abs(value);
  const auto next = static_cast<std::uint32_t>(constants_.size());
  const auto [known, is_new] = known_constants_.emplace(magnitude, next);
  if (is_new) constants_.push_back(magnitude);
  const SignedNode result = node({Opcode::constant, FunctionId::sin, known->second, 0});
  return cln::minusp(value) ? negated(result) : result;
}

SignedNode ValueGraph::leaf(Opcode opcode, std::uint32_t index) {
  return node({opcode, FunctionId::sin, index, 0});
}

SignedNode ValueGraph::binary(Opcode opcode, SignedNode x, SignedNode y) {
  const bool is_product = opcode == Opcode::multiply || opcode == Opcode::divide;
  const bool is_negative = is_product && x.is_negative != y.is_negative;
  if (is_product) x.is_negative = y.is_negative = false;
  const SignedNode result = node({opcode, FunctionId::sin, packed(x), packed(y)});
  return is_negative ? negated(result) : result;
}

SignedNode ValueGraph::square_root(SignedNode x) {
  return node({Opcode::square_root, FunctionId::sin, packed(x), 0});
}

SignedNode ValueGraph::call(FunctionId function, SignedNode x, SignedNode y) {
  const std::uint32_t second = function_row(function).arity > 1 ? packed(y) : 0;
  return node({Opcode::call, function, packed(x), second});
}

void ValueGraph::set_name(SignedNode value, const std::string& name) {
  names_.emplace(value.node, name);
}

std::pair<SignedNode, SignedNode> ValueGraph::difference(SignedNode x, SignedNode y) const {
  for (;;) {
    const Instruction& i = nodes_[x.node];
    const Instruction& j = nodes_[y.node];
    const bool is_alike = x.is_negative == y.is_negative && i.opcode == j.opcode &&
                          i.function == j.function && operand_count(i) > 0;
    const bool has_one = (i.a == j.a) != (i.b == j.b) || operand_count(i) == 1;
    if (!is_alike || !has_one) return {x, y};
    const bool is_first = i.a != j.a;
    x = unpacked(is_first ? i.a : i.b);
    y = unpacked(is_first ? j.a : j.b);
  }
}

std::string ValueGraph::text(const LeafNames& leaves, SignedNode value) const {
  const int depth = value.is_negative ? 1 : 0;
  const std::string whole = text(leaves, nodes_[value.node], depth);
  return value.is_negative ? "-" + whole : whole;
}

std::string ValueGraph::text(const LeafNames& leaves, SignedNode value, int depth) const {
  const auto name = names_.find(value.node);
  const std::string whole =
      name != names_.end() ? name->second : text(leaves, nodes_[value.node], depth);
  return value.is_negative ? "-" + whole : whole;
}

std::string ValueGraph::text(const LeafNames& leaves, const Instruction& i, int depth) const {
  const auto operand = [&](std::uint32_t of) { return text(leaves, unpacked(of), depth + 1); };
  if (is_leaf(i.opcode)) return code_text(leaves, i.opcode, i.a);
  if (i.opcode == Opcode::constant) return exact_text(constants_[i.a]);
  if (depth >= deepest_text) return "…";
  switch (i.opcode) {
    case Opcode::square_root:
      return fmt::format("sqrt({})", operand(i.a));
    case Opcode::call:
      return fmt::format("{}({}{})", function_row(i.function).name, operand(i.a),
                         operand_count(i) > 1 ? ", " + operand(i.b) : "");
    default:
      return bracketed(depth > 0,
                       fmt::format("{} {} {}", operand(i.a), sign_of(i.opcode), operand(i.b)));
  }
}

}  // namespace elgen
