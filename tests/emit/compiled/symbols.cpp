// Calls an emitted header with nodes of expressions as the scalar type. As for casadi::SXElem, a
// node is made from a double, a comparison gives an expression, there is no conversion to bool, and
// std::numeric_limits has no digits. The expressions must have the values of the same functions in
// double.
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace expressions {

class Symbol {
 public:
  using Value = std::function<double(double theta)>;

  Symbol() : Symbol(std::nan("")) {}
  Symbol(double number) : value_(std::make_shared<Value>([number](double) { return number; })) {}
  explicit Symbol(Value value) : value_(std::make_shared<Value>(std::move(value))) {}
  static Symbol theta() {
    return Symbol(Value([](double theta) { return theta; }));
  }

  double at(double theta) const { return (*value_)(theta); }
  explicit operator double() const { return at(0); }

  Symbol operator-() const {
    return Symbol(Value([x = *this](double theta) { return -x.at(theta); }));
  }

 private:
  std::shared_ptr<Value> value_;
};

template <class Operation>
Symbol made(const Operation& operation, const Symbol& x, const Symbol& y) {
  return Symbol(Symbol::Value(
      [operation, x, y](double theta) { return operation(x.at(theta), y.at(theta)); }));
}
template <class Operation>
Symbol made(const Operation& operation, const Symbol& x) {
  return Symbol(Symbol::Value([operation, x](double theta) { return operation(x.at(theta)); }));
}

inline Symbol operator+(const Symbol& x, const Symbol& y) {
  return made(std::plus<double>(), x, y);
}
inline Symbol operator-(const Symbol& x, const Symbol& y) {
  return made(std::minus<double>(), x, y);
}
inline Symbol operator*(const Symbol& x, const Symbol& y) {
  return made(std::multiplies<double>(), x, y);
}
inline Symbol operator/(const Symbol& x, const Symbol& y) {
  return made(std::divides<double>(), x, y);
}
inline Symbol sin(const Symbol& x) {
  return made([](double number) { return std::sin(number); }, x);
}
inline Symbol cos(const Symbol& x) {
  return made([](double number) { return std::cos(number); }, x);
}
// Comparisons return expressions, so that no branch can depend on them.
inline Symbol operator<(const Symbol& x, const Symbol& y) {
  return made(std::less<double>(), x, y);
}
inline Symbol operator>(const Symbol& x, const Symbol& y) { return y < x; }
inline Symbol operator==(const Symbol& x, const Symbol& y) {
  return made(std::equal_to<double>(), x, y);
}

}  // namespace expressions

using expressions::Symbol;

template <>
class std::numeric_limits<Symbol> {
 public:
  static const bool is_specialized = true;
  static const int digits = 0;
  static const int digits10 = 0;
  static const bool is_signed = false;
  static const bool is_integer = false;
  static const bool is_exact = false;
  static const bool is_bounded = false;
  static Symbol epsilon() noexcept { return Symbol(0); }
};

#include "cart_pole/cart_pole.hpp"

namespace {

constexpr double angle = 0.75;
int failures = 0;

template <class Entries, class Numbers>
void compare(const char* name, const Entries& entries, const Numbers& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::abs(entries[i].at(angle) - numbers[i]) <= 1e-14 * (1 + std::abs(numbers[i]))) continue;
    ++failures;
    std::printf("%s[%zu]: %.17g instead of %.17g\n", name, i, entries[i].at(angle), numbers[i]);
  }
}

}  // namespace

int main() {
  const cart_pole::Parameters<double> p;
  const cart_pole::Coordinates<double> q{0.5, angle};
  const cart_pole::Velocities<double> v{0.25, -1.5};
  const cart_pole::Inputs<double> u{2.0};
  const cart_pole::Parameters<Symbol> parameters;
  const cart_pole::Coordinates<Symbol> place{0.5, Symbol::theta()};
  const cart_pole::Velocities<Symbol> rates{0.25, -1.5};
  const cart_pole::Inputs<Symbol> inputs{2.0};
  const auto [a, pivots] = cart_pole::forward_dynamics<Symbol>(parameters, place, rates, inputs);
  const auto numbers = cart_pole::forward_dynamics<double>(p, q, v, u);
  compare("acceleration", a, numbers.acceleration);
  compare("relative_pivots", pivots, numbers.relative_pivots);
  compare("mass_matrix", cart_pole::mass_matrix<Symbol>(parameters, place),
          cart_pole::mass_matrix<double>(p, q));
  compare("bias", cart_pole::bias<Symbol>(parameters, place, rates),
          cart_pole::bias<double>(p, q, v));
  compare("inverse_dynamics",
          cart_pole::inverse_dynamics<Symbol>(parameters, place, rates, {1.0, 2.0}),
          cart_pole::inverse_dynamics<double>(p, q, v, {1.0, 2.0}));
  const auto linear = cart_pole::linearization<Symbol>(parameters, place, rates, inputs);
  const auto linear_numbers = cart_pole::linearization<double>(p, q, v, u);
  compare("A", linear.A, linear_numbers.A);
  compare("B", linear.B, linear_numbers.B);
  const auto all = cart_pole::dynamics<Symbol>(parameters, place, rates);
  compare("momentum", all.momentum, cart_pole::momentum<double>(p, q, v));
  return failures == 0 ? 0 : 1;
}
