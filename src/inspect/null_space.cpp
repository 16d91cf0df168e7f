// Null space: rows are scaled, then eliminated. Each column without a pivot gives a basis vector.
#include "inspect/null_space.hpp"

#include "numbers/echelon.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {

using cln::cl_R;

const cl_R& rounding_tolerance() {
  static const cl_R share = power_of_ten(-80);
  return share;
}

RealVector row_scales(const RealVector& matrix, std::size_t n) {
  RealVector scales(matrix.size() / n, cl_R(0));
  cl_R largest = 0;
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    scales[k / n] = cln::max(scales[k / n], cln::abs(matrix[k]));
    largest = cln::max(largest, scales[k / n]);
  }
  for (cl_R& scale : scales) {
    if (scale < rounding_tolerance() * largest) scale = 0;
  }
  return scales;
}

std::vector<RealVector> null_space(const RealVector& matrix, const RealVector& row_scales) {
  const std::size_t columns = matrix.size() / row_scales.size();
  RealVector scaled(matrix.size(), cl_R(0));
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    const cl_R& scale = row_scales[k / columns];
    if (!cln::zerop(scale)) scaled[k] = matrix[k] / scale;
  }
  using ScaledRows = LargestPivot<cl_R, EchelonForm::reduced>;
  ScaledRows field(power_of_ten(-50));  // 60 digits are correct; 10 of them may be lost
  return Echelon<ScaledRows>(field, scaled, columns, columns).kernel();
}

}  // namespace elgen
