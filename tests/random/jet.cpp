// Jets: arithmetic term by term. Functions use their Taylor series about the constant part; it is
// finite, because the other parts are nilpotent.
#include "random/jet.hpp"

#include <boost/math/constants/constants.hpp>
#include <cstdlib>
#include <stdexcept>

namespace elgen::test::random {

namespace {

constexpr unsigned infinitesimals = 64;  ///< the number of subsets of six infinitesimals

/// Taylor coefficients of sin at x; of cos if called with (cosine, -sine).
std::vector<Number> circular(const Number& sine, const Number& cosine, int count) {
  std::vector<Number> series;
  Number factorial = 1;
  for (int j = 0; j <= count; ++j) {
    if (j > 0) factorial *= j;
    const Number derivative = j % 2 == 0 ? sine : cosine;
    series.push_back((j % 4 < 2 ? derivative : -derivative) / factorial);
  }
  return series;
}

std::vector<Number> exponential(const Number& x, int count) {
  std::vector<Number> series{exp(x)};
  for (int j = 1; j <= count; ++j) series.push_back(series.back() / j);
  return series;
}

/// Coefficients in h of y = p^exponent, p = p0 + p1 h + p2 h^2, from p y' = exponent p' y.
std::vector<Number> quadratic_power(const std::vector<Number>& p, const Number& exponent,
                                    const Number& start, int count) {
  std::vector<Number> y{start};
  for (int j = 1; j <= count; ++j) {
    Number sum = 0;
    for (int i = 1; i <= 2 && i <= j; ++i) {
      sum += (exponent * i - (j - i)) * p[static_cast<std::size_t>(i)] *
             y[static_cast<std::size_t>(j - i)];
    }
    y.push_back(sum / (j * p[0]));
  }
  return y;
}

std::vector<Number> integrated(const std::vector<Number>& series, const Number& constant) {
  std::vector<Number> result{constant};
  for (std::size_t j = 0; j < series.size(); ++j) {
    result.push_back(series[j] / static_cast<int>(j + 1));
  }
  return result;
}

Jet real_power(const Jet& base, const Number& exponent, const Number& start) {
  const Number x = base.value();
  return composed(base, quadratic_power({x, 1, 0}, exponent, start, terms_needed(base)));
}

Jet logarithm(const Jet& x) {
  if (x.value() <= 0) throw std::domain_error("log");
  const auto slope = quadratic_power({x.value(), 1, 0}, -1, 1 / x.value(), terms_needed(x));
  return composed(x, integrated(slope, log(x.value())));
}

Jet arc_tangent(const Jet& x) {
  const Number start = 1 + x.value() * x.value();
  const auto slope = quadratic_power({start, 2 * x.value(), 1}, -1, 1 / start, terms_needed(x));
  return composed(x, integrated(slope, atan(x.value())));
}

Jet arc_sine(const Jet& x) {
  const Number start = 1 - x.value() * x.value();
  if (start <= 0) throw std::domain_error("asin");
  const auto slope = quadratic_power({start, -2 * x.value(), -1}, Number(-1) / 2, 1 / sqrt(start),
                                     terms_needed(x));
  return composed(x, integrated(slope, asin(x.value())));
}

/// atan2(y, x) = atan2(y0, x0) + the angle between (x0, y0) and (x, y).
Jet polar_angle(const Jet& y, const Jet& x) {
  const Number y0 = y.value();
  const Number x0 = x.value();
  if (x0 == 0 && y0 == 0) throw std::domain_error("atan2");
  return Jet(atan2(y0, x0)) + arc_tangent((y * x0 - x * y0) / (x * x0 + y * y0));
}

int sign_of(const Jet& x) { return x.value() > 0 ? 1 : x.value() < 0 ? -1 : 0; }

Jet sine(const Jet& x, bool of_complement) {
  const Number s = sin(x.value());
  const Number c = cos(x.value());
  return composed(
      x, of_complement ? circular(c, -s, terms_needed(x)) : circular(s, c, terms_needed(x)));
}

Jet exponential(const Jet& x) { return composed(x, exponential(x.value(), terms_needed(x))); }

/// sinh(x), cosh(x) or tanh(x), from e^x and e^-x.
Jet hyperbolic(std::string_view function, const Jet& x) {
  const Jet up = exponential(x);
  const Jet down = exponential(-x);
  if (function == "sinh") return (up - down) / 2;
  if (function == "cosh") return (up + down) / 2;
  return (up - down) / (up + down);
}

/// sum_i (-1)^i x^(2 i)/(2 i + k)! by Horner's rule with k = |order|; no signs if `order` < 0.
Jet stumpff(const Jet& x, int order) {
  const int k = std::abs(order);
  const Jet square = order < 0 ? x * x : -(x * x);
  const int terms = 50 + 4 * static_cast<int>(abs(x.value()));  // later terms are below 1e-90
  Jet sum = 1;
  for (int n = k + 2 * terms; n > k; n -= 2) sum = Jet(1) + sum * square / (n * (n - 1));
  for (int n = k; n > 1; --n) sum = sum / n;
  return sum;
}

Jet extremum(std::string_view function, const Jet& x, const Jet& y) {
  return (function == "min") == (x.value() < y.value()) ? x : y;
}

}  // namespace

int Jet::order = 0;

const Number& pi() {
  static const Number value = boost::math::constants::pi<Number>();
  return value;
}

Jet::Jet(const Number& value) {
  if (value != 0) terms_.emplace(0U, value);
}

Jet Jet::infinitesimal(unsigned index) {
  Jet result;
  result.terms_.emplace(1U << index, 1);
  return result;
}

Jet Jet::scale() {
  Jet result;
  if (order > 0) result.terms_.emplace(infinitesimals, 1);
  return result;
}

Number Jet::value() const {
  const auto constant = terms_.find(0U);
  return constant == terms_.end() ? Number(0) : constant->second;
}

Jet Jet::along(unsigned index) const {
  Jet result;
  for (const auto& [key, number] : terms_) {
    if ((key >> index & 1U) != 0) result.terms_.emplace(key & ~(1U << index), number);
  }
  return result;
}

Jet Jet::without(unsigned index) const {
  Jet result;
  for (const auto& [key, number] : terms_) {
    if ((key >> index & 1U) == 0) result.terms_.emplace(key, number);
  }
  return result;
}

Jet Jet::up_to(int highest) const {
  Jet result;
  for (const auto& [key, number] : terms_) {
    if (static_cast<int>(key / infinitesimals) > highest) continue;
    result.terms_[key % infinitesimals] += number;
  }
  return result;
}

Jet& Jet::operator+=(const Jet& other) {
  for (const auto& [key, number] : other.terms_) terms_[key] += number;
  return *this;
}

Jet& Jet::operator-=(const Jet& other) {
  for (const auto& [key, number] : other.terms_) terms_[key] -= number;
  return *this;
}

/// The highest power of the non-constant part that can be non-zero.
int Jet::nilpotency() const {
  unsigned bits = 0;
  bool scaled = false;
  for (const auto& [key, number] : terms_) {
    bits |= key % infinitesimals;
    scaled = scaled || key >= infinitesimals;
  }
  return __builtin_popcount(bits) + (scaled ? order : 0);
}

int terms_needed(const Jet& x) { return x.nilpotency(); }

Jet operator+(Jet a, const Jet& b) { return a += b; }
Jet operator-(Jet a, const Jet& b) { return a -= b; }
Jet operator-(const Jet& a) { return Jet() - a; }

Jet operator*(const Jet& a, const Jet& b) {
  Jet result;
  for (const auto& [left, x] : a.terms_) {
    for (const auto& [right, y] : b.terms_) {
      const bool vanishes =
          (left & right & (infinitesimals - 1)) != 0 ||
          static_cast<int>(left / infinitesimals + right / infinitesimals) > Jet::order;
      if (!vanishes) result.terms_[left + right] += x * y;
    }
  }
  return result;
}

Jet operator/(const Jet& a, const Jet& b) {
  if (b.value() == 0) throw std::domain_error("division by zero");
  return a * real_power(b, -1, 1 / b.value());
}

/// sum_j series_j (x - x0)^j by Horner's rule, with the constant part x0 of `x`.
Jet composed(const Jet& x, const std::vector<Number>& series) {
  Jet rest = x;
  rest.terms_.erase(0U);
  Jet result;
  for (int j = terms_needed(x); j >= 0; --j) {
    result = result * rest + Jet(series[static_cast<std::size_t>(j)]);
  }
  return result;
}

Jet power(const Jet& base, int numerator, int denominator) {
  if (denominator == 1 && numerator >= 0) {
    Jet result = 1;
    for (int i = 0; i < numerator; ++i) result = result * base;
    return result;
  }
  if (denominator == 1) return Jet(1) / power(base, -numerator, 1);
  if (base.value() <= 0) throw std::domain_error("root");
  const Number exponent = Number(numerator) / denominator;
  return real_power(base, exponent, pow(base.value(), exponent));
}

Jet call(std::string_view function, const std::vector<Jet>& arguments) {
  const Jet& x = arguments.at(0);
  if (function == "sin") return sine(x, false);
  if (function == "cos") return sine(x, true);
  if (function == "tan") return sine(x, false) / sine(x, true);
  if (function == "exp") return exponential(x);
  if (function == "log") return logarithm(x);
  if (function == "log1p") return logarithm(Jet(1) + x);
  if (function == "asinh") return logarithm(x + power(x * x + Jet(1), 1, 2));
  if (function == "expm1") return exponential(x) - Jet(1);
  if (function == "sqrt") return power(x, 1, 2);
  if (function == "hypot") return power(x * x + arguments.at(1) * arguments.at(1), 1, 2);
  if (function == "stumpff") return stumpff(x, static_cast<int>(arguments.at(1).value()));
  if (function == "asin") return arc_sine(x);
  if (function == "acos") return Jet(pi() / 2) - arc_sine(x);
  if (function == "atan") return arc_tangent(x);
  if (function == "atan2") return polar_angle(x, arguments.at(1));
  if (function == "abs") return x * sign_of(x);
  if (function == "sign") return sign_of(x);
  if (function == "min" || function == "max") return extremum(function, x, arguments.at(1));
  if (function == "sinh" || function == "cosh" || function == "tanh")
    return hyperbolic(function, x);
  throw std::logic_error("no function " + std::string(function));
}

Vector along(const Vector& x, unsigned index) {
  Vector result;
  for (const Jet& entry : x) result.push_back(entry.along(index));
  return result;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Jet dot(const Vector& a, const Vector& b) {
  Jet sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Matrix product(const Matrix& a, const Matrix& b) {
  const Matrix columns = transposed(b);
  Matrix result;
  for (const Vector& row : a) {
    result.emplace_back();
    for (const Vector& column : columns) result.back().push_back(dot(row, column));
  }
  return result;
}

Vector product(const Matrix& a, const Vector& b) {
  Vector result;
  for (const Vector& row : a) result.push_back(dot(row, b));
  return result;
}

Matrix transposed(const Matrix& a) {
  Matrix result(a.empty() ? 0 : a[0].size());
  for (const Vector& row : a) {
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  }
  return result;
}

}  // namespace elgen::test::random
