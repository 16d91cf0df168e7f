// The interpreter: evaluates the instructions of a Function in order, in any scalar type.
//
// Cost: one operation of Scalar per instruction. Scalar needs + - * /, unary minus, a
// specialisation of ScalarTraits, and, declared in its namespace, sqrt and the functions of
// functions.def. They are found by argument-dependent lookup. Programs that call abs, sign, min or
// max also need operator<.
#pragma once

#include <cmath>
#include <vector>

#include "elgen/fold.hpp"
#include "elgen/leaves.hpp"
#include "elgen/real.hpp"

namespace elgen {

template <class Scalar>
using Arguments = LeafValues<Scalar>;

namespace interpreter {

template <class Scalar>
[[nodiscard]] Scalar call(FunctionId function, const Scalar& x, const Scalar& y) {
  switch (function) {
#define ELGEN_CALL_1(name) name(x)
#define ELGEN_CALL_2(name) name(x, y)
#define ELGEN_FUNCTION(name, arity) \
  case FunctionId::name:            \
    return ELGEN_CALL_##arity(name);
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_CALL_1
#undef ELGEN_CALL_2
  }
  return x;
}

/// The rules by which fold() computes in Scalar; the leaves have the values in `arguments`.
template <class Scalar>
struct NumberRules {
  const Arguments<Scalar>& arguments;

  [[nodiscard]] Scalar constant(const Constant& constant) const {
    return ScalarTraits<Scalar>::from_real(constant.value);
  }
  [[nodiscard]] Scalar leaf(Opcode kind, std::uint32_t number) const {
    return leaf_of(arguments, kind, number);
  }
  [[nodiscard]] Scalar negate(const Scalar& x) const { return -x; }
  [[nodiscard]] Scalar add(const Scalar& x, const Scalar& y) const { return x + y; }
  [[nodiscard]] Scalar subtract(const Scalar& x, const Scalar& y) const { return x - y; }
  [[nodiscard]] Scalar multiply(const Scalar& x, const Scalar& y) const { return x * y; }
  [[nodiscard]] Scalar divide(const Scalar& x, const Scalar& y) const { return x / y; }
  [[nodiscard]] Scalar square_root(const Scalar& x) const {
    using std::sqrt;
    return sqrt(x);
  }
  [[nodiscard]] Scalar call(FunctionId function, const Scalar& x, const Scalar& y) const {
    return interpreter::call(function, x, y);
  }
};

}  // namespace interpreter

/// The values of all instructions of `function`, in order. `arguments` must contain every leaf that
/// the instructions load.
template <class Scalar>
[[nodiscard]] std::vector<Scalar> evaluate_instructions(const Program& program,
                                                        const Function& function,
                                                        const Arguments<Scalar>& arguments) {
  return fold<Scalar>(interpreter::NumberRules<Scalar>{arguments}, program, function);
}

/// The values of the entries of all fields of `function`, field by field, row-major.
template <class Scalar>
[[nodiscard]] std::vector<Scalar> evaluate(const Program& program, const Function& function,
                                           const Arguments<Scalar>& arguments) {
  return entries_of(function, evaluate_instructions(program, function, arguments));
}

}  // namespace elgen
