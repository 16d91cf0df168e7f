// call_slopes: an operand that carries its arithmetic, so that the laws of functions.def can be
// written over it as they are over numbers.
#include "present/call_slopes.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

struct ArithmeticValue {
  Arithmetic* arithmetic;
  Value value;

  friend ArithmeticValue operator+(const ArithmeticValue& x, const ArithmeticValue& y) {
    return {x.arithmetic, x.arithmetic->add(x.value, y.value)};
  }
  friend ArithmeticValue operator-(const ArithmeticValue& x) {
    return {x.arithmetic, x.arithmetic->negate(x.value)};
  }
  friend ArithmeticValue operator-(const ArithmeticValue& x, const ArithmeticValue& y) {
    return x + (-y);
  }
  friend ArithmeticValue operator*(const ArithmeticValue& x, const ArithmeticValue& y) {
    return {x.arithmetic, x.arithmetic->multiply(x.value, y.value)};
  }
  friend ArithmeticValue operator*(const ArithmeticValue& x, int factor) {
    return {x.arithmetic, x.arithmetic->multiply(x.value, fraction_of(cl_RA(factor)))};
  }
  friend ArithmeticValue operator/(const ArithmeticValue& x, const ArithmeticValue& y) {
    return {x.arithmetic, x.arithmetic->divide(x.value, y.value)};
  }
};

ArithmeticValue sqrt(const ArithmeticValue& x) {
  return {x.arithmetic, x.arithmetic->square_root(x.value)};
}

ArithmeticValue called(FunctionId function, const ArithmeticValue& x) {
  return {x.arithmetic, x.arithmetic->call(function, x.value, {})};
}
ArithmeticValue sin(const ArithmeticValue& x) { return called(FunctionId::sin, x); }
ArithmeticValue cos(const ArithmeticValue& x) { return called(FunctionId::cos, x); }
ArithmeticValue sinh(const ArithmeticValue& x) { return called(FunctionId::sinh, x); }
ArithmeticValue cosh(const ArithmeticValue& x) { return called(FunctionId::cosh, x); }

/// By the first and the second argument.
std::vector<ArithmeticValue> slopes(FunctionId function, const ArithmeticValue& x,
                                    const ArithmeticValue& y, const ArithmeticValue& f) {
  const ArithmeticValue one{f.arithmetic, fraction_of(cl_RA(1))};
  switch (function) {
#define ELGEN_FUNCTION(name, arity, use, parity, smoothness, first, second) \
  case FunctionId::name:                                                    \
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
  const ArithmeticValue x{&arithmetic, atom.arguments.front()};
  const ArithmeticValue y{&arithmetic, atom.arguments.back()};
  const std::vector<ArithmeticValue> all = slopes(atom.function, x, y, {&arithmetic, call});
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = all[i].value;
  return result;
}

}  // namespace elgen
