// present: a Program, run on closed forms instead of numbers.
//
//     0 = sin theta   1 = multiply 0 0   2 = cos theta   3 = multiply 2 2   4 = add 1 3   ->   1
#include <algorithm>

#include "arithmetic.hpp"
#include "elgen/closed_forms.hpp"

namespace elgen {

using presenting::Arithmetic;
using presenting::Value;

namespace {

Value step(Arithmetic& arithmetic, const Program& program, const Instruction& i,
           const std::vector<Value>& values) {
  switch (i.opcode) {
    case Opcode::constant:
      return arithmetic.constant(program.constants[i.a].form);
    case Opcode::negate:
      return arithmetic.negate(values[i.a]);
    case Opcode::add:
      return arithmetic.add(values[i.a], values[i.b]);
    case Opcode::subtract:
      return arithmetic.add(values[i.a], arithmetic.negate(values[i.b]));
    case Opcode::multiply:
      return arithmetic.multiply(values[i.a], values[i.b]);
    case Opcode::divide:
      return arithmetic.divide(values[i.a], values[i.b]);
    case Opcode::square_root:
      return arithmetic.square_root(values[i.a]);
    case Opcode::call:
      if (function_row(i.function).arity == 1) return arithmetic.call(i.function, {values[i.a]});
      return arithmetic.call(i.function, {values[i.a], values[i.b]});
    default:
      return arithmetic.leaf(i.opcode, i.opcode == Opcode::time ? 0 : i.a);
  }
}

ClosedFunction run(Arithmetic& arithmetic, const Program& program, const Function& function) {
  std::vector<Value> values;
  values.reserve(function.instructions.size());
  for (const Instruction& i : function.instructions) {
    values.push_back(step(arithmetic, program, i, values));
  }
  ClosedFunction closed;
  for (const Field& field : function.fields) {
    ClosedField& entries = closed.fields.emplace_back(ClosedField{field.name, {}});
    for (const std::uint32_t entry : field.entries) entries.entries.push_back(values[entry]);
  }
  return closed;
}

/// Long programs are those whose closed forms outgrow them: beyond `short_program` instructions the
/// budget falls with the square of the length, so that trying costs less than lowering did.
std::size_t budget_of(const Function& function, const PresentBudget& budget) {
  constexpr double short_program = 500;
  const double length = std::max(static_cast<double>(function.instructions.size()), short_program);
  const double share = short_program / length;
  return static_cast<std::size_t>(static_cast<double>(budget.products_per_function) * share *
                                  share);
}

}  // namespace

ClosedForms present(const Program& program, const PresentBudget& budget) {
  ClosedForms forms;
  std::size_t left = budget.products;
  for (const Function& function : program.functions) {
    if (function.kind == OutputKind::dynamics) {
      forms.functions.emplace_back();
      continue;
    }
    const std::size_t share = std::min(left, budget_of(function, budget));
    std::size_t work = share;
    Arithmetic arithmetic(forms.algebra, work, budget.terms);
    forms.functions.push_back(run(arithmetic, program, function));
    left -= share - work;
  }
  return forms;
}

bool proved_equal(ClosedForms& forms, const Fraction& x, const Fraction& y) {
  const PresentBudget budget;
  std::size_t work = budget.products_per_function;
  Arithmetic arithmetic(forms.algebra, work, budget.terms);
  const Value difference = arithmetic.add(x, arithmetic.negate(y));
  return difference && difference->numerator.empty();
}

}  // namespace elgen
