// function_formulas: one walk over the operands, whatever the language.
#include "render/function_formulas.hpp"

#include <algorithm>

#include "lower/constant_formula.hpp"

namespace elgen {

Formula Vocabulary::constant(const Constant& constant) const {
  return constant_formula(spelling_, constant.form);
}

Formula Vocabulary::square_root(const Formula& radicand) const {
  return elgen::square_root(spelling_, radicand);
}

Formula Vocabulary::call(FunctionId function, const std::vector<Formula>& arguments) const {
  return elgen::call(spelling_, function, arguments);
}

Formula FunctionFormulas::entry(std::uint32_t at) const {
  return names_[at].empty() ? definition(at) : Formula{names_[at]};
}

Formula FunctionFormulas::definition(std::uint32_t at) const {
  const Spelling& spelling = vocabulary_.spelling();
  const Instruction& i = function_.instructions[at];
  switch (i.opcode) {
    case Opcode::constant:
      return vocabulary_.constant(program_.constants[i.a]);
    case Opcode::negate:
      return negation(i.a);
    case Opcode::add:
    case Opcode::subtract:
      return sum(spelling, {{entry(i.a)}, {entry(i.b), i.opcode == Opcode::subtract}});
    case Opcode::multiply:
      return product_of(i);
    case Opcode::divide:
      return quotient(spelling, entry(i.a), entry(i.b));
    case Opcode::square_root:
      return vocabulary_.square_root(entry(i.a));
    case Opcode::call:
      return call(i);
    default:
      return {vocabulary_.leaf(i)};
  }
}

/// As read, the sign of a constant is its own.
Formula FunctionFormulas::negation(std::uint32_t operand) const {
  const Instruction& i = function_.instructions[operand];
  const Spelling& spelling = vocabulary_.spelling();
  const bool is_constant = i.opcode == Opcode::constant && spelling.has_powers();
  if (!is_constant) return negated(spelling, entry(operand));
  const Constant& constant = program_.constants[i.a];
  return vocabulary_.constant({-constant.value, elgen::negated(constant.form)});
}

/// The factors of nested products that are written out, left to right.
void FunctionFormulas::collect_factors(std::uint32_t at,
                                       std::vector<std::uint32_t>& factors) const {
  const Instruction& i = function_.instructions[at];
  if (i.opcode != Opcode::multiply || !names_[at].empty()) {
    factors.push_back(at);
    return;
  }
  collect_factors(i.a, factors);
  collect_factors(i.b, factors);
}

Formula FunctionFormulas::product_of(const Instruction& i) const {
  const Spelling& spelling = vocabulary_.spelling();
  return spelling.has_powers() ? product_of_powers(i) : product(spelling, {entry(i.a), entry(i.b)});
}

Formula FunctionFormulas::product_of_powers(const Instruction& i) const {
  const Spelling& spelling = vocabulary_.spelling();
  std::vector<std::uint32_t> all;
  collect_factors(i.a, all);
  collect_factors(i.b, all);
  std::vector<Formula> different;
  for (auto factor = all.begin(); factor != all.end(); ++factor) {
    if (std::find(all.begin(), factor, *factor) != factor) continue;
    Formula base = entry(*factor);
    if (base.binding == Binding::negation) base = at_least(spelling, base, Binding::product);
    const long exponent = std::count(all.begin(), all.end(), *factor);
    different.push_back(exponent == 1 ? base : power(spelling, base, number(spelling, exponent)));
  }
  return product(spelling, different);
}

Formula FunctionFormulas::call(const Instruction& i) const {
  std::vector<Formula> arguments = {entry(i.a)};
  if (operand_count(i) > 1) arguments.push_back(entry(i.b));
  return vocabulary_.call(i.function, arguments);
}

}  // namespace elgen
