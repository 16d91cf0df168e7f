// write: converts sums of products to instructions. Pages keep the order of terms and factors.
#pragma once

#include <map>

#include "elgen/program.hpp"
#include "forms/typeset/arrange.hpp"
#include "program/network/instructions.hpp"

namespace elgen {

/// Writes sums as instructions of `function`, and may add constants to `program`. Named values of
/// the model keep their names in the function.
class TextbookWriter {
 public:
  TextbookWriter(const Model& model, const Algebra& algebra, const TypedForms& typed,
                 Program& program, Function& function)
      : arranger(algebra, typed),
        model_(model),
        algebra_(algebra),
        typed_(typed),
        program_(program),
        function_(function),
        instructions_(function) {}

  Arranger arranger;  ///< also arranges angles and arguments

  [[nodiscard]] std::uint32_t operator()(const TextbookSum& sum);
  /// Copies an instruction from another function of the program, with its operands.
  [[nodiscard]] std::uint32_t copy_instruction(const Function& function, std::uint32_t instruction);
  /// Names divisors that at least two written products share: Delta, or Delta_1, …
  void name_shared_divisors();

 private:
  [[nodiscard]] std::uint32_t write_product(const TextbookProduct& product);
  [[nodiscard]] std::uint32_t write_factor(const TextbookFactor& factor);
  [[nodiscard]] std::uint32_t write_circular_call(FunctionId function, const Monomial& angle);
  [[nodiscard]] std::uint32_t write_angle(const Monomial& parts);
  [[nodiscard]] TextbookSum arrange_angle(const Fraction& argument);
  [[nodiscard]] std::uint32_t write_atom(AtomId id);
  [[nodiscard]] std::uint32_t write_new_atom(AtomId id);
  [[nodiscard]] std::uint32_t write_number(const cln::cl_RA& value);

  const Model& model_;
  const Algebra& algebra_;
  const TypedForms& typed_;
  Program& program_;
  Function& function_;
  InstructionBuilder instructions_;
  std::map<AtomId, std::uint32_t> atoms_ = {};                   ///< memoised, as arguments nest
  std::map<Monomial, std::uint32_t, MonomialLess> angles_ = {};  ///< memoised
  std::map<std::uint32_t, std::size_t> divisors_ = {};           ///< divisor -> number of uses
};

}  // namespace elgen
