// Spelling: products, quotients and sums of texts.
#include "program/network/spelling.hpp"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <utility>

namespace elgen {
namespace {

using Begin = Spelling::Begin;
using End = Spelling::End;

constexpr std::size_t most_names = 4;

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> numbers{
    {{"1", "one"}, {"2", "two"}, {"3", "three"}, {"4", "four"}, {"1/2", "half"}}};

Spelling joined(Spelling a, std::string_view between, const Spelling& b, End end) {
  a.text.append(between).append(b.text);
  a.names += b.names;
  a.is_told = a.is_told || b.is_told;
  a.end = end;
  return a;
}

bool may_follow(const Spelling& b, const Spelling& a) {
  const bool is_call_after_call = a.end == End::call && b.begin == Begin::call;
  return b.begin != Begin::number && (a.end == End::name || is_call_after_call);
}

Spelling product(const Spelling& a, const Spelling& b) {
  if (a.end == End::sum || b.end == End::sum) return {};
  if (may_follow(b, a)) return joined(a, "_", b, b.end);
  return may_follow(a, b) ? joined(b, "_", a, a.end) : Spelling{};
}

Spelling quotient(const Spelling& a, const Spelling& b) {
  const bool is_plain = a.end < End::divisor && b.end < End::divisor && b.begin != Begin::number;
  return is_plain ? joined(a, "_over_", b, End::divisor) : Spelling{};
}

/// sin_a_minus_b is the sine of a - b.
Spelling difference(const Spelling& a, const Spelling& b) {
  const bool reads_otherwise = a.end == End::call || b.end == End::sum;
  return reads_otherwise ? Spelling{} : joined(a, "_minus_", b, End::sum);
}

/// "sin_half_theta"; sin_a_b is the sine of a + b.
Spelling called(std::string_view function, Spelling a) {
  if (a.end != End::name || a.names != 1) return {};
  a.text = fmt::format("{}_{}", function, a.text);
  a.begin = Begin::call;
  a.end = End::call;
  return a;
}

Spelling made(const Instruction& operation, const Spelling& a, const Spelling& b) {
  if (operation.opcode == Opcode::add) return joined(a, "_plus_", b, End::sum);
  if (operation.opcode == Opcode::subtract) return difference(a, b);
  if (operation.opcode == Opcode::multiply) return product(a, b);
  if (operation.opcode == Opcode::divide) return quotient(a, b);
  const bool is_call = operation.opcode == Opcode::call && operand_count(operation) == 1;
  return is_call ? called(function_row(operation.function).name, a) : Spelling{};
}

}  // namespace

Spelling spelt(const ConstantForm& form) {
  const std::string text = text_of(form);
  for (const auto& [number, word] : numbers) {
    if (number == text) return {.text = std::string(word), .names = 0, .begin = Begin::number};
  }
  return {};
}

Spelling spelt(const Instruction& operation, const Spelling& a, const Spelling& b) {
  if (a.text.empty() || b.text.empty()) return {};
  Spelling result = made(operation, a, b);
  return result.names <= most_names ? result : Spelling{};
}

}  // namespace elgen
