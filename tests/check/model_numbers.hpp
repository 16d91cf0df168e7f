// Evaluates expressions of a Model in double by recursion: value and rate along a motion.
#pragma once

#include <cln/float.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "elgen/model.hpp"
#include "elgen/references.hpp"
#include "support/text.hpp"

namespace elgen::test {

struct Moving {
  double value = 0;
  double rate = 0;
};

/// Evaluates expressions at q and v; accelerations are 0, t = 1/2, parameters as declared.
class ModelNumbers {
 public:
  ModelNumbers(const Model& model, std::vector<double> q, std::vector<double> v)
      : model_(model), q_(std::move(q)), v_(std::move(v)) {}

  [[nodiscard]] double value(ExpressionId id) const { return at(id).value; }

  template <class Ids>
  [[nodiscard]] std::vector<double> values(const Ids& ids) const {
    std::vector<double> result;
    for (const ExpressionId id : ids) result.push_back(value(id));
    return result;
  }

  /// Rotation (row-major) and origin of a frame, twelve numbers.
  [[nodiscard]] std::vector<double> pose(std::size_t frame) const {
    std::vector<double> result = values(model_.frames[frame].rotation);
    for (const double x : values(model_.frames[frame].origin)) result.push_back(x);
    return result;
  }

 private:
  [[nodiscard]] static double number(const cln::cl_R& value) { return cln::double_approx(value); }

  [[nodiscard]] Moving at(ExpressionId id) const {
    const Expression& e = model_.expressions[id];
    switch (e.kind) {
      case ExpressionKind::number:
        return {number(e.number), 0};
      case ExpressionKind::pi:
        return {std::acos(-1.0), 0};
      case ExpressionKind::leaf:
        if (e.leaf == Opcode::time) return {0.5, 1};
        if (e.leaf == Opcode::coordinate) return {q_.at(e.index), v_.at(e.index)};
        if (e.leaf == Opcode::velocity) return {v_.at(e.index), 0};
        return {number(model_.parameters[e.index].value), 0};
      case ExpressionKind::named:
        return at(*value_of_name(model_, e));
      case ExpressionKind::time_derivative:
        return {at(e.operands[0]).rate, 0};
      default:
        return operation(e);
    }
  }

  [[nodiscard]] Moving operation(const Expression& e) const {
    const Moving a = at(e.operands[0]);
    switch (e.kind) {
      case ExpressionKind::negate:
        return {-a.value, -a.rate};
      case ExpressionKind::add:
        return sum(e);
      case ExpressionKind::multiply:
        return product(e);
      case ExpressionKind::divide: {
        const Moving b = at(e.operands[1]);
        return {a.value / b.value, (a.rate * b.value - a.value * b.rate) / (b.value * b.value)};
      }
      case ExpressionKind::power: {
        const double n = number(e.number);
        return {std::pow(a.value, n), n * std::pow(a.value, n - 1) * a.rate};
      }
      case ExpressionKind::function:
        if (e.function == FunctionId::sin) return {std::sin(a.value), std::cos(a.value) * a.rate};
        if (e.function == FunctionId::cos) return {std::cos(a.value), -std::sin(a.value) * a.rate};
        [[fallthrough]];
      default:
        throw std::runtime_error("not an expression of these tests");
    }
  }

  [[nodiscard]] Moving sum(const Expression& e) const {
    Moving total;
    for (const ExpressionId id : e.operands) {
      const Moving term = at(id);
      total = {total.value + term.value, total.rate + term.rate};
    }
    return total;
  }

  [[nodiscard]] Moving product(const Expression& e) const {
    Moving total{1, 0};
    for (const ExpressionId id : e.operands) {
      const Moving factor = at(id);
      total = {total.value * factor.value, total.rate * factor.value + total.value * factor.rate};
    }
    return total;
  }

  const Model& model_;
  std::vector<double> q_;
  std::vector<double> v_;
};

/// Row-major rotation matrices, written independently of the program.
using Rotation3 = std::array<double, 9>;

inline Rotation3 about_x(double a) {
  return {1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a)};
}
inline Rotation3 about_y(double a) {
  return {std::cos(a), 0, std::sin(a), 0, 1, 0, -std::sin(a), 0, std::cos(a)};
}
inline Rotation3 about_z(double a) {
  return {std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1};
}

inline Rotation3 operator*(const Rotation3& a, const Rotation3& b) {
  Rotation3 result{};
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i] += a[i / 3 * 3 + k] * b[3 * k + i % 3];
  }
  return result;
}

using Triple = std::array<double, 3>;

inline Triple operator*(const Rotation3& r, const Triple& x) {
  Triple result{};
  for (std::size_t i = 0; i < 9; ++i) result[i / 3] += r[i] * x[i % 3];
  return result;
}

inline Triple operator+(const Triple& a, const Triple& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline std::vector<double> as_pose(const Rotation3& r, const Triple& p) {
  std::vector<double> result(r.begin(), r.end());
  result.insert(result.end(), p.begin(), p.end());
  return result;
}

inline bool close(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::fabs(a[i] - b[i]) < 1e-13)) return false;
  }
  return true;
}

inline std::vector<double> listed(const Triple& x) { return {x.begin(), x.end()}; }

/// A model with an angle q, a length s, parameters and an energy in fifteen lines; `entries` start
/// on line 16.
inline std::string with_frames(const std::string& entries) { return read_model("arm") + entries; }

/// A state of the model `with_frames`, and the value of the parameter l.
inline constexpr double q = 0.3;
inline constexpr double s = 0.8;
inline constexpr double l = 0.7;
inline constexpr double q_rate = 1.5;
inline constexpr double s_rate = -0.6;

}  // namespace elgen::test
