// Doubles of matrices in 64 digits.
#include "analyse/linear_equations.hpp"

#include <Eigen/LU>

#include "elgen/evaluate.hpp"

namespace elgen {

std::vector<double> doubles_of(const std::vector<cln::cl_R>& values) {
  std::vector<double> result;
  for (const cln::cl_R& value : values) result.push_back(ScalarTraits<double>::from_real(value));
  return result;
}

Eigen::MatrixXd matrix_of(const std::vector<cln::cl_R>& values, std::size_t rows) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const std::vector<double> numbers = doubles_of(values);
  const auto r = static_cast<Eigen::Index>(rows);
  const Eigen::Index c = rows == 0 ? 0 : static_cast<Eigen::Index>(numbers.size() / rows);
  return Eigen::Map<const RowMajor>(numbers.data(), r, c);
}

Eigen::MatrixXd state_matrix(const RestPoint& point) {
  const std::size_t n = point.state.v.size();
  const auto size = static_cast<Eigen::Index>(n);
  const Eigen::PartialPivLU<Eigen::MatrixXd> mass(matrix_of(point.mass, n));
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * size, 2 * size);
  a.topRightCorner(size, size).setIdentity();
  a.bottomLeftCorner(size, size) = -mass.solve(matrix_of(point.stiffness, n));
  a.bottomRightCorner(size, size) = -mass.solve(matrix_of(point.damping, n));
  return a;
}

}  // namespace elgen
