// linearise: see linearise.hpp. Value numbering: nothing is computed twice.
#include "program/network/linearise.hpp"

#include <algorithm>
#include <optional>

#include "program/network/instructions.hpp"

namespace elgen {
namespace {

class Lineariser {
 public:
  Lineariser(const Network& network, Program& program, Function& function)
      : network_(network),
        program_(program),
        function_(function),
        emitted_(network.operations.size()),
        instructions_(function) {}

  std::uint32_t emit_value(SignedNode ref) {
    std::vector<NodeId> pending = {ref.node};
    while (!pending.empty()) {
      const NodeId id = pending.back();
      const std::size_t before = pending.size();
      const std::vector<SignedNode>& operands = network_.operations[id].operands;
      for (std::size_t i = operands.size(); i-- > 0;) {
        if (!emitted_[operands[i].node]) pending.push_back(operands[i].node);
      }
      if (pending.size() > before) continue;
      pending.pop_back();
      if (!emitted_[id]) emit_node(id);
    }
    return emit_signed_value(ref);
  }

 private:
  void emit_node(NodeId id) {
    const Operation& operation = network_.operations[id];
    const std::uint32_t result = emit_operation(operation);
    emitted_[id] = result;
    merge_name(function_.names[result], operation.name);
  }

  std::uint32_t emit_signed_value(SignedNode ref) {
    const std::uint32_t magnitude = *emitted_[ref.node];
    return ref.is_negative ? instructions_.add(Opcode::negate, magnitude) : magnitude;
  }

  std::uint32_t emit_operation(const Operation& operation) {
    switch (operation.kind) {
      case OperationKind::constant:
        return instructions_.add(Opcode::constant, constant_index(operation.index));
      case OperationKind::leaf:
        return instructions_.add(operation.leaf, operation.index);
      case OperationKind::product:
        return emit_product(operation);
      case OperationKind::quotient:
        return instructions_.add(Opcode::divide, *emitted_[operation.operands[0].node],
                                 *emitted_[operation.operands[1].node]);
      case OperationKind::square_root:
        return instructions_.add(Opcode::square_root, emit_signed_value(operation.operands[0]));
      case OperationKind::call:
        return emit_call(operation);
      case OperationKind::sum:
        return emit_sum(operation);
    }
    return 0;
  }

  std::uint32_t constant_index(std::uint32_t index) {
    return intern_constant(network_.constants[index], program_.constants);
  }

  std::uint32_t emit_product(const Operation& operation) {
    std::uint32_t result = *emitted_[operation.operands[0].node];
    for (std::size_t i = 1; i < operation.operands.size(); ++i) {
      result = instructions_.add(Opcode::multiply, result, *emitted_[operation.operands[i].node]);
    }
    return result;
  }

  std::uint32_t emit_call(const Operation& operation) {
    Instruction instruction{.opcode = Opcode::call, .function = operation.function};
    instruction.a = emit_signed_value(operation.operands[0]);
    if (operation.operands.size() > 1) instruction.b = emit_signed_value(operation.operands[1]);
    return instructions_.add(instruction);
  }

  /// Starts with the first positive term, so that only an all-negative sum needs a negation.
  std::uint32_t emit_sum(const Operation& operation) {
    const std::vector<SignedNode>& terms = operation.operands;
    auto start =
        std::find_if(terms.begin(), terms.end(), [](SignedNode term) { return !term.is_negative; });
    if (start == terms.end()) start = terms.begin();
    std::uint32_t result = emit_signed_value(*start);
    for (auto term = terms.begin(); term != terms.end(); ++term) {
      if (term == start) continue;
      result = instructions_.add(term->is_negative ? Opcode::subtract : Opcode::add, result,
                                 *emitted_[term->node]);
    }
    return result;
  }

  const Network& network_;
  Program& program_;
  Function& function_;
  std::vector<std::optional<std::uint32_t>> emitted_;
  InstructionBuilder instructions_;
};

}  // namespace

Function without_instructions(const Function& function) {
  Function result = without_body(function);
  result.sampled_zeros = function.sampled_zeros;
  result.elimination_order = function.elimination_order;
  std::uint32_t next = 0;
  for (const Field& field : function.fields) {
    Field& copy = result.fields.emplace_back(field);
    for (std::uint32_t& entry : copy.entries) entry = next++;
  }
  return result;
}

void linearise(const Network& network, Program& program, Function& function) {
  Lineariser linearising(network, program, function);
  for (Field& field : function.fields) {
    for (std::uint32_t& entry : field.entries)
      entry = linearising.emit_value(network.values[entry]);
  }
}

LinearisedNetwork::LinearisedNetwork(const Network& network) {
  Field& field = function.fields.emplace_back();
  field.rows = static_cast<std::uint32_t>(network.values.size());
  for (std::uint32_t i = 0; i < field.rows; ++i) field.entries.push_back(i);
  linearise(network, program, function);
}

}  // namespace elgen
