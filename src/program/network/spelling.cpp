// OperandName: names of products, quotients and sums from the names of their operands.
#include "program/network/spelling.hpp"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <utility>

namespace elgen {
namespace {

using Begin = OperandName::Begin;
using End = OperandName::End;

constexpr std::size_t most_names = 4;

OperandName join_names(OperandName a, std::string_view between, const OperandName& b, End end) {
  a.text.append(between).append(b.text);
  a.names += b.names;
  a.has_intermediate = a.has_intermediate || b.has_intermediate;
  a.end = end;
  return a;
}

bool can_append(const OperandName& b, const OperandName& a) {
  const bool is_call_after_call = a.end == End::call && b.begin == Begin::call;
  return b.begin != Begin::number && (a.end == End::name || is_call_after_call);
}

OperandName product_name(const OperandName& a, const OperandName& b) {
  if (a.end == End::sum || b.end == End::sum) return {};
  if (can_append(b, a)) return join_names(a, "_", b, b.end);
  return can_append(a, b) ? join_names(b, "_", a, a.end) : OperandName{};
}

OperandName quotient_name(const OperandName& a, const OperandName& b) {
  const bool is_plain = a.end < End::divisor && b.end < End::divisor && b.begin != Begin::number;
  return is_plain ? join_names(a, "_over_", b, End::divisor) : OperandName{};
}

/// "a_minus_b"; none if a ends with a call or b is a sum: sin_a_minus_b reads as sin(a - b).
OperandName difference_name(const OperandName& a, const OperandName& b) {
  const bool reads_otherwise = a.end == End::call || b.end == End::sum;
  return reads_otherwise ? OperandName{} : join_names(a, "_minus_", b, End::sum);
}

/// "sin_half_theta". The argument must be one name, because sin_a_b reads as sin(a + b).
OperandName call_name(std::string_view function, OperandName a) {
  if (a.end != End::name || a.names != 1) return {};
  a.text = fmt::format("{}_{}", function, a.text);
  a.begin = Begin::call;
  a.end = End::call;
  return a;
}

OperandName operation_name(const Instruction& operation, const OperandName& a,
                           const OperandName& b) {
  if (operation.opcode == Opcode::add) return join_names(a, "_plus_", b, End::sum);
  if (operation.opcode == Opcode::subtract) return difference_name(a, b);
  if (operation.opcode == Opcode::multiply) return product_name(a, b);
  if (operation.opcode == Opcode::divide) return quotient_name(a, b);
  const bool is_call = operation.opcode == Opcode::call && operand_count(operation) == 1;
  return is_call ? call_name(function_row(operation.function).name, a) : OperandName{};
}

}  // namespace

OperandName spell_name(const ConstantForm& form) {
  static const std::array<std::pair<cln::cl_RA, const char*>, 5> numbers{
      {{1, "one"}, {2, "two"}, {3, "three"}, {4, "four"}, {cln::cl_RA(1) / 2, "half"}}};
  if (form.kind != ConstantKind::rational) return {};
  for (const auto& [number, word] : numbers) {
    if (form.number == number) return {.text = word, .names = 0, .begin = Begin::number};
  }
  return {};
}

OperandName spell_name(const Instruction& operation, const OperandName& a, const OperandName& b) {
  if (a.text.empty() || b.text.empty()) return {};
  OperandName result = operation_name(operation, a, b);
  return result.names <= most_names ? result : OperandName{};
}

}  // namespace elgen
