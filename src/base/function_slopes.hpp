// function_slopes: the derivatives of function_derivatives.def in any arithmetic.
#pragma once

#include <array>

#include "elgen/functions.hpp"

namespace elgen {

/// The derivatives of a function by its first and its second argument. `f` is the value of the
/// function at (x, y). Operand needs + - * /, products with an int, sqrt(x), and
/// called(FunctionId, x, y), which calls a function.
template <class Operand>
[[nodiscard]] std::array<Operand, 2> function_slopes(FunctionId function, const Operand& x,
                                                     const Operand& y, const Operand& f,
                                                     const Operand& one) {
  // NOLINTBEGIN(bugprone-macro-parentheses): the macros declare the name.
#define ELGEN_CALL_1(name)                                   \
  [[maybe_unused]] const auto name = [](const Operand& of) { \
    return called(FunctionId::name, of, of);                 \
  };
#define ELGEN_CALL_2(name)                                                      \
  [[maybe_unused]] const auto name = [](const Operand& of, const Operand& by) { \
    return called(FunctionId::name, of, by);                                    \
  };
  // NOLINTEND(bugprone-macro-parentheses)
#define ELGEN_FUNCTION(name, arity) ELGEN_CALL_##arity(name)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
#undef ELGEN_CALL_1
#undef ELGEN_CALL_2
  switch (function) {
#define ELGEN_DERIVATIVES(name, arity, first, second) \
  case FunctionId::name:                              \
    return {first, second};
#include "base/function_derivatives.def"
#undef ELGEN_DERIVATIVES
  }
  return {one * 0, one * 0};
}

}  // namespace elgen
