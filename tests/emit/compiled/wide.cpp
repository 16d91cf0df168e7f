// Double-double: reads lines `function x.high x.low y.high y.low` and prints the high and the low
// part of each value. Functions are numbered as in functions.def, followed by + - * / and sqrt.
#include <cstdio>

#include "functions_code/functions_code_wide.hpp"

namespace {

namespace code = functions_code;
using Number = code::wide::Inner;

Number stumpff(const Number& x, const Number& k) {
  return code::detail::stumpff<Number>(x, static_cast<int>(static_cast<double>(k)));
}
Number sign(const Number& x) { return code::detail::sign_of<Number>(x); }
Number min(const Number& x, const Number& y) { return code::detail::smaller<Number>(x, y); }
Number max(const Number& x, const Number& y) { return code::detail::larger<Number>(x, y); }

#undef ELGEN_FUNCTION
#define ELGEN_CALL_1(name) name(x)
#define ELGEN_CALL_2(name) name(x, y)
#define ELGEN_FUNCTION(name, arity) \
  if (function == at++) return ELGEN_CALL_##arity(name);

Number value(int function, const Number& x, const Number& y) {
  int at = 0;
#include "elgen/functions.def"
  if (function == at++) return x + y;
  if (function == at++) return x - y;
  if (function == at++) return x * y;
  if (function == at++) return x / y;
  return sqrt(x);
}

/// True if SineCosine has the values of sin and cos.
bool has_sines_of_pairs(const Number& x) {
  const auto both = code::detail::SineCosine<Number>::of(x);
  return both.sine == sin(x) && both.cosine == cos(x);
}

/// True if the argument `x * y` is rounded before the function uses it, even if the compiler can
/// see the factors.
bool takes_products_as_rounded(double x, double y) {
  const code::Parameters<double> p{};
  const volatile double product = x * y;
  const auto hidden = code::wide::gravity(p, {0.0, product});
  const auto seen = code::wide::gravity(p, {0.0, x * y});
  return !(hidden[1] < seen[1]) && !(seen[1] < hidden[1]);
}

}  // namespace

int main() {
  int function = 0;
  Number x, y;
  bool is_right = true;
  while (std::scanf("%d %lf %lf %lf %lf", &function, &x.high, &x.low, &y.high, &y.low) == 5) {
    const Number result = value(function, x, y);
    std::printf("%a %a\n", result.high, result.low);
    is_right = is_right && has_sines_of_pairs(x) && takes_products_as_rounded(x.high, y.high);
  }
  return is_right ? 0 : 1;
}
