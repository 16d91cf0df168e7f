// Program: operand counts, sizes, operation counts, cost, and pruning. Pruning marks needed
// instructions backwards and renumbers them forwards.
#include "elgen/program.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace elgen {

std::size_t InstructionHash::operator()(const Instruction& i) const {
  const std::uint64_t operands = (std::uint64_t{i.a} << 32U) | i.b;
  const auto operation =
      static_cast<std::uint64_t>(i.opcode) * 64 + static_cast<std::uint64_t>(i.function);
  return (operands ^ (operation << 48U)) * 0x9E3779B97F4A7C15U;
}

std::size_t operand_count(const Instruction& instruction) {
  if (instruction.opcode == Opcode::call) return function_row(instruction.function).arity;
  return opcode_row(instruction.opcode).operands;
}

Instruction renumber_operands(Instruction instruction, const std::vector<std::uint32_t>& places) {
  const std::size_t operands = operand_count(instruction);
  if (operands > 0) instruction.a = places[instruction.a];
  if (operands > 1) instruction.b = places[instruction.b];
  return instruction;
}

std::size_t first_repeated_instruction(const Function& function) {
  const Repetition& repeated = function.repeated;
  return function.instructions.size() - std::size_t{repeated.length} * repeated.count;
}

bool is_call_of_numbers(const Function& function, const Instruction& instruction) {
  const auto is_number = [&](std::uint32_t at) {
    const Instruction& i = function.instructions[at];
    return (i.opcode == Opcode::negate ? function.instructions[i.a] : i).opcode == Opcode::constant;
  };
  const bool is_call =
      instruction.opcode == Opcode::call || instruction.opcode == Opcode::square_root;
  return is_call && is_number(instruction.a) &&
         (operand_count(instruction) == 1 || is_number(instruction.b));
}

std::size_t entry_count(const Function& function) {
  std::size_t count = 0;
  for (const Field& field : function.fields) count += field.entries.size();
  return count;
}

std::string index_text(const Field& field, std::size_t entry) {
  if (field.entries.size() == 1) return {};
  if (field.columns == 1) return fmt::format("[{}]", entry + 1);
  return fmt::format("[{},{}]", entry / field.columns + 1, entry % field.columns + 1);
}

std::vector<Constant> executed_constants(const Program& program) {
  std::vector<bool> is_executed(program.constants.size(), false);
  for (const Function& function : program.functions) {
    for (const Instruction& i : function.instructions) {
      if (i.opcode == Opcode::constant) is_executed[i.a] = true;
    }
  }
  std::vector<Constant> executed;
  for (std::size_t i = 0; i < is_executed.size(); ++i) {
    if (is_executed[i]) executed.push_back(program.constants[i]);
  }
  return executed;
}

std::vector<std::uint32_t> entries_of(const Function& function) {
  std::vector<std::uint32_t> entries;
  for (const Field& field : function.fields) {
    entries.insert(entries.end(), field.entries.begin(), field.entries.end());
  }
  return entries;
}

bool calls_function(const Program& program, FunctionId function) {
  return std::ranges::any_of(program.functions, [function](const Function& each) {
    return std::ranges::any_of(each.instructions, [function](const Instruction& i) {
      return i.opcode == Opcode::call && i.function == function;
    });
  });
}

bool has_pivots(const Function& function) {
  return std::ranges::find(function.fields, "relative_pivots", &Field::name) !=
         function.fields.end();
}

std::size_t first_entry_of(const Function& function, std::string_view field) {
  std::size_t first = 0;
  for (const Field& each : function.fields) {
    if (each.name == field) break;
    first += each.entries.size();
  }
  return first;
}

bool loads_zero(const Program& program, const Instruction& instruction) {
  return instruction.opcode == Opcode::constant &&
         cln::zerop(program.constants[instruction.a].value);
}

bool is_zero(const Program& program, const Function& function) {
  return std::ranges::all_of(entries_of(function), [&](std::uint32_t entry) {
    return loads_zero(program, function.instructions[entry]);
  });
}

int stumpff_order(const Program& program, const Function& function, std::uint32_t at) {
  const Instruction& i = function.instructions[at];
  if (i.opcode == Opcode::negate) return -stumpff_order(program, function, i.a);
  return cln::cl_I_to_int(cln::round1(program.constants[i.a].value));
}

std::vector<std::size_t> expanded_sizes(const Function& function, std::size_t most) {
  std::vector<std::size_t> sizes;
  for (const Instruction& i : function.instructions) {
    const std::size_t operands = operand_count(i);
    std::size_t size = operands > 0 ? 1 + sizes[i.a] : 0;
    if (operands > 1) size += sizes[i.b];
    sizes.push_back(std::min(size, most + 1));
  }
  return sizes;
}

