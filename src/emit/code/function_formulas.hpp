// function_formulas: instructions of a Function -> formulas of code, as they are executed.
//
//     2 = multiply 0 0; 3 = multiply 1 2; 4 = cos 3        cos(m * (x * x))
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "formula/formula_text.hpp"

namespace elgen {

/// The names of a language for the leaves, constants and functions of a program.
class Vocabulary {
 public:
  virtual ~Vocabulary() = default;

  /// A parameter, coordinate, …, or time.
  [[nodiscard]] virtual std::string leaf(Opcode kind, std::uint32_t number) const = 0;
  [[nodiscard]] virtual FormulaText constant(const Constant& constant) const = 0;
  [[nodiscard]] virtual FormulaText square_root(const FormulaText& radicand) const = 0;
  [[nodiscard]] virtual FormulaText call(FunctionId function,
                                         const std::vector<FormulaText>& arguments) const = 0;

  /// The words for inner instructions; null where they are written as all others.
  [[nodiscard]] virtual const Vocabulary* inner() const { return nullptr; }
  /// A value of the other instructions as a number of these.
  [[nodiscard]] virtual FormulaText converted(const FormulaText& value) const { return value; }
};

class FunctionFormulas {
 public:
  /// `names` says which instructions are referred to by name.
  FunctionFormulas(const Program& program, const Function& function, const Vocabulary& vocabulary,
                   const std::vector<std::string>& names)
      : program_(program), function_(function), vocabulary_(vocabulary), names_(names) {}

  /// The instruction itself, even where it has a name.
  [[nodiscard]] FormulaText definition(std::uint32_t at) const;
  /// Its name, where it has one.
  [[nodiscard]] FormulaText entry(std::uint32_t at) const;
  /// The same as an operand of an instruction.
  [[nodiscard]] FormulaText operand(std::uint32_t user, std::uint32_t at) const;

 private:
  class Rules;

  [[nodiscard]] const Vocabulary& vocabulary_of(std::uint32_t at) const;

  const Program& program_;
  const Function& function_;
  const Vocabulary& vocabulary_;
  const std::vector<std::string>& names_;
};

}  // namespace elgen
