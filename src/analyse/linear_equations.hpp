// Linear equations: M x'' + D x' + K x = B du about a point of rest as matrices of doubles.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "elgen/analyse.hpp"

namespace elgen {

/// Row-major numbers, nearest doubles.
[[nodiscard]] std::vector<double> doubles_of(const std::vector<cln::cl_R>& values);

/// Row-major numbers in so many rows.
[[nodiscard]] Eigen::MatrixXd matrix_of(const std::vector<cln::cl_R>& values, std::size_t rows);

/// [0 1; -K/M -D/M]; not finite where M is singular.
[[nodiscard]] Eigen::MatrixXd state_matrix(const RestPoint& point);

}  // namespace elgen
