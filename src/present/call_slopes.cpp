// call_slopes: an operand that carries its arithmetic, so that the laws of functions.def can be
// written over it as they are over numbers.
#include "call_slopes.hpp"

namespace elgen::presenting {
namespace {

using cln::cl_RA;

struct Operand {
  Arithmetic* arithmetic;
  Value value;

  friend Operand operator+(const Operand& x, const Operand& y) {
    return {x.arithmetic, x.arithmetic->add(x.value, y.value)};
  }
  friend Operand operator-(const Operand& x) {
    return {x.arithmetic, x.arithmetic->negate(x.value)};
  }
  friend Operand operator-(const Operand& x, const Operand& y) { return x + (-y); }
  friend Operand operator*(const Operand& x, const Operand& y) {
    return {x.arithmetic, x.arithmetic->multiply(x.value, y.value)};
  }
  friend Operand operator*(const Operand& x, int factor) {
    return {x.arithmetic, x.arithmetic->multiply(x.value, fraction_of(cl_RA(factor)))};
  }
  friend Operand operator/(const Operand& x, const Operand& y) {
    return {x.arithmetic, x.arithmetic->divide(x.value, y.value)};
  }
};

Operand sqrt(const Operand& x) { return {x.arithmetic, x.arithmetic->square_root(x.value)}; }

Operand called(FunctionId function, const Operand& x) {
  return {x.arithmetic, x.arithmetic->call(function, x.value, {})};
}
Operand sin(const Operand& x) { return called(FunctionId::sin, x); }
Operand cos(const Operand& x) { return called(FunctionId::cos, x); }
Operand sinh(const Operand& x) { return called(FunctionId::sinh, x); }
Operand cosh(const Operand& x) { return called(FunctionId::cosh, x); }

/// By the first and the second argument.
std::vector<Operand> slopes(FunctionId function, const Operand& x, const Operand& y,
                            const Operand& f) {
  const Operand one{f.arithmetic, fraction_of(cl_RA(1))};
  switch (function) {
#define ELGEN_FUNCTION(name, arity, use, parity, first, second) \
  case FunctionId::name:                                        \
    return {first, second};
#include "elgen/functions.def"
#undef ELGEN_FUNCTION
  }
  return {};
}

}  // namespace

std::vector<Value> call_slopes(Arithmetic& arithmetic, const Atom& atom, const Fraction& call) {
  std::vector<Value> result(atom.arguments.size());
  if (is_kinked(atom.function)) return result;
  const Operand x{&arithmetic, atom.arguments.front()};
  const Operand y{&arithmetic, atom.arguments.back()};
  const std::vector<Operand> all = slopes(atom.function, x, y, {&arithmetic, call});
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = all[i].value;
  return result;
}

}  // namespace elgen::presenting
