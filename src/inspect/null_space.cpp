// Gauss-Jordan elimination on scaled rows; columns without a pivot span the null space.
#include "inspect/null_space.hpp"

#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// Sixty digits are right; ten of them may have cancelled.
const cl_R& vanishing_share() {
  static const cl_R share = power_of_ten(-50);
  return share;
}

struct Elimination {
  std::vector<Vector> rows = {};
  std::vector<std::size_t> pivot_columns = {};  ///< of the first rows
};

Elimination scaled_rows(const Vector& matrix, const Vector& scales) {
  const std::size_t columns = matrix.size() / scales.size();
  Elimination e;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    Vector row(columns, cl_R(0));
    for (std::size_t j = 0; j < columns && !cln::zerop(scales[i]); ++j) {
      row[j] = matrix[i * columns + j] / scales[i];
    }
    e.rows.push_back(row);
  }
  return e;
}

std::size_t largest_below(const Elimination& e, std::size_t column) {
  std::size_t best = e.pivot_columns.size();
  for (std::size_t i = best; i < e.rows.size(); ++i) {
    if (cln::abs(e.rows[i][column]) > cln::abs(e.rows[best][column])) best = i;
  }
  return best;
}

void subtract(Vector& row, const Vector& other, const cl_R& factor) {
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = row[j] - factor * other[j];
}

/// Makes `column` a unit column if it holds a pivot.
void eliminate(Elimination& e, std::size_t column) {
  const std::size_t next = e.pivot_columns.size();
  if (next == e.rows.size()) return;
  const std::size_t best = largest_below(e, column);
  if (cln::abs(e.rows[best][column]) < vanishing_share()) return;
  std::swap(e.rows[next], e.rows[best]);
  const cl_R pivot = e.rows[next][column];
  for (cl_R& entry : e.rows[next]) entry = entry / pivot;
  for (std::size_t i = 0; i < e.rows.size(); ++i) {
    if (i != next) subtract(e.rows[i], e.rows[next], cl_R(e.rows[i][column]));
  }
  e.pivot_columns.push_back(column);
}

}  // namespace

const cl_R& rounding_share() {
  static const cl_R share = power_of_ten(-80);
  return share;
}

Vector row_scales(const Vector& matrix, std::size_t n) {
  Vector scales(n, cl_R(0));
  cl_R largest = 0;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    scales[k / n] = cln::max(scales[k / n], cln::abs(matrix[k]));
    largest = cln::max(largest, scales[k / n]);
  }
  for (cl_R& scale : scales) {
    if (scale < rounding_share() * largest) scale = 0;
  }
  return scales;
}

std::vector<Vector> null_space(const Vector& matrix, const Vector& row_scales) {
  const std::size_t columns = matrix.size() / row_scales.size();
  Elimination e = scaled_rows(matrix, row_scales);
  std::vector<std::size_t> free_columns;
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t rank = e.pivot_columns.size();
    eliminate(e, column);
    if (e.pivot_columns.size() == rank) free_columns.push_back(column);
  }
  std::vector<Vector> basis;
  for (const std::size_t column : free_columns) {
    Vector x(columns, cl_R(0));
    x[column] = 1;
    for (std::size_t i = 0; i < e.pivot_columns.size(); ++i) {
      x[e.pivot_columns[i]] = -e.rows[i][column];
    }
    basis.push_back(x);
  }
  return basis;
}

}  // namespace elgen
