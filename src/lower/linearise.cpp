// linearise: see linearise.hpp. Value numbering makes sure that nothing is computed twice.
#include "lower/linearise.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace elgen {
namespace {

struct InstructionHash {
  std::size_t operator()(const Instruction& i) const {
    const std::uint64_t operands = (std::uint64_t{i.a} << 32U) | i.b;
    const auto operation =
        static_cast<std::uint64_t>(i.opcode) * 64 + static_cast<std::uint64_t>(i.function);
    return (operands ^ (operation << 48U)) * 0x9E3779B97F4A7C15U;
  }
};

class Linearising {
 public:
  Linearising(const Network& network, Program& program, Function& function)
      : network_(network), program_(program), function_(function) {
    done_.resize(network.operations.size());
  }

  std::uint32_t value(Ref ref) {
    std::vector<NodeId> pending = {ref.node};
    while (!pending.empty()) {
      const NodeId id = pending.back();
      const std::size_t before = pending.size();
      const std::vector<Ref>& operands = network_.operations[id].operands;
      for (std::size_t i = operands.size(); i-- > 0;) {
        if (!done_[operands[i].node]) pending.push_back(operands[i].node);
      }
      if (pending.size() > before) continue;
      pending.pop_back();
      if (!done_[id]) finish(id);
    }
    return signed_value(ref);
  }

 private:
  void finish(NodeId id) {
    const Operation& operation = network_.operations[id];
    const std::uint32_t result = emit_operation(operation);
    done_[id] = result;
    std::string& name = function_.names[result];
    if (name.empty()) name = operation.name;
  }

  std::uint32_t emit(const Instruction& instruction) {
    const auto next = static_cast<std::uint32_t>(function_.instructions.size());
    const auto [it, is_new] = numbers_.emplace(instruction, next);
    if (is_new) {
      function_.instructions.push_back(instruction);
      function_.names.emplace_back();
    }
    return it->second;
  }

  std::uint32_t signed_value(Ref ref) {
    const std::uint32_t magnitude = *done_[ref.node];
    return ref.negative ? emit({.opcode = Opcode::negate, .a = magnitude}) : magnitude;
  }

  std::uint32_t emit_operation(const Operation& operation) {
    switch (operation.kind) {
      case OperationKind::constant:
        return emit({.opcode = Opcode::constant, .a = constant(operation.index)});
      case OperationKind::leaf:
        return emit({.opcode = operation.leaf, .a = operation.index});
      case OperationKind::product:
        return product(operation);
      case OperationKind::quotient:
        return emit({.opcode = Opcode::divide,
                     .a = *done_[operation.operands[0].node],
                     .b = *done_[operation.operands[1].node]});
      case OperationKind::square_root:
        return emit({.opcode = Opcode::square_root, .a = signed_value(operation.operands[0])});
      case OperationKind::call:
        return call(operation);
      case OperationKind::sum:
        return sum(operation);
    }
    return 0;
  }

  std::uint32_t constant(std::uint32_t index) {
    return position_of(network_.constants[index], program_.constants);
  }

  std::uint32_t product(const Operation& operation) {
    std::uint32_t result = *done_[operation.operands[0].node];
    for (std::size_t i = 1; i < operation.operands.size(); ++i) {
      result =
          emit({.opcode = Opcode::multiply, .a = result, .b = *done_[operation.operands[i].node]});
    }
    return result;
  }

  std::uint32_t call(const Operation& operation) {
    Instruction instruction{.opcode = Opcode::call, .function = operation.function};
    instruction.a = signed_value(operation.operands[0]);
    if (operation.operands.size() > 1) instruction.b = signed_value(operation.operands[1]);
    return emit(instruction);
  }

  /// Starts from the first positive term, so that nothing needs to be negated where there is one.
  std::uint32_t sum(const Operation& operation) {
    const std::vector<Ref>& terms = operation.operands;
    auto start = std::find_if(terms.begin(), terms.end(), [](Ref term) { return !term.negative; });
    if (start == terms.end()) start = terms.begin();
    std::uint32_t result = signed_value(*start);
    for (auto term = terms.begin(); term != terms.end(); ++term) {
      if (term == start) continue;
      result = emit({.opcode = term->negative ? Opcode::subtract : Opcode::add,
                     .a = result,
                     .b = *done_[term->node]});
    }
    return result;
  }

  const Network& network_;
  Program& program_;
  Function& function_;
  std::vector<std::optional<std::uint32_t>> done_;
  std::unordered_map<Instruction, std::uint32_t, InstructionHash> numbers_;
};

}  // namespace

Function unfilled(const Function& function) {
  Function result{function.kind, function.user, function.name};
  result.sampled_zeros = function.sampled_zeros;
  std::uint32_t next = 0;
  for (const Field& field : function.fields) {
    Field& copy = result.fields.emplace_back(field);
    for (std::uint32_t& entry : copy.entries) entry = next++;
  }
  return result;
}

void linearise(const Network& network, Program& program, Function& function) {
  Linearising linearising(network, program, function);
  for (Field& field : function.fields) {
    for (std::uint32_t& entry : field.entries) entry = linearising.value(network.values[entry]);
  }
}

}  // namespace elgen
