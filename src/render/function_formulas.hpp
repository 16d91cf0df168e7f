// function_formulas: instructions of a Function -> formulas, in the words of a language.
//
//     2 = multiply 0 0; 3 = multiply 1 2; 4 = cos 3
//
//     as read          cos(m*x^2)           products of many factors, with powers
//     as executed      cos(m * (x * x))     where the language has no powers
#pragma once

#include <string>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "model/formula.hpp"

namespace elgen {

/// The names of a language for the leaves, constants and functions of a program.
class Vocabulary {
 public:
  explicit Vocabulary(const Spelling& spelling) : spelling_(spelling) {}
  virtual ~Vocabulary() = default;

  [[nodiscard]] const Spelling& spelling() const { return spelling_; }
  /// A parameter, coordinate, …, or time.
  [[nodiscard]] virtual std::string leaf(Opcode kind, std::uint32_t number) const = 0;
  /// The symbols of definitions that have these names; "" stays.
  [[nodiscard]] virtual std::vector<std::string> definitions(std::vector<std::string> names) const {
    return names;
  }
  [[nodiscard]] virtual Formula constant(const Constant& constant) const;
  [[nodiscard]] virtual Formula square_root(const Formula& radicand) const;
  [[nodiscard]] virtual Formula call(FunctionId function,
                                     const std::vector<Formula>& arguments) const;

  /// The words for inner instructions; null where they are written as all others.
  [[nodiscard]] virtual const Vocabulary* inner() const { return nullptr; }
  /// A value of the other instructions as a number of these.
  [[nodiscard]] virtual Formula converted(const Formula& value) const { return value; }

 private:
  const Spelling& spelling_;
};

class FunctionFormulas {
 public:
  /// `names` says which instructions are referred to by name.
  FunctionFormulas(const Program& program, const Function& function, const Vocabulary& vocabulary,
                   const std::vector<std::string>& names)
      : program_(program), function_(function), vocabulary_(vocabulary), names_(names) {}

  /// The instruction itself, even where it has a name.
  [[nodiscard]] Formula definition(std::uint32_t at) const;
  /// Its name, where it has one.
  [[nodiscard]] Formula entry(std::uint32_t at) const;
  /// The same as an operand of an instruction.
  [[nodiscard]] Formula operand(std::uint32_t user, std::uint32_t at) const;

 private:
  class Rules;

  [[nodiscard]] const Vocabulary& vocabulary_of(std::uint32_t at) const;

  const Program& program_;
  const Function& function_;
  const Vocabulary& vocabulary_;
  const std::vector<std::string>& names_;
};

/// A formula in the model language and in LaTeX, for products and sums with others.
struct ReadFormula {
  Formula text = {};
  Formula latex = {};
};
/// The first entry of readable[0], written out.
[[nodiscard]] ReadFormula first_entry(const Model& model, const Program& program);

}  // namespace elgen
