// function_formulas: instructions of a Function -> formulas of code with the same operations.
//
//     2 = multiply 0 0; 3 = multiply 1 2; 4 = cos 3        cos(m * (x * x))
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "formula/formula_text.hpp"

namespace elgen {

/// Writes the leaves, constants and functions of a program in a language.
class Vocabulary {
 public:
  virtual ~Vocabulary() = default;

  /// "q[1]": a parameter, coordinate, …, or the time.
  [[nodiscard]] virtual std::string leaf(Opcode kind, std::uint32_t number) const = 0;
  [[nodiscard]] virtual FormulaText constant(const Constant& constant) const = 0;
  [[nodiscard]] virtual FormulaText square_root(const FormulaText& radicand) const = 0;
  [[nodiscard]] virtual FormulaText call(FunctionId function,
                                         const std::vector<FormulaText>& arguments) const = 0;
  /// A number as the argument of a function. The text hides the number from compilers, because they
  /// may round the value of the function differently from the library.
  [[nodiscard]] virtual FormulaText at_run_time(const FormulaText& number) const { return number; }

  /// The vocabulary of instructions with `is_inner`; null if all instructions use this vocabulary.
  [[nodiscard]] virtual const Vocabulary* inner_vocabulary() const { return nullptr; }
  /// `value` in the number type of this vocabulary. `value` is a formula of inner_vocabulary(), or
  /// of the vocabulary whose inner_vocabulary() is this vocabulary.
  [[nodiscard]] virtual FormulaText convert_scalar(const FormulaText& value) const { return value; }
};

class FunctionFormulas {
 public:
  /// `names`: one per instruction. An instruction with an empty name is written out at each use.
  FunctionFormulas(const Program& program, const Function& function, const Vocabulary& vocabulary,
                   const std::vector<std::string>& names)
      : program_(program), function_(function), vocabulary_(vocabulary), names_(names) {}

  /// The formula of the instruction, even if it has a name.
  [[nodiscard]] FormulaText formula(std::uint32_t at) const;
  /// The name of the instruction, or its formula if it has no name.
  [[nodiscard]] FormulaText name_or_formula(std::uint32_t at) const;
  /// name_or_formula(at) as an operand of the instruction `user`, converted if the two instructions
  /// have different vocabularies.
  [[nodiscard]] FormulaText operand_formula(std::uint32_t user, std::uint32_t at) const;

 private:
  class Rules;

  [[nodiscard]] const Vocabulary& vocabulary_of(std::uint32_t at) const;

  const Program& program_;
  const Function& function_;
  const Vocabulary& vocabulary_;
  const std::vector<std::string>& names_;
};

}  // namespace elgen
