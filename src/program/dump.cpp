// dump: Program -> its text form.
//
//     parameters m l
//     coordinates theta
//     function mass_matrix
//       0 = parameter m
//       1 = multiply 0 0  ; m_squared
//       result 1 1 = 1
#include <fmt/ranges.h>

#include "elgen/program.hpp"

namespace elgen {
namespace {

std::string list_line(std::string_view word, const std::vector<std::string>& names) {
  return names.empty() ? "" : fmt::format("{} {}\n", word, fmt::join(names, " "));
}

/// The line "positive m l": `word`, then the parameters with the assumption `wanted`; "" if none.
std::string assumption_line(std::string_view word, const LeafNames& leaves, Assumption wanted) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < leaves.parameters.size(); ++i) {
    if (assumption_of(leaves, i) == wanted) names.push_back(leaves.parameters[i]);
  }
  return list_line(word, names);
}

/// The text of a constant without spaces, because a constant is one word of its line.
std::string constant_text(const Constant& constant) {
  std::string text = text_of(constant.form);
  std::erase(text, ' ');
  return text;
}

std::string operation_text(const Program& program, const Instruction& instruction) {
  if (instruction.opcode == Opcode::call) {
    const FunctionRow& row = function_row(instruction.function);
    return row.arity == 1 ? fmt::format("{} {}", row.name, instruction.a)
                          : fmt::format("{} {} {}", row.name, instruction.a, instruction.b);
  }
  std::string text(opcode_row(instruction.opcode).name);
  const std::size_t operands = operand_count(instruction);
  if (operands > 0) text += fmt::format(" {}", instruction.a);
  if (operands > 1) text += fmt::format(" {}", instruction.b);
  if (instruction.opcode == Opcode::constant) {
    text += " " + constant_text(program.constants[instruction.a]);
  }
  const bool is_listed = is_leaf(instruction.opcode) && !is_single(instruction.opcode);
  if (is_listed) text += " " + leaf_of(program.leaves, instruction.opcode, instruction.a);
  return text;
}

std::string heading_line(const Function& function) {
  const OutputRow& row = output_row(function.kind);
  if (row.is_user_output || row.is_step) {
    const StepSpec step = function.step.value_or(StepSpec());
    std::string numbers =
        std::to_string(row.is_step ? static_cast<std::uint32_t>(step.method) : function.user);
    if (step.iterations > 0) numbers += fmt::format(" {}", step.iterations);
    if (step.composed_order > 0) numbers += fmt::format(" order {}", step.composed_order);
    if (step.projects) numbers += " projected";
    return fmt::format("function {} = {} {}\n", function.name, row.name, numbers);
  }
  if (row.name == function.name) return fmt::format("function {}\n", row.name);
  return fmt::format("function {} = {}\n", function.name, row.name);
}

std::string function_text(const Program& program, const Function& function) {
  std::string text = heading_line(function);
  for (std::size_t at = 0; at < function.instructions.size(); ++at) {
    text += fmt::format("  {} = {}", at, operation_text(program, function.instructions[at]));
    if (!function.names[at].empty()) text += fmt::format("  ; {}", function.names[at]);
    text += '\n';
  }
  if (function.repeated.count > 0) {
    text += fmt::format("  repeated {} {}\n", function.repeated.length, function.repeated.count);
  }
  for (const Field& field : function.fields) {
    text += fmt::format("  result {}{}{} {} = {}\n", field.name, field.name.empty() ? "" : " ",
                        field.rows, field.columns, fmt::join(field.entries, " "));
  }
  return text;
}

}  // namespace

std::string dump(const Program& program) {
  std::string text = list_line("parameters", program.leaves.parameters) +
                     assumption_line("positive", program.leaves, Assumption::positive) +
                     assumption_line("nonnegative", program.leaves, Assumption::nonnegative) +
                     list_line("open_values", program.leaves.f) +
                     list_line("coordinates", program.leaves.q);
  // Without rotations the velocities have the names of their coordinates.
  if (program.leaves.v != program.leaves.q) {
    text += list_line("velocities", program.leaves.v);
  }
  text += list_line("inputs", program.leaves.u);
  if (program.leaves.uses_time) text += "time\n";
  if (!program.leaves.momenta.empty()) text += "momenta\n";
  if (!program.leaves.h.empty()) text += "step\n";
  for (const Function& function : program.functions) text += function_text(program, function);
  return text;
}

}  // namespace elgen
