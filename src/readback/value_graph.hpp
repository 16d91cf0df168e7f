// ValueGraph: what expressions stand for. Two expressions are one node where they do the same
// operations on the same operands in the same order, up to a minus moved through products:
//
//     -(a*b)   -a * b   a * -b     ->   one node with a sign
//     a*b + c  c + a*b             ->   two nodes
#pragma once

#include <cln/real.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// A node, or what it stands for with the other sign.
struct SignedNode {
  std::uint32_t node = 0;
  bool is_negative = false;
  friend bool operator==(const SignedNode&, const SignedNode&) = default;
};

[[nodiscard]] SignedNode negated(SignedNode x);

/// A domain of fold.hpp.
class ValueGraph {
 public:
  /// Constants of the program are rounded to the one scalar of a file, where it has one.
  explicit ValueGraph(std::optional<ScalarKind> scalar = {}) : scalar_(scalar) {}

  [[nodiscard]] SignedNode constant(const Constant& constant);
  [[nodiscard]] SignedNode constant(const cln::cl_R& value);
  [[nodiscard]] SignedNode leaf(Opcode opcode, std::uint32_t index);
  /// add, subtract, multiply or divide
  [[nodiscard]] SignedNode binary(Opcode opcode, SignedNode x, SignedNode y);
  [[nodiscard]] SignedNode add(SignedNode x, SignedNode y) { return binary(Opcode::add, x, y); }
  [[nodiscard]] SignedNode subtract(SignedNode x, SignedNode y) {
    return binary(Opcode::subtract, x, y);
  }
  [[nodiscard]] SignedNode multiply(SignedNode x, SignedNode y) {
    return binary(Opcode::multiply, x, y);
  }
  [[nodiscard]] SignedNode divide(SignedNode x, SignedNode y) {
    return binary(Opcode::divide, x, y);
  }
  [[nodiscard]] static SignedNode negate(SignedNode x) { return negated(x); }
  [[nodiscard]] SignedNode square_root(SignedNode x);
  /// y is ignored by functions of one argument.
  [[nodiscard]] SignedNode call(FunctionId function, SignedNode x, SignedNode y);

  /// From now on text() writes the name where the value is an operand.
  void set_name(SignedNode value, const std::string& name);
  /// The innermost operands in which they differ, if that is one of each.
  [[nodiscard]] std::pair<SignedNode, SignedNode> difference(SignedNode x, SignedNode y) const;
  /// For messages: "t_1*cos(q[1])"; what is nested deeply is left out.
  [[nodiscard]] std::string text(const LeafNames& leaves, SignedNode value) const;

 private:
  struct Less {
    [[nodiscard]] bool operator()(const cln::cl_R& x, const cln::cl_R& y) const { return x < y; }
  };

  [[nodiscard]] SignedNode node(const Instruction& instruction);
  [[nodiscard]] std::string text(const LeafNames& leaves, SignedNode value, int depth) const;
  [[nodiscard]] std::string text(const LeafNames& leaves, const Instruction& i, int depth) const;

  std::optional<ScalarKind> scalar_;
  std::vector<Instruction> nodes_;  ///< operands: twice the node, plus 1 for a minus
  std::unordered_map<Instruction, std::uint32_t, InstructionHash> known_;
  std::vector<cln::cl_R> constants_;
  std::map<cln::cl_R, std::uint32_t, Less> known_constants_;
  std::unordered_map<std::uint32_t, std::string> names_;
};

}  // namespace elgen
