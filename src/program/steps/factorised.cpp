// L D L^T and its substitutions, value by value; Composition leaves out what is 0.
#include "program/steps/factorised.hpp"

#include <algorithm>
#include <numeric>

namespace elgen {

Factorised::Factorised(Composition& compose, const Model& model, const Places& mass)
    : compose_(compose), order_(model.velocities.size()) {
  const std::size_t n = order_.size();
  std::iota(order_.begin(), order_.end(), 0U);
  if (eliminates_last_first(model)) std::reverse(order_.begin(), order_.end());
  lower_.resize(n);
  std::vector<Places> unscaled(n);  // W = L D
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      std::uint32_t w = mass[order_[i] * n + order_[j]];
      for (std::size_t k = 0; k < j; ++k) w = less(w, lower_[j][k], unscaled[i][k]);
      unscaled[i].push_back(w);
      if (i == j) reciprocals_.push_back(compose_.add(Opcode::divide, compose_.number(1), w));
      if (i > j) lower_[i].push_back(compose_.add(Opcode::multiply, w, reciprocals_[j]));
    }
  }
}

/// value - x y
std::uint32_t Factorised::less(std::uint32_t value, std::uint32_t x, std::uint32_t y) {
  return compose_.add(Opcode::subtract, value, compose_.add(Opcode::multiply, x, y));
}

Places Factorised::solve(const Places& r) {
  const std::size_t n = order_.size();
  Places z;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint32_t value = r[order_[i]];
    for (std::size_t k = 0; k < i; ++k) value = less(value, lower_[i][k], z[k]);
    z.push_back(value);
  }
  Places x(n);
  for (std::size_t i = n; i-- > 0;) {
    std::uint32_t value = compose_.add(Opcode::multiply, z[i], reciprocals_[i]);
    for (std::size_t k = i + 1; k < n; ++k) value = less(value, lower_[k][i], x[order_[k]]);
    x[order_[i]] = value;
  }
  return x;
}

}  // namespace elgen
