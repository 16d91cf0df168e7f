// function_formulas: writes the formula of one instruction. The operands in this formula are names,
// or formulas with brackets if needed.
#include "emit/code/function_formulas.hpp"

#include <algorithm>

#include "elgen/fold.hpp"

namespace elgen {

/// The rules of fold.hpp for operands that are given by index.
class FunctionFormulas::Rules {
 public:
  Rules(const FunctionFormulas& all, std::uint32_t at)
      : all_(all), at_(at), vocabulary_(all.vocabulary_of(at)) {}

  [[nodiscard]] std::uint32_t operator[](std::uint32_t operand) const { return operand; }

  [[nodiscard]] FormulaText constant(const Constant& constant) const {
    return vocabulary_.constant(constant);
  }
  [[nodiscard]] FormulaText leaf(Opcode kind, std::uint32_t number) const {
    return {vocabulary_.leaf(kind, number)};
  }
  [[nodiscard]] FormulaText add(std::uint32_t x, std::uint32_t y) const {
    return sum_text({{operand_text(x)}, {operand_text(y)}});
  }
  [[nodiscard]] FormulaText subtract(std::uint32_t x, std::uint32_t y) const {
    return sum_text({{operand_text(x)}, {operand_text(y), true}});
  }
  [[nodiscard]] FormulaText multiply(std::uint32_t x, std::uint32_t y) const {
    return product_text(code_spelling, {operand_text(x), operand_text(y)});
  }
  [[nodiscard]] FormulaText divide(std::uint32_t x, std::uint32_t y) const {
    return quotient_text(code_spelling, operand_text(x), operand_text(y));
  }
  [[nodiscard]] FormulaText negate(std::uint32_t x) const { return negation_text(operand_text(x)); }
  [[nodiscard]] FormulaText square_root(std::uint32_t x) const {
    return vocabulary_.square_root(operand_text(x));
  }
  /// The call of `function`. The k of stumpff(x, k) is an integer literal in all languages.
  [[nodiscard]] FormulaText call(FunctionId function, std::uint32_t x, std::uint32_t y) const {
    std::vector<FormulaText> arguments = {operand_text(x)};
    if (function == FunctionId::stumpff) {
      arguments.push_back({std::to_string(stumpff_order(all_.program_, all_.function_, y))});
    } else if (function_row(function).arity > 1) {
      arguments.push_back(operand_text(y));
    }
    return vocabulary_.call(function, arguments);
  }

 private:
  [[nodiscard]] FormulaText operand_text(std::uint32_t at) const {
    return all_.operand_formula(at_, at);
  }

  const FunctionFormulas& all_;
  std::uint32_t at_;
  const Vocabulary& vocabulary_;
};

FormulaText FunctionFormulas::name_or_formula(std::uint32_t at) const {
  return names_[at].empty() ? formula(at) : FormulaText{names_[at]};
}

FormulaText FunctionFormulas::operand_formula(std::uint32_t user, std::uint32_t at) const {
  const Vocabulary& words = vocabulary_of(user);
  const Instruction& i = function_.instructions[at];
  FormulaText text = name_or_formula(at);
  if (i.opcode == Opcode::constant && names_[at].empty()) {
    text = words.constant(program_.constants[i.a]);
  } else if (&words != &vocabulary_of(at)) {
    text = words.convert_scalar(text);
  }
  const bool is_argument = is_call_of_numbers(function_, function_.instructions[user]);
  return is_argument ? words.at_run_time(text) : text;
}

const Vocabulary& FunctionFormulas::vocabulary_of(std::uint32_t at) const {
  const bool is_inner =
      function_.instructions[at].is_inner && vocabulary_.inner_vocabulary() != nullptr;
  return is_inner ? *vocabulary_.inner_vocabulary() : vocabulary_;
}

FormulaText FunctionFormulas::formula(std::uint32_t at) const {
  const Rules rules(*this, at);
  return fold_instruction(rules, program_, function_.instructions[at], rules);
}

}  // namespace elgen