OperationCounts count_operations(const Function& function) {
  OperationCounts counts;
  std::set<std::uint32_t> angles;
  for (const Instruction& instruction : function.instructions) {
    if (is_call_of_numbers(function, instruction)) continue;
    const FunctionId called = instruction.function;
    switch (instruction.opcode) {
      case Opcode::add:
      case Opcode::subtract:
        ++counts.add;
        break;
      case Opcode::multiply:
        ++counts.mul;
        break;
      case Opcode::divide:
        ++counts.div;
        break;
      case Opcode::square_root:
        ++counts.sqrt;
        break;
      case Opcode::call:
        if (is_circular(called)) {
          angles.insert(instruction.a);
        } else {
          ++counts.other;
        }
        break;
      case Opcode::constant:
      case Opcode::negate:
#define ELGEN_LEAVES(kind, ...) case Opcode::kind:
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
        break;
    }
  }
  counts.sincos = angles.size();
  return counts;
}

std::size_t cost(const OperationCounts& counts) {
  return counts.mul + counts.add + 4 * counts.div + 8 * counts.sqrt + 20 * counts.sincos +
         16 * counts.other;
}

std::vector<bool> needed_instructions(const Function& function,
                                      const std::vector<std::uint32_t>& wanted) {
  std::vector<bool> needed(function.instructions.size(), false);
  for (const std::uint32_t at : wanted) needed[at] = true;
  for (std::size_t at = needed.size(); at-- > 0;) {
    const Instruction& i = function.instructions[at];
    if (!needed[at]) continue;
    if (operand_count(i) > 0) needed[i.a] = true;
    if (operand_count(i) > 1) needed[i.b] = true;
  }
  return needed;
}

std::vector<std::uint32_t> dependency_cone(const Function& function,
                                           std::vector<std::uint32_t> wanted, std::size_t most) {
  std::vector<std::uint32_t> cone;
  std::ranges::make_heap(wanted);
  while (!wanted.empty() && cone.size() <= most) {
    std::ranges::pop_heap(wanted);
    const std::uint32_t at = wanted.back();
    wanted.pop_back();
    if (!cone.empty() && cone.back() == at) continue;
    cone.push_back(at);
    const Instruction& i = function.instructions[at];
    for (std::size_t k = 0; k < operand_count(i); ++k) {
      wanted.push_back(k == 0 ? i.a : i.b);
      std::ranges::push_heap(wanted);
    }
  }
  std::ranges::reverse(cone);
  return cone;
}

void merge_name(std::string& known, const std::string& name) {
  const bool gives_way =
      known.empty() || (known.front() == intermediate_mark && !name.starts_with(intermediate_mark));
  if (gives_way && !name.empty()) known = name;
}

namespace {

/// True if `order` ends with the repeated instructions in their old order.
bool keeps_repetitions(const Function& function, const std::vector<std::uint32_t>& order) {
  std::size_t old = function.instructions.size();
  const std::size_t size = old - first_repeated_instruction(function);
  if (order.size() < size) return false;
  return std::all_of(order.rbegin(), order.rbegin() + static_cast<std::ptrdiff_t>(size),
                     [&old](std::uint32_t at) { return at == --old; });
}

}  // namespace

Function reorder_instructions(const Function& function, const std::vector<std::uint32_t>& order) {
  Function result = function;
  if (!keeps_repetitions(function, order)) result.repeated = {};
  result.instructions.clear();
  result.names.clear();
  std::vector<std::uint32_t> renumbered(function.instructions.size());
  for (const std::uint32_t at : order) {
    const Instruction i = renumber_operands(function.instructions[at], renumbered);
    renumbered[at] = static_cast<std::uint32_t>(result.instructions.size());
    result.instructions.push_back(i);
    result.names.push_back(function.names[at]);
  }
  for (Field& field : result.fields) {
    for (std::uint32_t& entry : field.entries) entry = renumbered[entry];
  }
  return result;
}

Function eliminate_dead_code(const Function& function) {
  const std::vector<bool> needed = needed_instructions(function, entries_of(function));
  std::vector<std::uint32_t> order;
  for (std::uint32_t at = 0; at < needed.size(); ++at) {
    if (needed[at]) order.push_back(at);
  }
  return reorder_instructions(function, order);
}

Function with_entries(Function function, const std::vector<std::uint32_t>& entries) {
  function.fields = {{"", static_cast<std::uint32_t>(entries.size()), 1, entries}};
  return eliminate_dead_code(function);
}

}  // namespace elgen
