// Products of exact matrices.
#pragma once

#include <cstddef>
#include <vector>

namespace elgen::test {

/// A B, row-major; `inner` is the number of columns of A.
template <class Number>
std::vector<Number> product(const std::vector<Number>& a, const std::vector<Number>& b,
                            std::size_t inner) {
  const std::size_t rows = a.size() / inner;
  const std::size_t columns = b.size() / inner;
  std::vector<Number> result(rows * columns, Number(0));
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      Number& sum = result[i * columns + j];
      for (std::size_t k = 0; k < inner; ++k) sum = sum + a[i * inner + k] * b[k * columns + j];
    }
  }
  return result;
}

}  // namespace elgen::test
